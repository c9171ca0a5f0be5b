// The scene of lessons 03 and 04: a sundial and its company, one of each primitive, late in the afternoon.
#pragma once
#include "chapters/03_light_and_shadow/light.hpp"
#include "chapters/03_light_and_shadow/material.hpp"
#include "chapters/03_light_and_shadow/object.hpp"
#include "common/viewpoint.hpp"

namespace course {

template <class Shape> using DiffuseList = std::vector<Object<Shape, Diffuse<>>>;

using SundialScene = Scene<Object<Plane<>, Diffuse<>>, Object<Sphere<>, Diffuse<>>, Object<Cylinder<>, Diffuse<>>,
                           Object<Disk<>, Diffuse<>>, Object<Cone<>, Diffuse<>>, Object<Box<>, Diffuse<>>,
                           Object<AffineTriangle<>, Diffuse<>>>;

inline SundialScene sundial_scene() {
    const Diffuse<> sand{{0.62f, 0.52f, 0.40f}}, stone{{0.72f, 0.68f, 0.60f}}, bronze{{0.16f, 0.38f, 0.36f}},
        slate{{0.30f, 0.29f, 0.30f}}, red{{0.78f, 0.16f, 0.10f}}, gold{{0.85f, 0.58f, 0.16f}},
        blue{{0.13f, 0.27f, 0.55f}};
    DiffuseList<Plane<>> ground{{{{0, 0, 0}, {0, 1, 0}}, sand}};
    DiffuseList<Sphere<>> spheres;
    DiffuseList<Cylinder<>> cylinders;
    DiffuseList<Disk<>> disks;
    DiffuseList<Cone<>> cones;
    DiffuseList<Box<>> boxes;
    DiffuseList<AffineTriangle<>> triangles;

    // Round steps, each a cylinder with a disk on top, and the dial.
    const auto drum = [&](const Vec<float> &bottom, float radius, float height, const Diffuse<> &material) {
        const Vec<float> top = bottom + Vec<float>(0, height, 0);
        cylinders.push_back({{bottom, top, radius}, material});
        disks.push_back({{top, {0, 1, 0}, radius}, material});
    };
    drum({0, 0, 0}, 3.1f, 0.05f, slate);
    drum({0, 0.05f, 0}, 2.15f, 0.22f, stone);
    drum({0, 0.27f, 0}, 1.75f, 0.22f, stone);
    drum({0, 0.49f, 0}, 1.4f, 0.12f, bronze);
    for (int hour = 0; hour < 12; ++hour) {
        const double angle = 2 * pi * (hour + 0.5) / 12;
        spheres.push_back({{Vec<float>(1.2 * std::cos(angle), 0.69, 1.2 * std::sin(angle)), 0.08f}, gold});
    }
    triangles.push_back(
        {affine_triangle<float>({0.55f, 0.61f, 0.75f}, {-0.35f, 0.61f, -0.6f}, {-0.35f, 2.1f, -0.6f}), red});

    // Columns on boxes, with a sphere on each.
    for (const Vec<float> &foot : {Vec<float>(-2.5f, 0, -1.9f), Vec<float>(0, 0, -2.9f), Vec<float>(2.5f, 0, -1.9f)}) {
        boxes.push_back({{foot - Vec<float>(0.42f, 0, 0.42f), foot + Vec<float>(0.42f, 0.4f, 0.42f)}, stone});
        drum(foot + Vec<float>(0, 0.4f, 0), 0.26f, 2.3f, stone);
        spheres.push_back({{foot + Vec<float>(0, 3.0f, 0), 0.3f}, gold});
    }
    cones.push_back({{{2.05f, 1.4f, 1.65f}, {2.05f, 0.05f, 1.65f}, 0.45f}, blue});
    spheres.push_back({{{-2.0f, 0.46f, 1.6f}, 0.41f}, red});
    return SundialScene(ground, spheres, cylinders, disks, cones, boxes, triangles);
}

inline const Viewpoint sundial_view{.eye = {0.9, 5.4, 9.6}, .target = {0.12, 0.95, -0.1}, .field_of_view = 36};

// The lamp: the white disk of an area light, or all its light from the one point in its middle.
inline const Disk<> lamp_disk{{-10.5f, 8.2f, -5.2f}, {8.0f, -10.0f, 0.5f}, 1.3f};
inline const Colour lamp_radiance = 140.0f * Colour(1.0f, 0.90f, 0.74f);

inline PointLight lamp_point() {
    const float area_over_pi = lamp_disk.radius * lamp_disk.radius;
    return {Vec<double>(lamp_disk.centre), area_over_pi * lamp_radiance};
}

// A second, weak light stands where the viewer does, so that its shadows hide behind what casts them.
inline PointLight fill_light() { return {sundial_view.eye, 15.0f * Colour(0.62f, 0.78f, 1.0f)}; }

} // namespace course
