// Lesson 15, step 8: eight rays side by side, one in each lane, and all that lies between them.
#pragma once
#include "chapters/09_aabb/bounds.hpp"
#include "chapters/15_wide_bvh/wide_node.hpp"

#include <span>

namespace course {

// Eight rays side by side, made ready for boxes as WideRay makes one ready. Lanes without a ray repeat the first.
class RayLanes {
  public:
    RayLanes(std::span<const Ray<double>> rays, const Box<float> &reach, float pad) {
        alignas(64) double o[3][lanes], d[3][lanes], from[lanes], to[lanes];
        for (std::size_t i = 0; i < lanes; ++i) {
            const Ray<double> &ray = rays[i < rays.size() ? i : 0];
            for (int axis = 0; axis < 3; ++axis) {
                o[axis][i] = (&ray.origin.x)[axis];
                d[axis][i] = (&ray.direction.x)[axis];
            }
            from[i] = ray.t_min;
            to[i] = ray.t_max;
        }
        const auto row = [](const double(&numbers)[lanes]) { return load<Doubles>(numbers); };
        const Doubles origin[] = {row(o[0]), row(o[1]), row(o[2])};
        const Doubles direction[] = {row(d[0]), row(d[1]), row(d[2])};
        const Doubles scale = largest(absolute(direction[0]), absolute(direction[1]), absolute(direction[2]));
        const Doubles place = largest(absolute(origin[0]), absolute(origin[1]), absolute(origin[2]));
        const Doubles margin = static_cast<double>(pad) * 0x1p-21 * (place + largest_coordinate(reach));
        const Doubles least = 0x1p-30 * scale;
        for (int axis = 0; axis < 3; ++axis) {
            const Doubles size = absolute(direction[axis]), along = size > least ? size : least;
            const Doubles slope = turned(scale / along, direction[axis]), ahead = turned(margin, direction[axis]);
            inverse[axis] = narrowed(slope);
            near_origin[axis] = narrowed(origin[axis] + ahead);
            far_origin[axis] = narrowed(origin[axis] - ahead);
            near_shift[axis] = narrowed(-(origin[axis] + ahead) * slope);
            far_shift[axis] = narrowed(-(origin[axis] - ahead) * slope);
            backwards[axis] = signs(direction[axis]);
        }
        t_min = narrowed(row(from) * scale) * (1 - 0x1p-22f);
        t_max = narrowed(row(to) * scale) * (1 + 0x1p-22f);
    }

    // Which rays meet this child's box: a bit for each.
    unsigned meeting(const WideNode &node, unsigned child, unsigned octant) const {
        Floats enter = t_min, exit = t_max;
        for (unsigned axis = 0; axis < 3; ++axis) {
            const unsigned back = octant >> axis & 1;
            const float near = node.planes[axis][back][child], far = node.planes[axis][1 - back][child];
            enter = larger(fused(all(near), inverse[axis], near_shift[axis]), enter);
            exit = smaller(fused(all(far), inverse[axis], far_shift[axis]), exit);
        }
        return ~above(enter, exit) & 255;
    }

    // Bit i says whether the ray goes backwards along axis i.
    unsigned octant(unsigned lane) const {
        return (backwards[0] >> lane & 1) | (backwards[1] >> lane & 1) << 1 | (backwards[2] >> lane & 1) << 2;
    }
    // The rays of the same octant as this one.
    unsigned going_like(unsigned lane) const {
        unsigned bits = 255;
        for (const unsigned back : backwards)
            bits &= back >> lane & 1 ? back : ~back;
        return bits;
    }

    Floats inverse[3], near_origin[3], far_origin[3], near_shift[3], far_shift[3], t_min, t_max;
    unsigned backwards[3]; // a bit for each ray

  private:
    static Floats narrowed(Doubles a) { return __builtin_convertvector(a, Floats); }
    static Doubles turned(Doubles a, Doubles by) { return (Doubles)((Longs)a | ((Longs)by & INT64_MIN)); }
    static Doubles largest(Doubles a, Doubles b, Doubles c) {
        const Doubles ab = a > b ? a : b;
        return ab > c ? ab : c;
    }
};

// All that lies between rays of one octant. What it does not meet, none of them meets: it enters a box no later than
// the first of them and leaves it no earlier than the last. The rays' origins are already a margin apart, which is wide
// against the three roundings here (README.md).
class Beam {
  public:
    Beam(const RayLanes &rays, unsigned group) {
        const auto octant = rays.octant(static_cast<unsigned>(std::countr_zero(group)));
        for (unsigned axis = 0; axis < 3; ++axis) {
            const unsigned back = octant >> axis & 1;
            near_[axis] = lanes * (2 * axis + back);
            far_[axis] = lanes * (2 * axis + 1 - back);
            const auto [least, most] = range(rays.inverse[axis], group);
            least_[axis] = least;
            most_[axis] = most;
            const auto [near_low, near_high] = range(rays.near_origin[axis], group);
            const auto [far_low, far_high] = range(rays.far_origin[axis], group);
            near_origin_[axis] = back ? near_low : near_high; // the most advanced
            far_origin_[axis] = back ? far_high : far_low;
        }
        t_min_ = range(rays.t_min, group).first;
    }

    unsigned operator()(const WideNode &node, float t_max) const {
        const float *planes = node.planes[0][0];
        Floats enter = all(t_min_), exit = all(t_max);
        for (unsigned i = 0; i < 3; ++i) {
            const Floats near = load(planes + near_[i]) - all(near_origin_[i]);
            const Floats far = load(planes + far_[i]) - all(far_origin_[i]);
            enter = larger(smaller(near * all(least_[i]), near * all(most_[i])), enter);
            exit = smaller(larger(far * all(least_[i]), far * all(most_[i])), exit);
        }
        return ~above(enter, exit) & 255;
    }

  private:
    unsigned near_[3], far_[3];
    float least_[3], most_[3], near_origin_[3], far_origin_[3], t_min_;
};

} // namespace course
