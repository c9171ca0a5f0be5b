// How far two pictures are apart: for golden pictures, and for comparing one renderer with another.
#pragma once
#include "common/image.hpp"

namespace course {

struct ImageDifference {
    double rmse = 0, largest = 0;             // over all channels, linear
    double rmse_steps = 0, largest_steps = 0; // the same of the sRGB-encoded values, in steps of 1/255, before rounding
    double differing_per_million = 0;         // pixels with a channel that is further apart than the given steps
};

// A value that is not finite in just one of the pictures is infinitely far; the same one in both is no difference.
// Encoded values are clamped to [0, 1], as a PNG holds them; linear ones are not. A pixel counts as differing when a
// channel's encoded values lie more than `steps` apart. Throws InputError when the sizes differ.
ImageDifference difference(const Picture &, const Picture &, double steps = 1);

// Where they differ: each channel's distance of the encoded values, times `gain`.
Picture difference_picture(const Picture &, const Picture &, float gain = 8);

} // namespace course
