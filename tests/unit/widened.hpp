// The same scene with every shape stored in double: the reference that a picture is held against. Each number is the
// float's, so that the two scenes are one and differ only in what the program does with them.
#pragma once
#include "chapters/01_ray_casting/sphere.hpp"
#include "chapters/02_primitives/affine_triangle.hpp"
#include "chapters/02_primitives/box.hpp"
#include "chapters/02_primitives/cone.hpp"
#include "chapters/02_primitives/cylinder.hpp"
#include "chapters/02_primitives/disk.hpp"
#include "chapters/03_light_and_shadow/object.hpp"

namespace course {

inline Sphere<double> widened(const Sphere<> &s) { return {Vec<double>(s.centre), s.radius}; }
inline Plane<double> widened(const Plane<> &p) { return {Vec<double>(p.point), Vec<double>(p.normal)}; }
inline Disk<double> widened(const Disk<> &d) { return {Vec<double>(d.centre), Vec<double>(d.normal), d.radius}; }
inline AffineTriangle<double> widened(const AffineTriangle<> &t) {
    return {Vec<double>(t.corner), Vec<double>(t.normal), Vec<double>(t.k1), Vec<double>(t.k2)};
}
inline Cylinder<double> widened(const Cylinder<> &c) { return {Vec<double>(c.bottom), Vec<double>(c.top), c.radius}; }
inline Cone<double> widened(const Cone<> &c) { return {Vec<double>(c.apex), Vec<double>(c.base), c.radius}; }
inline Box<double> widened(const Box<> &b) { return {Vec<double>(b.lo), Vec<double>(b.hi)}; }

template <class Shape, class Material> auto widened(const Object<Shape, Material> &object) {
    return Object<decltype(widened(object.shape)), Material>{widened(object.shape), object.material};
}

template <class... Shapes> auto widened(const Scene<Shapes...> &scene) {
    const auto widened_list = [](const auto &list) {
        std::vector<decltype(widened(list.front()))> result;
        for (const auto &shape : list)
            result.push_back(widened(shape));
        return result;
    };
    return std::apply([&](const auto &...lists) { return Scene(widened_list(lists)...); }, scene.shapes);
}

} // namespace course
