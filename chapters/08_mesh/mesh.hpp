// Lesson 08, step 5: many triangles that share their points.
#pragma once
#include "chapters/03_light_and_shadow/any_hit.hpp"
#include "chapters/08_mesh/triangle.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace course {

// Triangle `id` has the corners points[indices[id][0..2]]. With normals, one per point, the surface can be shaded as if
// it were smooth; without, every triangle is flat.
template <class S = float> struct Mesh {
    std::vector<Vec<S>> points;
    std::vector<std::array<std::uint32_t, 3>> indices;
    std::vector<Vec<float>> normals = {};
};

template <class S> Triangle<S> triangle(const Mesh<S> &mesh, Id id) {
    const auto &[a, b, c] = mesh.indices[id];
    return {mesh.points[a], mesh.points[b], mesh.points[c]};
}

// All triangles in the order of their ids: what an acceleration structure is built of. Its ids are the mesh's.
template <class S> std::vector<Triangle<S>> triangles(const Mesh<S> &mesh) {
    std::vector<Triangle<S>> all;
    all.reserve(mesh.indices.size());
    for (Id id = 0; id < mesh.indices.size(); ++id)
        all.push_back(triangle(mesh, id));
    return all;
}

template <class S> Id size(const Mesh<S> &mesh) { return static_cast<Id>(mesh.indices.size()); }

// Brute force: every triangle is asked. Chapters 09 to 15 are about not doing that.
template <class R, class S> Hit<typename R::Scalar> closest_hit(const R &any_ray, const Mesh<S> &mesh) {
    auto ray = with_shear(any_ray);
    Hit<typename R::Scalar> best;
    for (Id id = 0; id < size(mesh); ++id)
        closest_of(ray, triangle(mesh, id), id, best);
    return best;
}

template <class R, class S> bool any_hit(const R &any_ray, const Mesh<S> &mesh) {
    const auto ray = with_shear(any_ray);
    for (Id id = 0; id < size(mesh); ++id)
        if (any_hit(ray, triangle(mesh, id)))
            return true;
    return false;
}

// The surface is the flat triangle's, and its id says which one: what the mesh knows about it, such as its smooth
// normal, is looked up by that id. A structure over triangles(mesh) has the same ids.
template <class R, class S, class F, class... Context>
auto with_hit(const R &ray, const Hit<typename R::Scalar> &hit, const Mesh<S> &mesh, F &&f, const Context &...context) {
    const Triangle<S> flat = triangle(mesh, hit.id);
    auto found = surface(ray, hit.t, flat);
    found.id = hit.id;
    return f(found, context...);
}

} // namespace course
