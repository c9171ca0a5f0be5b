#include "common/image_library.hpp"

#include <OpenImageIO/imageio.h>

namespace course {
namespace {

constexpr OIIO::imagesize_t most_pixels = 1 << 28;

std::string read(const std::string &file, Picture &picture, bool &linear) {
    const auto input = OIIO::ImageInput::open(file);
    if (!input)
        return "not a readable picture (" + OIIO::geterror() + ")";
    const OIIO::ImageSpec &spec = input->spec();
    // A few bytes may claim any size: nothing is believed before it is looked at.
    if (spec.width < 1 || spec.height < 1 || spec.depth > 1 || spec.nchannels < 1 || spec.nchannels > 64 ||
        spec.image_pixels() > most_pixels)
        return "the picture has an impossible size";
    std::vector<float> values(spec.image_pixels() * static_cast<std::size_t>(spec.nchannels));
    if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, values.data()))
        return "the picture is damaged (" + input->geterror() + ")";

    picture = Picture(spec.width, spec.height);
    linear = spec.format.is_floating_point();
    const int green = spec.nchannels >= 3 ? 1 : 0, blue = spec.nchannels >= 3 ? 2 : 0;
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        const float *v = &values[i * static_cast<std::size_t>(spec.nchannels)];
        picture.pixels[i] = Colour(v[0], v[green], v[blue]);
    }
    return {};
}

std::string write(const std::string &file, const std::string &name, const Picture &picture,
                  const std::vector<std::uint8_t> &bytes) {
    const bool encoded = !bytes.empty();
    const auto output = OIIO::ImageOutput::create(name);
    OIIO::ImageSpec spec(picture.width, picture.height, 3, encoded ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::FLOAT);
    spec["oiio:ColorSpace"] = encoded ? "sRGB" : "Linear";
    if (!output)
        return "cannot be written (" + OIIO::geterror() + ")";
    const bool written = output->open(file, spec) &&
                         (encoded ? output->write_image(OIIO::TypeDesc::UINT8, bytes.data())
                                  : output->write_image(OIIO::TypeDesc::FLOAT, picture.pixels.data())) &&
                         output->close();
    return written ? std::string() : "cannot be written (" + output->geterror() + ")";
}

} // namespace

extern "C" const ImageLibrary course_image_library{read, write};

} // namespace course
