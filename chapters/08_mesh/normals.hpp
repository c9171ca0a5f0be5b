// Lesson 08, step 6: normals at the points, so that a mesh of flat triangles looks like the smooth thing it stands for.
#pragma once
#include "chapters/08_mesh/mesh.hpp"

#include <array>
#include <cmath>

namespace course {

// The angle between two edges, in radians; exact enough for needles too.
inline double angle_between(const Vec<double> &p, const Vec<double> &q) {
    return std::atan2(length(cross(p, q)), dot(p, q));
}

// The mean of the normals of the triangles around each point, each weighted by its angle there (Thürmer and Wüthrich
// 1998): how a polygon was cut into triangles then makes no difference. 0 for a point without a triangle.
template <class S> std::vector<Vec<float>> normals_by_angle(const Mesh<S> &mesh) {
    std::vector<Vec<double>> sums(mesh.points.size(), Vec<double>(0));
    for (Id id = 0; id < size(mesh); ++id) {
        const Triangle<S> flat = triangle(mesh, id);
        const Vec<double> area = area_vector(flat);
        if (area == Vec<double>(0))
            continue;
        const std::array corners{Vec<double>(flat.a), Vec<double>(flat.b), Vec<double>(flat.c)};
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec<double> &here = corners[i], &next = corners[(i + 1) % 3], &last = corners[(i + 2) % 3];
            sums[mesh.indices[id][i]] += angle_between(next - here, last - here) * normalize(area);
        }
    }
    std::vector<Vec<float>> normals;
    normals.reserve(sums.size());
    for (const Vec<double> &sum : sums)
        normals.push_back(sum == Vec<double>(0) ? Vec<float>(0) : Vec<float>(normalize(sum)));
    return normals;
}

// The unit normal to shade with at a point of triangle `id`: the mean of its corners' normals, each weighted by the
// area of the triangle that the point forms with the other two corners. The flat normal for a mesh without normals.
template <class S> Vec<double> shading_normal(const Mesh<S> &mesh, Id id, const Vec<double> &point) {
    const Triangle<S> flat = triangle(mesh, id);
    const Vec<double> area = area_vector(flat);
    if (mesh.normals.empty())
        return normalize(area);
    const Vec<double> a = Vec<double>(flat.a) - point, b = Vec<double>(flat.b) - point, c = Vec<double>(flat.c) - point;
    const auto &[i, j, k] = mesh.indices[id];
    const Vec<double> mean = dot(cross(b, c), area) * Vec<double>(mesh.normals[i]) +
                             dot(cross(c, a), area) * Vec<double>(mesh.normals[j]) +
                             dot(cross(a, b), area) * Vec<double>(mesh.normals[k]);
    return dot(mean, mean) > 0 ? normalize(mean) : normalize(area);
}

} // namespace course
