// Lesson 15, step 2c: the ray, made ready.
#pragma once
#include "chapters/14_bvh/four.hpp"
#include "chapters/15_wide_bvh/slabs.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace course {

// A ray made ready, in float, for eight boxes or eight triangles at once. For boxes its axes are x, y and z; for
// triangles they are in chapter 08's order, the last one, z, being that along which it runs fastest.
// In whole cache lines: a vector that was stored across two of them is slow to come back.
class alignas(64) WideRay {
  public:
    // For triangles, by axis in chapter 08's order:
    alignas(16) float origin[4], per_ahead[4]; // and by how much -x and -y change along z
    const std::size_t *axes;                   // which axis that is
    float along;                               // the direction along z, for its sign
    float lost;                                // 9 times what rounding the origin took, in units of 2^-24, or more
    float z_per_t, t_per_z;                    // from t_max below to a distance along z, and back; both rounded up
    // For boxes:
    Slabs<float> boxes;
    float t_max; // rounded up

    // `reach` is the largest coordinate of any box; `pad` a multiple of the derived one.
    template <class T> [[gnu::always_inline]] WideRay(const Ray<T> &ray, float reach, float pad = 1) {
        const Triple64 o = fetched(ray.origin), size = absolute(fetched(ray.direction));
        // By x > y, y > z, x > z: of axes along which it runs as fast, the same one as in chapter 08.
        static constexpr unsigned fastest[8]{2, 2, 1, 0, 2, 0, 1, 0};
        const Order &order = orders[fastest[holding(xyx(size) > yzz(size))]];
        axes = order.axes;
        Triple64 d = fetched(ray.direction);
        auto d_z = static_cast<double>((&ray.direction.x)[axes[2]]);
        if (!(std::abs(d_z) > 0x1p-20 && std::abs(d_z) < 0x1p20)) [[unlikely]] {
            unit_ = d_z != 0 && std::isfinite(d_z) ? std::exp2(std::floor(std::log2(std::abs(d_z)))) : 1;
            d /= unit_;
            d_z /= unit_;
        }
        t_max = rounded_up(static_cast<double>(ray.t_max));
        boxes.t_min = rounded_down(static_cast<double>(ray.t_min));
        boxes.octant = signs(d);
        boxes.sides = &sides_of_octants[boxes.octant];

        const Triple32 place = narrowed(o), far = absolute(place);
        const float farthest = std::max({far[0], far[1], far[2]});
        lost = holding(widened(place) != o) == 0 ? 0 : 9 * farthest;
        prepare_boxes(narrowed(d), place, reach, pad * 0x1p-21f * (farthest + reach));

        const double per_along = 1 / d_z;
        store(origin, picked(place, order.places));
        store(per_ahead, picked(narrowed(d * -per_along), order.places));
        keep_in_memory(origin);
        keep_in_memory(per_ahead);
        along = static_cast<float>(d_z);
        z_per_t = std::abs(along) * (1 + 0x1p-22f);
        t_per_z = std::abs(static_cast<float>(per_along)) * (1 + 0x1p-22f);
    }

    // A t of the ray as this class counts it: in a unit that lets it fit into a float whatever the direction's length.
    float rounded_up(double t) const { return static_cast<float>(t * unit_) * (1 + 0x1p-22f); }
    float rounded_down(double t) const { return static_cast<float>(t * unit_) * (1 - 0x1p-22f); }

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

    // An axis along which such numbers would not fit into a float leaves nothing out.
    [[gnu::always_inline]] void prepare_boxes(Triple32 d, Triple32 o, float reach, float margin) {
        const Triple32 size = larger(absolute(d), Triple32{} + 0x1p-70f), per_unit = 1 / size, pad = margin * per_unit;
        const auto inverse = (Triple32)((TripleInts)per_unit | ((TripleInts)d & INT32_MIN));
        const Triple32 shift = -o * inverse;
        const TripleInts fits = absolute(o) + (reach + margin) < 0x1p120f * size;
        store(boxes.inverse, fits ? inverse : Triple32{});
        store(boxes.near_shift, fits ? shift - pad : Triple32{});
        store(boxes.far_shift, fits ? shift + pad : Triple32{} + std::numeric_limits<float>::max());
        keep_in_memory(boxes.inverse);
        keep_in_memory(boxes.near_shift);
        keep_in_memory(boxes.far_shift);
    }

    double unit_ = 1;
};

} // namespace course
