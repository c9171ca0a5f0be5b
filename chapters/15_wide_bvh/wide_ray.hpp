// Lesson 15, step 2b: the ray, and the test of eight boxes at once.
#pragma once
#include "chapters/08_mesh/shear.hpp"
#include "chapters/15_wide_bvh/wide_node.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace course {

// A ray made ready, in float, for eight boxes or eight triangles at once. Its axes are in chapter 08's order: along the
// last one, z, it runs fastest. Its t counts in units of z, so that it fits into a float whatever the direction's
// length.
struct WideRay {
    std::size_t rows[3]; // where the coordinates of each axis lie among a leaf's corners
    float origin[3];
    float x_per_z, y_per_z, ahead; // -dx / dz, -dy / dz, and the sign of dz
    float lost;                    // 9 times what rounding the origin took, in units of 2^-24
    float t_max;                   // rounded up
    unsigned octant = 0;

    // `reach` is the largest coordinate of any box; `pad` a multiple of the derived one.
    template <class T> [[gnu::always_inline]] WideRay(const Shear &shear, const Ray<T> &ray, float reach, float pad = 1)
        : t_max(scaled(static_cast<double>(ray.t_max), std::abs(shear.along()))), scale_(std::abs(shear.along())),
          t_min_(all(static_cast<float>(static_cast<double>(ray.t_min) * scale_) * (1 - 0x1p-22f))) {
        const Vec<int> axes = shear.axes();
        const double o[3] = {shear.origin().x, shear.origin().y, shear.origin().z};
        const double d[3] = {shear.direction().x, shear.direction().y, shear.direction().z};
        const double per_z = 1 / d[2];
        x_per_z = static_cast<float>(-d[0] * per_z), y_per_z = static_cast<float>(-d[1] * per_z);
        ahead = std::copysign(1.0f, static_cast<float>(d[2]));
        double off = 0;
        float place = 0;
        for (const auto i : {0, 1, 2}) {
            origin[i] = static_cast<float>(o[i]);
            off = std::max(off, std::abs(o[i] - static_cast<double>(origin[i])));
            place = std::max(place, std::abs(origin[i]));
        }
        lost = static_cast<float>(9 * 0x1p24 * off);
        const float margin = pad * 0x1p-21f * (place + reach);
        set_axis(0, axes.x, d[0], margin);
        set_axis(1, axes.y, d[1], margin);
        set_axis(2, axes.z, d[2], margin);
    }

    // A t of the ray as this class counts it, rounded up.
    float scaled(double t) const { return scaled(t, scale_); }

    // When the ray enters each child's box, and which of the boxes it meets by t_max: a bit for each.
    struct Entries {
        Floats enter;
        unsigned met;
    };
    [[gnu::always_inline]] Entries operator()(const WideNode &node, float by) const {
        const float *planes = node.planes[0][0];
        Floats near[3], far[3];
        for (const auto i : {0, 1, 2}) {
            near[i] = fused(load(planes + near_[i]), inverse_[i], near_shift_[i]);
            far[i] = fused(load(planes + far_[i]), inverse_[i], far_shift_[i]);
        }
        const Floats enter = larger(larger(near[0], near[1]), larger(near[2], t_min_));
        const Floats exit = smaller(smaller(far[0], far[1]), smaller(far[2], all(by)));
        return {enter, ~above(enter, exit) & 255};
    }

  private:
    static float scaled(double t, double scale) { return static_cast<float>(t * scale) * (1 + 0x1p-22f); }

    // A plane at x is met at x * inverse + shift; the margin lets it be entered earlier and left later.
    [[gnu::always_inline]] void set_axis(unsigned i, int axis_number, double direction, float margin) {
        const unsigned backwards = std::signbit(direction);
        const auto axis = static_cast<unsigned>(axis_number);
        rows[i] = lanes * axis;
        near_[i] = lanes * (2 * axis + backwards);
        far_[i] = lanes * (2 * axis + 1 - backwards);
        octant |= backwards << axis;
        const auto per_unit = static_cast<float>(scale_ / std::abs(direction));
        const float size = per_unit < 0x1p30f ? per_unit : 0x1p30f; // no 0 * infinity
        const float inverse = std::copysign(size, static_cast<float>(direction)), shift = -origin[i] * inverse;
        inverse_[i] = all(inverse);
        near_shift_[i] = all(shift - margin * size);
        far_shift_[i] = all(shift + margin * size);
    }

    double scale_;
    std::size_t near_[3], far_[3]; // where the planes of each axis lie in a node
    Floats t_min_, inverse_[3], near_shift_[3], far_shift_[3];
};

} // namespace course
