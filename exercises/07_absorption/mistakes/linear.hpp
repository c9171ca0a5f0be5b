// Mistake: light is taken away in proportion to the way, so that some depth leaves less than nothing.
// Caught by: twice the way leaves the square
#pragma once
#include "exercises/07_absorption/task.hpp"

#include <cmath>

namespace course::exercise {

inline Colour light_left(const Ray<double> &ray, const std::vector<Layer> &layers) {
    const double unit = length(ray.direction);
    Colour left(1);
    double begin = 0;
    for (const Layer &layer : layers) {
        const auto thickness = static_cast<float>((layer.end - begin) * unit);
        for (int i = 0; i < 3; ++i)
            if (layer.absorption[i] > 0) // 0 times an endless way would be NaN
                left[i] *= 1 - layer.absorption[i] * thickness;
        begin = layer.end;
    }
    return left;
}

inline constexpr Task task{light_left};

} // namespace course::exercise
