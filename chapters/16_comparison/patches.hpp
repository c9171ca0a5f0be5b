// Lesson 16, step 3: the brush that the procedural scenes are painted with.
#pragma once
#include "chapters/08_mesh/mesh.hpp"

#include <cmath>
#include <vector>

namespace course {

using Triangles = std::vector<Triangle<>>;

inline void append(Triangles &to, const Triangles &more) { to.insert(to.end(), more.begin(), more.end()); }

// Corners counter-clockwise as seen from the front.
inline void add_quad(Triangles &to, const Vec<float> &a, const Vec<float> &b, const Vec<float> &c,
                     const Vec<float> &d) {
    to.push_back({a, b, c});
    to.push_back({a, c, d});
}

// The surface place(u, v) over the unit square, cut into columns x rows quads. Its front is where u × v points.
template <class Place> void add_patch(Triangles &to, int columns, int rows, Place &&place) {
    const auto corner = [&](int i, int j) {
        return Vec<float>(place(static_cast<double>(i) / columns, static_cast<double>(j) / rows));
    };
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i)
            add_quad(to, corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1));
}

// The unit vector at longitude 2 pi u around the z axis.
inline Vec<double> around_z(double u) { return {std::cos(2 * pi * u), std::sin(2 * pi * u), 0}; }

// Two unit vectors that with the unit vector w form a right-handed frame u, v, w.
struct AxisFrame {
    Vec<double> u, v, w;

    explicit AxisFrame(const Vec<double> &axis) : w(axis) {
        u = normalize(cross(std::abs(w.x) < 0.6 ? Vec<double>(1, 0, 0) : Vec<double>(0, 1, 0), w));
        v = cross(w, u);
    }
    Vec<double> operator()(const Vec<double> &local) const { return local.x * u + local.y * v + local.z * w; }
};

// The side of a cone that is cut off at both ends, or of a cylinder, with its front outside.
inline void add_cone(Triangles &to, int columns, int rows, const Vec<double> &from, double from_radius,
                     const Vec<double> &up, double up_radius) {
    const AxisFrame frame(normalize(up - from));
    add_patch(to, columns, rows, [&](double u, double v) {
        return from + v * (up - from) + (from_radius + v * (up_radius - from_radius)) * frame(around_z(u));
    });
}

inline void add_sphere(Triangles &to, int columns, int rows, const Vec<double> &centre, double radius) {
    add_patch(to, columns, rows, [&](double u, double v) {
        const double latitude = pi * (v - 0.5);
        return centre + radius * (std::cos(latitude) * around_z(u) + std::sin(latitude) * Vec<double>(0, 0, 1));
    });
}

inline void add_box(Triangles &to, const Vec<double> &lo, const Vec<double> &hi) {
    for (int axis = 0; axis < 3; ++axis)
        for (const bool high : {false, true}) {
            Vec<double> u(0), v(0);
            u[(axis + 1) % 3] = hi[(axis + 1) % 3] - lo[(axis + 1) % 3];
            v[(axis + 2) % 3] = hi[(axis + 2) % 3] - lo[(axis + 2) % 3];
            Vec<double> corner = lo;
            corner[axis] = high ? hi[axis] : lo[axis];
            if (!high)
                std::swap(u, v);
            add_patch(to, 1, 1, [&](double s, double t) { return corner + s * u + t * v; });
        }
}

} // namespace course
