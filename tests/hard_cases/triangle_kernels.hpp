// The rows of the mesh triangle's table.
#pragma once
#include "chapters/08_mesh/moller_trumbore.hpp"
#include "tests/hard_cases/suite.hpp"
#include "tests/oracle/shapes.hpp"

namespace course::hard {

inline std::vector<Kernel<Triangle<>>> triangle_kernels() {
    const auto strict = [](const auto &ray, const auto &triangle) { return moller_trumbore_strict(ray, triangle); };
    const auto closed = [](const auto &ray, const auto &triangle) { return moller_trumbore(ray, triangle); };
    const auto standard = [](const auto &ray, const auto &triangle) { return intersect(ray, triangle); };
    return {kernel<float, Triangle<>>("Moller-Trumbore as printed", strict),
            kernel<float, Triangle<>>("Moller-Trumbore", closed), kernel<double, Triangle<>>("Moller-Trumbore", closed),
            kernel<float, Triangle<>>("watertight", standard, true),
            kernel<double, Triangle<>>("watertight", standard, true)};
}

} // namespace course::hard
