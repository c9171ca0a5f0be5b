#include "common/image_difference.hpp"

#include "common/errors.hpp"
#include "common/image_files.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace course {
namespace {

double distance(float a, float b) {
    if (a == b || (std::isnan(a) && std::isnan(b)))
        return 0;
    const double apart = std::abs(static_cast<double>(a) - static_cast<double>(b));
    return std::isfinite(apart) ? apart : std::numeric_limits<double>::infinity();
}

float encoded(float linear) { return std::isnan(linear) ? linear : srgb_from_linear(std::clamp(linear, 0.0f, 1.0f)); }

void require_same_size(const Picture &a, const Picture &b) {
    const auto size = [](const Picture &p) { return std::to_string(p.width) + " x " + std::to_string(p.height); };
    if (a.width != b.width || a.height != b.height)
        throw InputError("the pictures differ in size", size(a) + " against " + size(b));
}

} // namespace

ImageDifference difference(const Picture &a, const Picture &b, double steps) {
    require_same_size(a, b);
    ImageDifference result;
    double squares = 0, squares_steps = 0;
    std::size_t differing = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        double furthest = 0;
        for (int channel = 0; channel < 3; ++channel) {
            const float va = a.pixels[i][channel], vb = b.pixels[i][channel];
            const double linear = distance(va, vb), in_steps = 255 * distance(encoded(va), encoded(vb));
            squares += linear * linear;
            squares_steps += in_steps * in_steps;
            result.largest = std::max(result.largest, linear);
            furthest = std::max(furthest, in_steps);
        }
        result.largest_steps = std::max(result.largest_steps, furthest);
        differing += furthest > steps;
    }
    if (const double pixels = static_cast<double>(a.pixels.size()); pixels > 0) {
        result.rmse = std::sqrt(squares / (3 * pixels));
        result.rmse_steps = std::sqrt(squares_steps / (3 * pixels));
        result.differing_per_million = 1e6 * static_cast<double>(differing) / pixels;
    }
    return result;
}

Picture difference_picture(const Picture &a, const Picture &b, float gain) {
    require_same_size(a, b);
    Picture shown(a.width, a.height);
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
        for (int channel = 0; channel < 3; ++channel) {
            const double apart = distance(encoded(a.pixels[i][channel]), encoded(b.pixels[i][channel]));
            shown.pixels[i][channel] = linear_from_srgb(std::min(1.0f, gain * static_cast<float>(apart)));
        }
    return shown;
}

} // namespace course
