// The rows of the mesh triangle's table.
#pragma once
#include "tests/hard_cases/suite.hpp"
#include "tests/oracle/shapes.hpp"

namespace course::hard {

inline std::vector<Kernel<Triangle<>>> triangle_kernels() {
    const auto standard = [](const auto &ray, const auto &triangle) { return intersect(ray, triangle); };
    return {kernel<float, Triangle<>>("watertight", standard, true),
            kernel<double, Triangle<>>("watertight", standard, true)};
}

} // namespace course::hard
