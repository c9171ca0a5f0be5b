// Reading and writing pictures (OpenImageIO, in image_library.cpp alone).
#pragma once
#include "common/image.hpp"

#include <cstdint>
#include <filesystem>

namespace course {

// The picture in the file, as linear RGB: 8- and 16-bit formats are taken as sRGB-encoded, float formats as linear.
// Grey is spread over three channels, alpha is dropped. Throws InputError naming the file.
Picture read_image(const std::filesystem::path &file);

// Writes .png and .jpg sRGB-encoded in 8 bits, .exr and .hdr linear in float. The file appears whole or not at all:
// it is written beside its place and renamed. Throws InputError naming the file.
void write_image(const std::filesystem::path &file, const Picture &picture);

// Throws InputError unless write_image could write there: a known ending, and a folder that exists or can be made.
// Programs ask before they render, so that a long job does not end in a file that cannot be written.
void require_writable_image(const std::filesystem::path &file);

// The sRGB transfer curve (IEC 61966-2-1), linear to encoded and back, one channel in [0, 1].
float srgb_from_linear(float linear);
float linear_from_srgb(float encoded);

// The byte of a PNG file, and of a window, for one linear channel: clipped to [0, 1], encoded, rounded. NaN is 0.
std::uint8_t srgb_byte(float linear);

} // namespace course
