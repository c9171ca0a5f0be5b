// Lesson 15, step 5b: of the few triangles that the ray may hit, the nearest, decided as chapter 08 decides.
#pragma once
#include "chapters/15_wide_bvh/triangle_list.hpp"

#include <algorithm>
#include <cmath>

namespace course {

// What can be said of one triangle before chapter 08 is asked.
struct Decided {
    double t;  // chapter 08's, if that is clear
    bool none; // no hit, since t <= 0
    bool clear;
};

// Chapter 08's watertight(), its three corners side by side: t is the same to the last bit, and clear if its
// confirmed_t() surely returns t as it is. README.md derives the bound.
template <WideOptions Options, class R, class Leaf>
[[gnu::always_inline]] inline Decided decide(const R &ray, const WideRay &wide, const Leaf &leaf, unsigned lane) {
    Triple32 corners[3]; // by axis in chapter 08's order
    double o[3], d[3];
    for (const auto i : {0, 1, 2}) {
        const std::size_t axis = wide.axes[i];
        corners[i] = Triple32{leaf.at(0, axis, lane), leaf.at(1, axis, lane), leaf.at(2, axis, lane), 0};
        o[i] = static_cast<double>((&ray.origin.x)[axis]);
        d[i] = static_cast<double>((&ray.direction.x)[axis]);
    }
    const Triple64 z = widened(corners[2]) - o[2], x = (widened(corners[0]) - o[0]) * d[2] - d[0] * z,
                   y = (widened(corners[1]) - o[1]) * d[2] - d[1] * z;
    const Triple64 edges = third_first(x) * second_first(y) - third_first(y) * second_first(x); // u, v and w
    const Triple64 depths = edges * z;
    const double area = edges[0] + edges[1] + edges[2], sum = depths[0] + depths[1] + depths[2];
    const bool same_sign = std::max(holding(edges > 0), holding(edges < 0)) == 7;
    const bool behind = std::signbit(sum) != (std::signbit(area) != std::signbit(d[2]));
    Triple32 sides{}; // at least the lengths of the two sides at the first corner
    for (const Triple32 &coordinates : corners)
        sides += absolute(coordinates - coordinates[0]);
    const auto side = static_cast<double>(sides[1] + sides[2]);
    const double bound = static_cast<double>(Options.clear_bound) * 0x1p-15 * d[2] * d[2];
    const bool clear = std::abs(sum * area) >= bound * side * side * (std::abs(sum) + side * std::abs(area));
    return {sum / (area * d[2]), same_sign && behind, Options.quick_t && same_sign && clear};
}

// The search of one ray among the triangles. Of hits that are sure, floats tell which is the nearest: it waits to be
// decided while the walk goes on. It is decided at the end, or when another comes so close that floats cannot tell.
template <WideOptions Options, class R> class TriangleSearch {
  public:
    using T = typename R::Scalar;
    using Triangles = PackedTriangles<Options>;

    TriangleSearch(const R &ray, const WideRay &wide, const Triangles &shapes)
        : ray_(ray), wide_(wide), shapes_(shapes) {}

    // Looks at a leaf; t_max becomes smaller where something nearer is found.
    [[gnu::always_inline]] void look(WideLink link, float &t_max) {
        const Candidates seen = candidates_in(link, t_max);
        unsigned found = seen.bits;
        if (found == 0)
            return;
        const Floats from = seen.from();
        if (const unsigned sure = found & seen.inside & after_start(from); sure != 0) {
            const float to = range(seen.to(), sure).first;
            const unsigned near = found & ~above(from, all(to));
            count_tests(static_cast<Id>(std::popcount(found ^ near)));
            found = near;
            if ((found & (found - 1)) == 0 && to < from_) { // what has waited is surely farther
                count_tests(slot_ != no_id);
                const unsigned lane = lowest(found);
                slot_ = Triangles::first_slot(link) + lane;
                from_ = permuted(from, all_ints(static_cast<std::int32_t>(lane)))[0];
                t_max = std::min(t_max, to * wide_.t_per_z);
                return;
            }
        }
        t_max = decide_all(link, found);
    }

    // For a shadow ray: whether it hits any triangle of the leaf.
    [[gnu::always_inline]] bool hits(WideLink link) {
        const Candidates seen = candidates_in(link, wide_.t_max);
        if (seen.bits == 0)
            return false;
        if ((seen.bits & seen.inside & after_start(seen.from()) & before_end(seen.to())) != 0)
            best_ = {0, 0};
        else
            decide_all(link, seen.bits);
        return bool(best_);
    }

    // The closest hit in what has been looked at.
    Hit<T> closest() {
        if (slot_ != no_id)
            decide_all(WideLink::leaf(0, 1), 0);
        return {best_.t, best_.id};
    }

  private:
    // The candidates of a leaf; the others count as tested.
    [[gnu::always_inline]] Candidates candidates_in(WideLink link, float t_max) const {
        Candidates seen = candidates<Options>(wide_, shapes_.leaf(link), t_max * wide_.z_per_t);
        seen.bits &= (1u << link.count()) - 1;
        count_tests(link.count() - static_cast<Id>(std::popcount(seen.bits)));
        return seen;
    }

    // A bit for each distance along z that is surely inside the ray's interval, seen from that end.
    unsigned after_start(Floats z) const {
        return above(z * all(wide_.t_per_z), all(wide_.rounded_up(static_cast<double>(ray_.t_min))));
    }
    unsigned before_end(Floats z) const {
        return above(all(wide_.rounded_down(static_cast<double>(ray_.t_max))), z * all(wide_.t_per_z));
    }
    void count_tests(Id tests) const {
        for (; tests > 0; --tests)
            ray_.counts().test();
    }

    // Decides about what has waited and about these triangles of a leaf, out of the way of the walk's registers.
    // Returns t_max.
    [[gnu::noinline]] float decide_all(WideLink link, unsigned found) {
        if (slot_ != no_id)
            decide_one(slot_);
        slot_ = no_id;
        from_ = infinity<float>;
        for (; found; found &= found - 1)
            decide_one(Triangles::first_slot(link) + lowest(found));
        return wide_.rounded_up(static_cast<double>(best_ ? next_up(best_.t) : ray_.t_max));
    }
    [[gnu::always_inline]] void decide_one(Id slot) {
        const Decided decided = decide<Options>(ray_, wide_, shapes_.leaves()[slot / lanes], slot % lanes);
        if (!decided.clear && !decided.none) {
            ask_chapter_08(slot);
            return;
        }
        ray_.counts().test();
        const Hit<T> hit{static_cast<T>(decided.t), shapes_.first_id(slot)};
        if (!decided.none && in_range(ray_, hit.t) && comes_before(hit, best_))
            best_ = hit;
    }
    [[gnu::noinline, gnu::cold]] void ask_chapter_08(Id slot) {
        R search = ray_;
        if (best_)
            search.t_max = next_up(best_.t);
        closest_of(search, shapes_[slot], shapes_.first_id(slot), best_);
    }

    const R &ray_;
    const WideRay &wide_;
    const Triangles &shapes_;
    Hit<T> best_;
    Id slot_ = no_id;              // the triangle that waits
    float from_ = infinity<float>; // the distance along z before which it surely does not lie
};

} // namespace course
