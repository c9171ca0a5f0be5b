// Lesson 15, step 5c: of the few triangles that the ray may hit, the nearest, decided as chapter 08 decides.
#pragma once
#include "chapters/15_wide_bvh/one_triangle.hpp"

#include <algorithm>
#include <bit>

namespace course {

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
        const Floats from = seen.from(), to = seen.to();
        const unsigned sure = found & seen.inside & after_start(from);
        if (sure != 0 && !std::has_single_bit(found)) { // what begins after the end of one that is sure is farther
            const unsigned near = found & ~above(from, all(range(to, sure).first));
            count_tests(static_cast<Id>(std::popcount(found ^ near)));
            found = near;
        }
        if (std::has_single_bit(found) && (found & sure & seen.template confirmed<Options>()) != 0) {
            const unsigned lane = lowest(found);
            if (const float end = number_of(to, lane); end < from_) { // what has waited is surely farther
                count_tests(slot_ != no_id);
                slot_ = Triangles::first_slot(link) + lane;
                from_ = number_of(from, lane);
                t_max = std::min(t_max, end * wide_.t_per_z);
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
            take(slot_, exactly_seen_at(slot_));
        return best_;
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

    static float number_of(Floats numbers, unsigned lane) {
        return permuted(numbers, all_ints(static_cast<std::int32_t>(lane)))[0];
    }

    // Decides about what has waited and about these triangles of a leaf, out of the way of the walk's registers.
    // Returns t_max.
    [[gnu::noinline]] float decide_all(WideLink link, unsigned found) {
        if (slot_ != no_id)
            take(slot_, exactly_seen_at(slot_));
        slot_ = no_id;
        from_ = infinity<float>;
        for (; found; found &= found - 1)
            decide(Triangles::first_slot(link) + lowest(found));
        return wide_.rounded_up(static_cast<double>(best_ ? next_up(best_.t) : ray_.t_max));
    }
    [[gnu::always_inline]] void decide(Id slot) {
        const ExactlySeen seen = exactly_seen_at(slot);
        if (!seen.surely_inside())
            ask_chapter_08(slot);
        else if (seen.behind())
            count_tests(1);
        else if (surely_confirmed<Options>(seen, shapes_.leaves()[slot / lanes], slot % lanes))
            take(slot, seen);
        else
            ask_chapter_08(slot);
    }
    [[gnu::always_inline]] ExactlySeen exactly_seen_at(Id slot) const {
        return exactly_seen(ray_, wide_, shapes_.leaves()[slot / lanes], slot % lanes);
    }
    // The best hit, if it is this one.
    [[gnu::always_inline]] void take(Id slot, const ExactlySeen &seen) {
        count_tests(1);
        const Hit<T> hit{static_cast<T>(seen.t()), shapes_.first_id(slot)};
        if (in_range(ray_, hit.t) && comes_before(hit, best_))
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
    Id slot_ = no_id;              // the triangle that waits: surely hit, its t surely confirmed
    float from_ = infinity<float>; // the distance along z before which it surely does not lie
};

} // namespace course
