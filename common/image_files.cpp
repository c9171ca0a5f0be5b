#include "common/image_files.hpp"

#include "common/errors.hpp"
#include "common/image_library.hpp"
#include "common/output_files.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <dlfcn.h>
#include <string>
#include <vector>

namespace course {
namespace {

constexpr std::array eight_bit_endings{".png", ".jpg", ".jpeg"};
constexpr std::array float_endings{".exr", ".hdr"};

bool ends_with_any(const std::filesystem::path &file, const auto &endings) {
    return std::ranges::find(endings, file.extension().string()) != endings.end();
}

const ImageLibrary &load_image_library() {
    void *const library = dlopen(COURSE_IMAGE_LIBRARY, RTLD_LAZY | RTLD_LOCAL);
    void *const functions = library ? dlsym(library, "course_image_library") : nullptr;
    if (!functions)
        throw InputError(COURSE_IMAGE_LIBRARY, std::string("cannot be loaded (") + dlerror() + ")");
    return *static_cast<const ImageLibrary *>(functions);
}

const ImageLibrary &image_library() {
    static const ImageLibrary &library = load_image_library();
    return library;
}

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
    Picture picture;
    bool linear = false;
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) // some names mean a made-up picture to the library
        throw InputError(file.string(), "no such file");
    if (const std::string wrong = image_library().read(file.string(), picture, linear); !wrong.empty())
        throw InputError(file.string(), wrong);
    if (!linear)
        for (Colour &value : picture.pixels)
            value = Colour(linear_from_srgb(value.r), linear_from_srgb(value.g), linear_from_srgb(value.b));
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
        const std::string wrong =
            image_library().write(beside.string(), file.filename().string(), picture, bytes);
        if (!wrong.empty())
            throw InputError(file.string(), wrong);
    });
}

} // namespace course
