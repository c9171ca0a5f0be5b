// Lesson 15, step 6: the wide BVH, and the walk of one ray through it.
#pragma once
#include "chapters/09_aabb/structure.hpp"
#include "chapters/15_wide_bvh/triangle_list.hpp"

#include <type_traits>

namespace course {

template <class Shape, WideOptions Options> inline constexpr bool is_packed =
    std::is_same_v<Shape, Triangle<float>> &&Options.leaf == WideOptions::Leaf::eight;

template <Bounded S, WideOptions Options = {}> struct WideBvhBy {
    using Shape = S;
    static constexpr bool packed = is_packed<Shape, Options>;

    WideTree tree;
    std::conditional_t<packed, TriangleList, ShapeList<Shape>> shapes; // in the order of the leaves
    Box<float> box;

    explicit WideBvhBy(std::span<const Shape> given) : tree(tree_of(given)), shapes(shapes_of(given)), box(tree.box) {
        tree.order = {};
    }
    std::size_t node_bytes() const { return tree.nodes.size() * sizeof(WideNode); }

  private:
    static WideTree tree_of(std::span<const Shape> given) {
        const auto boxes = float_boxes(given);
        const BinnedSah rule = packed ? BinnedSah{8, 1.5f} : BinnedSah{8, 1.5f};
        return Collapser(TreeBuilder(boxes, can_be_hit(boxes), rule).build(), Options.collapse,
                         packed ? WideCosts{1, 0} : WideCosts{0.3f, 0.7f})
            .collapse();
    }
    auto shapes_of(std::span<const Shape> given) {
        if constexpr (packed)
            return TriangleList(given, tree);
        else
            return ShapeList<Shape>(given, tree.order);
    }
};

template <class Shape> using WideBvh = WideBvhBy<Shape>;

// The children that wait: at most seven for each level, and when the ray enters them.
class WideStack {
  public:
    bool empty() const { return waiting_ == 0; }
    void push(WideLink link, float enter) {
        links_[waiting_] = link;
        enters_[waiting_] = enter;
        ++waiting_;
    }
    // Those of the eight whose bits are set.
    void push(const WideLink (&links)[lanes], Floats enter, unsigned bits) {
        store(links_ + waiting_, compressed(load<Ints>(links), bits));
        store(enters_ + waiting_, compressed(enter, bits));
        waiting_ += static_cast<unsigned>(std::popcount(bits));
    }
    // The same, in the order that the lanes are named in.
    void push(const WideLink (&links)[lanes], Floats enter, unsigned bits, Ints order) {
        const Ints in_order =
            permuted(all_ints(static_cast<std::int32_t>(bits)) >> Ints{0, 1, 2, 3, 4, 5, 6, 7}, order);
        bits = above((Floats)((in_order & 1) << 23), Floats{});
        store(links_ + waiting_, compressed(permuted(load<Ints>(links), order), bits));
        store(enters_ + waiting_, compressed(permuted(enter, order), bits));
        waiting_ += static_cast<unsigned>(std::popcount(bits));
    }
    // Takes the last one that begins by t_max into `link`, and drops those after it. False if there is none.
    bool pop(WideLink &link, float t_max) {
        while (waiting_ != 0) {
            --waiting_;
            if (!(enters_[waiting_] > t_max)) {
                link = links_[waiting_];
                return true;
            }
        }
        return false;
    }

  private:
    unsigned waiting_ = 0;
    float enters_[7 * deepest + lanes];
    WideLink links_[7 * deepest + lanes];
};

// Calls leaf(link) for every leaf that the ray may hit something in, near ones first; it returns true to end the walk.
template <WideOptions Options, class R, class Leaf> void walk(R &ray, const WideTree &tree, Leaf &&leaf) {
    if (tree.nodes.empty())
        return;
    const WideRay wide(ray, tree.box, Options.slab_pad);
    float t_max = wide.scaled(static_cast<double>(ray.t_max));
    WideStack stack;
    WideLink at = WideLink::node(0);
    while (true) {
        if (at.is_leaf()) {
            if (leaf(at))
                return;
            t_max = wide.scaled(static_cast<double>(ray.t_max));
        } else {
            ray.counts().node();
            const WideNode &node = tree.nodes[at.first()];
            const auto [enter, met] = wide(node, t_max);
            if (Options.one_hit_path && std::has_single_bit(met)) {
                at = node.links[std::countr_zero(met)];
                continue;
            }
            stack.push(node.links, enter, met, unpacked(node.far_first[wide.octant()]));
        }
        if (!stack.pop(at, t_max))
            return;
    }
}

// Any shape: the structure's contract, from which chapter 09 makes all else.
template <class R, class Shape, WideOptions Options, class Test>
void traverse(R &ray, const WideBvhBy<Shape, Options> &bvh, Test &&test) {
    walk<Options>(ray, bvh.tree, [&](WideLink leaf) {
        Id first = leaf.first();
        if constexpr (is_packed<Shape, Options>)
            first = TriangleList::first_slot(leaf);
        for (Id slot = first; slot < first + leaf.count(); ++slot)
            if (test(slot))
                return true;
        return false;
    });
}

// ---- Packed triangles -----------------------------------------------------------------------------------------------

// Calls test(triangle, id) for every triangle that the ray may hit.
template <WideOptions Options, class R, class Test>
void search_triangles(R &ray, const WideBvhBy<Triangle<float>, Options> &bvh, Test &&test) {
    const TriangleRay<Options> eight(ray);
    walk<Options>(ray, bvh.tree, [&](WideLink link) {
        const TriangleLeaf &leaf = bvh.shapes.leaf(link);
        unsigned left = eight(leaf, eight.scaled(static_cast<double>(ray.t_max))) & ((1u << link.count()) - 1);
        for (Id sure = static_cast<Id>(std::popcount(left)); sure < link.count(); ++sure)
            ray.counts().test(); // the misses; those left are counted when they are tested
        for (; left; left &= left - 1) {
            const auto lane = static_cast<unsigned>(std::countr_zero(left));
            if (test(leaf[lane], leaf.id(lane)))
                return true;
        }
        return false;
    });
}

template <class R, WideOptions Options>
    requires is_packed<Triangle<float>, Options> Hit<typename R::Scalar>
    closest_hit(const R &ray, const WideBvhBy<Triangle<float>, Options> &bvh) {
        Hit<typename R::Scalar> best;
        auto search = prepared<Triangle<float>>(ray);
        search_triangles(search, bvh, [&](const Triangle<float> &triangle, Id id) {
            closest_of(search, triangle, id, best);
            return false;
        });
        return best;
    }

template <class R, WideOptions Options>
    requires is_packed<Triangle<float>, Options>
bool any_hit(const R &ray, const WideBvhBy<Triangle<float>, Options> &bvh) {
    bool found = false;
    auto search = prepared<Triangle<float>>(ray);
    search_triangles(search, bvh,
                     [&](const Triangle<float> &triangle, Id) { return found = any_hit(search, triangle); });
    return found;
}

template <class R, WideOptions Options, class F, class... Context>
    requires is_packed<Triangle<float>, Options>
auto with_hit(const R &ray, const Hit<typename R::Scalar> &hit, const WideBvhBy<Triangle<float>, Options> &bvh, F &&f,
              const Context &...context) {
    return with_hit(ray, Hit<typename R::Scalar>{hit.t, 0}, bvh.shapes[bvh.shapes.slot_of(hit.id)], f, context...);
}

template <WideOptions Options>
    requires is_packed<Triangle<float>, Options> Id size(const WideBvhBy<Triangle<float>, Options> &bvh) {
        return bvh.shapes.primitives();
    }

template <WideOptions Options>
    requires is_packed<Triangle<float>, Options> Box<float> bounds(const WideBvhBy<Triangle<float>, Options> &bvh) {
        return bvh.box;
    }

template <WideOptions Options>
    requires is_packed<Triangle<float>, Options> std::size_t bytes(const WideBvhBy<Triangle<float>, Options> &bvh) {
        return bvh.shapes.bytes() + bvh.node_bytes();
    }

} // namespace course
