// Lesson 13, step 1: a plane in any position, and what it does to polygons and to convex cells.
#pragma once
#include "chapters/09_aabb/bounds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace course {

// The points with normal · p = offset. The normal, of about length one, is kept in float; the offset is double, so that
// the plane passes through the point it was made for as closely as double can say, wherever the scene is.
struct SplitPlane {
    Vec<float> normal{0};
    double offset = 0;

    // How far the point lies in front (> 0) or behind (< 0).
    double height(const Vec<double> &point) const { return dot(Vec<double>(normal), point) - offset; }
};

// The plane through the point at right angles to a vector. Without a normal (all zeros) where the vector has no
// direction.
inline SplitPlane plane_across(const Vec<double> &vector, const Vec<double> &point) {
    const double size = length(vector);
    if (!(size > 0 && size < infinity<double>))
        return {};
    SplitPlane plane{Vec<float>(vector / size), 0};
    plane.offset = dot(Vec<double>(plane.normal), point);
    return plane;
}

// The corners of a convex polygon in their order. It may have shrunk to an edge or a point.
using Polygon = std::vector<Vec<double>>;

// The part of the polygon in front (side 1) or behind (side -1); on the plane counts to both.
inline Polygon part_of(const Polygon &polygon, const SplitPlane &plane, int side) {
    Polygon part;
    part.reserve(polygon.size() + 1);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec<double> &p = polygon[i], &q = polygon[i + 1 < polygon.size() ? i + 1 : 0];
        const double at_p = side * plane.height(p), at_q = side * plane.height(q);
        if (at_p >= 0)
            part.push_back(p);
        if (at_p > 0 && at_q < 0) // always from the kept end, so that two faces cut their common edge at one point
            part.push_back(p + at_p / (at_p - at_q) * (q - p));
        else if (at_p < 0 && at_q > 0)
            part.push_back(q + at_q / (at_q - at_p) * (p - q));
    }
    return part;
}

// The polygon's area times its normal.
inline Vec<double> vector_area(const Polygon &polygon) {
    Vec<double> sum(0);
    for (std::size_t i = 2; i < polygon.size(); ++i)
        sum += cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
    return 0.5 * sum;
}

// A convex cell: its faces, with their corners counter-clockwise as seen from outside.
struct Polytope {
    std::vector<Polygon> faces;

    double surface() const {
        double sum = 0;
        for (const Polygon &face : faces)
            sum += length(vector_area(face));
        return sum;
    }
};

inline Polytope polytope_of(const Box<double> &box) {
    Polytope result;
    for (int axis = 0; axis < 3; ++axis)
        for (const bool upper : {false, true}) {
            Polygon face;
            for (const int corner : {0, 1, 3, 2}) { // around the face
                Vec<double> p = box.lo;
                p[axis] = upper ? box.hi[axis] : box.lo[axis];
                const int u = (axis + 1) % 3, v = (axis + 2) % 3;
                p[u] = corner & 1 ? box.hi[u] : box.lo[u];
                p[v] = corner & 2 ? box.hi[v] : box.lo[v];
                face.push_back(p);
            }
            if (!upper)
                std::ranges::reverse(face);
            result.faces.push_back(face);
        }
    return result;
}

// vector_area(part_of(polygon, plane, 1)), without making the part.
inline Vec<double> vector_area_in_front(const Polygon &polygon, const SplitPlane &plane) {
    Vec<double> sum(0), first(0), previous(0);
    int corners = 0;
    const auto corner = [&](const Vec<double> &p) {
        if (corners++ == 0)
            first = p;
        sum += cross(previous - first, p - first);
        previous = p;
    };
    Vec<double> p = polygon.back();
    double at_p = plane.height(p);
    for (const Vec<double> &q : polygon) {
        const double at_q = plane.height(q);
        if ((at_p < 0) != (at_q < 0))
            corner(p + at_p / (at_p - at_q) * (q - p));
        if (at_q >= 0)
            corner(q);
        p = q;
        at_p = at_q;
    }
    return 0.5 * sum;
}

// The surfaces of the parts behind and in front. The new face need not be built for that: the vector areas of a closed
// surface add up to zero, so its own is what the other faces leave.
inline std::array<double, 2> surfaces_of_parts(const Polytope &cell, const SplitPlane &plane) {
    std::array<double, 2> surfaces{};
    Vec<double> sum(0);
    for (const Polygon &face : cell.faces) {
        const Vec<double> front = vector_area_in_front(face, plane);
        sum += front;
        surfaces[0] += length(vector_area(face) - front);
        surfaces[1] += length(front);
    }
    return {surfaces[0] + length(sum), surfaces[1] + length(sum)};
}

// The part of the cell in front (side 1) or behind (side -1). The new face has a corner wherever the plane cuts an
// edge; around their middle they are put in order by angle.
inline Polytope part_of(const Polytope &cell, const SplitPlane &plane, int side) {
    Polytope part;
    Polygon rim;
    for (const Polygon &face : cell.faces) {
        Polygon kept = part_of(face, plane, side);
        for (const Vec<double> &p : kept) // corners in the plane: new ones, and old ones through which it happens to go
            if (plane.height(p) == 0 || std::ranges::find(face, p) == face.end())
                rim.push_back(p);
        if (kept.size() > 2)
            part.faces.push_back(std::move(kept));
    }
    Vec<double> middle(0);
    for (const Vec<double> &p : rim)
        middle += p / static_cast<double>(rim.size());
    const Vec<double> out = static_cast<double>(-side) * Vec<double>(plane.normal);
    const Vec<double> u = normalize(cross(out, std::abs(out.x) < 0.5 ? Vec<double>(1, 0, 0) : Vec<double>(0, 1, 0)));
    const Vec<double> v = cross(out, u);
    const auto angle = [&](const Vec<double> &p) { return std::atan2(dot(p - middle, v), dot(p - middle, u)); };
    std::ranges::sort(rim, {}, angle);
    rim.erase(std::ranges::unique(rim).begin(), rim.end());
    if (rim.size() > 2)
        part.faces.push_back(std::move(rim));
    return part;
}

} // namespace course
