// Lesson 15, step 2b: the ray, and the test of eight boxes at once.
#pragma once
#include "chapters/14_bvh/four.hpp"
#include "chapters/15_wide_bvh/lane_bits.hpp"
#include "chapters/15_wide_bvh/wide_node.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace course {

// A ray made ready, in float, for eight boxes or eight triangles at once. For boxes its axes are x, y and z; for
// triangles they are in chapter 08's order, the last one, z, being that along which it runs fastest.
class WideRay {
  public:
    // For triangles, by axis in chapter 08's order:
    const std::size_t *axes;       // which axis that is
    float origin[4], per_ahead[4]; // and by how much -x and -y change along z
    float ahead;                   // the sign of the direction along z
    float lost;                    // 9 times what rounding the origin took, in units of 2^-24, or more
    float z_per_t, t_per_z;        // from t_max below to a distance along z, and back; both rounded up
    // For boxes:
    float t_max;     // rounded up
    unsigned octant; // bit i: it runs backwards along axis i

    // `reach` is the largest coordinate of any box; `pad` a multiple of the derived one.
    template <class T> [[gnu::always_inline]] WideRay(const Ray<T> &ray, float reach, float pad = 1) {
        const Triple64 o = fetched(ray.origin), d = fetched(ray.direction), size = absolute(d);
        static constexpr unsigned fastest[8]{2, 0, 1, 0, 2, 2, 1, 2}; // by x > y, y > z, z > x
        const Order &order = orders[fastest[holding(size > second_first(size))]];
        axes = order.axes;
        const auto along = static_cast<double>((&ray.direction.x)[axes[2]]), length = std::abs(along);
        if (!(length > 0x1p-20 && length < 0x1p20)) [[unlikely]]
            unit_ = length > 0 && length < infinity<double> ? std::exp2(std::floor(std::log2(length))) : 1;
        t_max = rounded_up(static_cast<double>(ray.t_max));
        t_min_ = rounded_down(static_cast<double>(ray.t_min));
        octant = signs(d);

        const Triple32 place = narrowed(o), far = absolute(place);
        const float farthest = std::max({far[0], far[1], far[2]});
        lost = holding(widened(place) != o) == 0 ? 0 : 9 * farthest;
        prepare_boxes(narrowed(unit_ == 1 ? d : d / unit_), place, reach, pad * 0x1p-21f * (farthest + reach));

        const double per_along = 1 / along;
        store(origin, picked(place, order.places));
        store(per_ahead, picked(narrowed(d * -per_along), order.places));
        keep_in_memory(origin);
        keep_in_memory(per_ahead);
        ahead = along < 0 ? -1.0f : 1.0f;
        z_per_t = static_cast<float>(length / unit_) * (1 + 0x1p-22f);
        t_per_z = static_cast<float>(unit_ * std::abs(per_along)) * (1 + 0x1p-22f);
    }

    // A t of the ray as this class counts it: in a unit that lets it fit into a float whatever the direction's length.
    float rounded_up(double t) const { return static_cast<float>(t * unit_) * (1 + 0x1p-22f); }
    float rounded_down(double t) const { return static_cast<float>(t * unit_) * (1 - 0x1p-22f); }

    // When the ray enters each child's box, and when it leaves it or reaches t_max: it meets the box if not before.
    struct Entries {
        Floats enter, exit;
        unsigned met() const { return at_most((Ints)enter, (Ints)exit); } // a bit for each box
    };
    [[gnu::always_inline]] Entries operator()(const WideNode &node, float by) const {
        const float *planes = node.planes[0][0];
        Floats near[3], far[3];
        for (const auto i : {0, 1, 2}) {
            near[i] = fused(load(planes + near_[i]), inverse_[i], near_shift_[i]);
            far[i] = fused(load(planes + far_[i]), inverse_[i], far_shift_[i]);
        }
        const Floats enter = later(later(near[0], near[1]), later(near[2], all(t_min_)));
        const Floats exit = sooner(sooner(far[0], far[1]), sooner(far[2], all(by)));
        return {enter, exit};
    }

  private:
    struct Order {
        std::size_t axes[3];
        FourInts places;
    };
    static constexpr Order orders[3]{{{1, 2, 0}, {1, 2, 0, 3}}, {{2, 0, 1}, {2, 0, 1, 3}}, {{0, 1, 2}, {0, 1, 2, 3}}};

    template <class T> static Triple64 fetched(const Vec<T> &v) {
        return Triple64{fetched_alone(static_cast<double>(v.x)), fetched_alone(static_cast<double>(v.y)),
                        fetched_alone(static_cast<double>(v.z)), 0};
    }

    // A plane at x is met at x * inverse + shift; the margin lets it be entered earlier and left later. An axis along
    // which such numbers would not fit into a float leaves nothing out.
    [[gnu::always_inline]] void prepare_boxes(Triple32 d, Triple32 o, float reach, float margin) {
        const Triple32 size = absolute(d), least = Triple32{} + 0x1p-70f;
        const Triple32 per_unit = 1 / (size > least ? size : least), pad = margin * per_unit;
        const auto inverse = (Triple32)((TripleInts)per_unit | ((TripleInts)d & INT32_MIN));
        const Triple32 shift = -o * inverse;
        const TripleInts fits = absolute(shift) + (reach * per_unit + pad) < 0x1p126f;
        float of[3][4];
        store(of[0], (TripleInts)inverse & fits);
        store(of[1], (TripleInts)(shift - pad) & fits);
        store(of[2], fits ? shift + pad : Triple32{} + std::numeric_limits<float>::max());
        keep_in_memory(of);
        for (const auto i : {0u, 1u, 2u}) {
            const unsigned back = octant >> i & 1;
            near_[i] = lanes * (2 * i + back);
            far_[i] = lanes * (2 * i + 1 - back);
            inverse_[i] = all(of[0][i]), near_shift_[i] = all(of[1][i]), far_shift_[i] = all(of[2][i]);
        }
    }

    double unit_ = 1;
    float t_min_;
    Floats inverse_[3], near_shift_[3], far_shift_[3];
    std::size_t near_[3], far_[3]; // where the planes of each axis lie in a node
};

} // namespace course
