// Lesson 15, step 9: packets. Up to eight rays that go much the same way walk through the tree together.
#pragma once
#include "chapters/15_wide_bvh/fetch.hpp"
#include "chapters/15_wide_bvh/ray_lanes.hpp"

#include <array>
#include <optional>
#include <span>

namespace course {

// Calls leaf(link, bits) for the rays of the group that meet a leaf's box; it returns those that go on.
template <WideOptions Options, class Leaf> void walk_together(RayLanes &rays, unsigned group,
                                                              const WideBvhBy<Triangle<float>, Options> &bvh,
                                                              const Fetch<Options> &fetch, Leaf &&leaf) {
    struct Waiting {
        Id node;
        unsigned child;
    } stack[most_waiting];
    unsigned waiting = 0;
    const Beam beam(rays, group);
    const unsigned octant = rays.octant(static_cast<unsigned>(std::countr_zero(group)));
    float t_max = range(rays.t_max, group).second;
    Id at = 0;
    while (true) {
        const WideNode &node = bvh.tree.nodes[at];
        unsigned met = beam(node, t_max);
        if (met != 0) {
            std::int32_t order[lanes];
            const Ints far_first = unpacked(node.far_first[octant]) & 7;
            store(order, far_first);
            for (met = permuted_bits(met, far_first); met; met &= met - 1) {
                const auto child = static_cast<unsigned>(order[std::countr_zero(met)]);
                fetch(node.links[child]);
                stack[waiting++] = {at, child};
            }
        }
        while (true) {
            if (waiting == 0)
                return;
            const auto [parent, child] = stack[--waiting];
            const unsigned here = rays.meeting(bvh.tree.nodes[parent], child, octant) & group;
            if (here == 0)
                continue;
            const WideLink link = bvh.tree.nodes[parent].links[child];
            if (!link.is_leaf()) {
                at = link.first();
                break;
            }
            group &= ~here | leaf(link, here);
            if (group == 0)
                return;
            t_max = range(rays.t_max, group).second;
        }
    }
}

// Up to eight rays, each looking for its closest hit or for any. They need not go the same way: those of each octant
// make a group that walks together.
template <WideOptions Options> class Packet {
  public:
    using Bvh = WideBvhBy<Triangle<float>, Options>;

    Packet(std::span<const Ray<double>> rays, const Bvh &bvh)
        : rays_(rays), bvh_(bvh), fetch_(bvh), together_(rays, bvh.tree.box, Options.slab_pad) {}

    void closest(std::span<Hit<double>> hits) {
        walk_in_groups([&](unsigned lane, WideLink link) {
            Search &search = *searches_[lane];
            search.triangles.look(link, search.t_max);
            together_.t_max[lane] = std::min(together_.t_max[lane], search.t_max * search.wide.z_per_t);
            return true;
        });
        for (std::size_t lane = 0; lane < rays_.size(); ++lane)
            if (searches_[lane])
                hits[lane] = searches_[lane]->triangles.closest();
    }
    void any(std::span<bool> hits) {
        walk_in_groups(
            [&](unsigned lane, WideLink link) { return !(hits[lane] = searches_[lane]->triangles.hits(link)); });
    }

  private:
    // One of the rays, ready for triangles.
    struct Search {
        WideRay wide;
        TriangleSearch<Options, Ray<double>> triangles;
        float t_max;

        Search(const Ray<double> &ray, const Bvh &bvh)
            : wide(wide_ray<Options>(ray, bvh.tree)), triangles(ray, wide, bvh.shapes), t_max(wide.t_max) {}
    };

    // Calls test(lane, link) for each ray that meets a leaf's box; it returns whether the ray goes on.
    template <class Test> void walk_in_groups(const Test &test) {
        const auto test_all = [&](WideLink link, unsigned here) {
            unsigned going_on = 0;
            for (unsigned bits = here; bits; bits &= bits - 1) {
                const auto lane = static_cast<unsigned>(std::countr_zero(bits));
                if (!searches_[lane])
                    searches_[lane].emplace(rays_[lane], bvh_);
                going_on |= unsigned{test(lane, link)} << lane;
            }
            return going_on;
        };
        for (unsigned left = (1u << rays_.size()) - 1; left;) {
            const unsigned group = left & together_.going_like(static_cast<unsigned>(std::countr_zero(left)));
            walk_together<Options>(together_, group, bvh_, fetch_, test_all);
            left &= ~group;
        }
    }

    std::span<const Ray<double>> rays_;
    const Bvh &bvh_;
    Fetch<Options> fetch_;
    RayLanes together_;
    std::array<std::optional<Search>, lanes> searches_; // made for those that reach a leaf
};

// The hits of up to eight rays: those of closest_hit(), bit for bit.
template <WideOptions Options> void closest_hits(std::span<const Ray<double>> rays,
                                                 const WideBvhBy<Triangle<float>, Options> &bvh,
                                                 std::span<Hit<double>> hits) {
    std::ranges::fill(hits, Hit<double>{});
    if (!rays.empty() && !bvh.tree.nodes.empty())
        Packet<Options>(rays, bvh).closest(hits);
}
template <WideOptions Options>
void any_hits(std::span<const Ray<double>> rays, const WideBvhBy<Triangle<float>, Options> &bvh, std::span<bool> hits) {
    std::ranges::fill(hits, false);
    if (!rays.empty() && !bvh.tree.nodes.empty())
        Packet<Options>(rays, bvh).any(hits);
}

} // namespace course
