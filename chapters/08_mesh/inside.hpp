// Lesson 08, step 7: inside or outside, by counting.
#pragma once
#include "chapters/08_mesh/mesh.hpp"

#include <cstdint>

namespace course {

// How many triangles the ray meets. `meets` is the test, so that the naive ones can be counted too.
template <class R, class S, class Meets> std::uint32_t count_hits(const R &ray, const Mesh<S> &mesh, Meets meets) {
    std::uint32_t hits = 0;
    for (Id id = 0; id < size(mesh); ++id)
        hits += meets(ray, triangle(mesh, id)) ? 1u : 0u;
    return hits;
}

template <class R, class S> std::uint32_t count_hits(const R &ray, const Mesh<S> &mesh) {
    return count_hits(with_shear(ray), mesh, [](const auto &r, const auto &flat) { return intersect(r, flat); });
}

// Whether the point lies inside a closed mesh: a ray that starts there then leaves it once more than it enters, so it
// meets an odd number of triangles, whatever its direction (B §3, C). A mesh with holes has no inside.
template <class S>
bool is_inside(const Mesh<S> &mesh, const Vec<double> &point, const Vec<double> &direction = {0.48, 0.6, 0.64}) {
    return count_hits(Ray<double>{point, direction}, mesh) % 2 == 1;
}

} // namespace course
