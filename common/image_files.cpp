#include "common/image_files.hpp"

#include "common/errors.hpp"
#include "common/output_files.hpp"

#include <OpenImageIO/imageio.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace course {
namespace {

constexpr std::array eight_bit_endings{".png", ".jpg", ".jpeg"};
constexpr std::array float_endings{".exr", ".hdr"};

bool ends_with_any(const std::filesystem::path &file, const auto &endings) {
    return std::ranges::find(endings, file.extension().string()) != endings.end();
}

bool is_linear_format(OIIO::TypeDesc format) { return format.is_floating_point(); }

} // namespace

float srgb_from_linear(float linear) {
    return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1 / 2.4f) - 0.055f;
}

float linear_from_srgb(float encoded) {
    return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

std::uint8_t srgb_byte(float linear) {
    const float clipped = linear > 0 ? std::min(linear, 1.0f) : 0.0f; // false for NaN
    return static_cast<std::uint8_t>(255 * srgb_from_linear(clipped) + 0.5f);
}

Picture read_image(const std::filesystem::path &file) {
    const auto input = OIIO::ImageInput::open(file.string());
    if (!input)
        throw InputError(file.string(), "not a readable picture (" + OIIO::geterror() + ")");
    const OIIO::ImageSpec &spec = input->spec();
    std::vector<float> values(spec.image_pixels() * static_cast<std::size_t>(spec.nchannels));
    if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, values.data()))
        throw InputError(file.string(), "the picture is damaged (" + input->geterror() + ")");

    Picture picture(spec.width, spec.height);
    const int green = spec.nchannels >= 3 ? 1 : 0, blue = spec.nchannels >= 3 ? 2 : 0;
    const bool linear = is_linear_format(spec.format);
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        const float *v = &values[i * static_cast<std::size_t>(spec.nchannels)];
        const Colour stored(v[0], v[green], v[blue]);
        picture.pixels[i] =
            linear ? stored
                   : Colour(linear_from_srgb(stored.r), linear_from_srgb(stored.g), linear_from_srgb(stored.b));
    }
    return picture;
}

void require_writable_image(const std::filesystem::path &file) {
    if (!ends_with_any(file, eight_bit_endings) && !ends_with_any(file, float_endings))
        throw InputError(file.string(), "pictures are written as .png, .jpg, .exr or .hdr");
    require_writable(file);
}

void write_image(const std::filesystem::path &file, const Picture &picture) {
    require_writable_image(file);
    const bool encode = ends_with_any(file, eight_bit_endings);
    std::vector<std::uint8_t> bytes;
    if (encode)
        for (const Colour &value : picture.pixels)
            for (int channel = 0; channel < 3; ++channel)
                bytes.push_back(srgb_byte(value[channel]));

    replace_file(file, [&](const std::filesystem::path &beside) {
        const auto output = OIIO::ImageOutput::create(file.filename().string());
        OIIO::ImageSpec spec(picture.width, picture.height, 3, encode ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::FLOAT);
        spec["oiio:ColorSpace"] = encode ? "sRGB" : "Linear";
        if (!output || !output->open(beside.string(), spec) ||
            !(encode ? output->write_image(OIIO::TypeDesc::UINT8, bytes.data())
                     : output->write_image(OIIO::TypeDesc::FLOAT, picture.pixels.data())) ||
            !output->close())
            throw InputError(file.string(), output ? output->geterror() : OIIO::geterror());
    });
}

} // namespace course
