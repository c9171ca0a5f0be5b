// Exercise 07, solved: what is left of light after its way through coloured glass.
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
                left[i] *= std::exp(-layer.absorption[i] * thickness);
        begin = layer.end;
    }
    return left;
}

inline constexpr Task task{light_left};

} // namespace course::exercise
