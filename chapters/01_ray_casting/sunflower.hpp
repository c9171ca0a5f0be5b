// Lesson 01: the scene of the picture.
#pragma once
#include "chapters/01_ray_casting/scene.hpp"
#include "chapters/01_ray_casting/sphere.hpp"
#include "common/viewpoint.hpp"

#include <cmath>
#include <utility>
#include <vector>

namespace course {

// Spheres on a sunflower spiral: each turns by the golden angle, so that no two rings line up.
inline Scene<Sphere<>> sunflower() {
    std::vector<Sphere<>> spheres;
    const double golden_angle = pi * (3 - std::sqrt(5.0));
    for (int i = 0; i < 260; ++i) {
        const double distance = 0.26 * std::sqrt(i + 0.5), angle = golden_angle * i;
        const double height = 1.15 * std::exp(-0.09 * distance * distance) + 0.16 * std::cos(2.6 * distance);
        spheres.push_back({{distance * std::cos(angle), height, distance * std::sin(angle)},
                           static_cast<float>(0.13 + 0.028 * distance)});
    }
    return Scene(std::move(spheres));
}

inline const Viewpoint sunflower_view{.eye = {0, 4.4, 7.2}, .target = {0, -0.25, 0}, .field_of_view = 46};

// Where the light of the experiment in forward.hpp comes from.
inline const Vec<double> sunflower_lamp(3, 6, 2);

} // namespace course
