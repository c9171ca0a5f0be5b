// Mistake: the whole way from the eye is counted in every layer, not the layer's own thickness.
// Caught by: each layer absorbs over its own thickness
#pragma once
#include "exercises/07_absorption/task.hpp"

#include <cmath>

namespace course::exercise {

inline Colour light_left(const Ray<double> &ray, const std::vector<Layer> &layers) {
    const double unit = length(ray.direction);
    Colour left(1);
    for (const Layer &layer : layers) {
        const auto thickness = static_cast<float>(layer.end * unit);
        for (int i = 0; i < 3; ++i)
            if (layer.absorption[i] > 0) // 0 times an endless way would be NaN
                left[i] *= std::exp(-layer.absorption[i] * thickness);
    }
    return left;
}

inline constexpr Task task{light_left};

} // namespace course::exercise
