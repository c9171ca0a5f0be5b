// Lesson 15, step 5: the triangles of a wide BVH, in leaves of eight, under the ids of the scene.
#pragma once
#include "chapters/15_wide_bvh/collapse.hpp"
#include "chapters/15_wide_bvh/compact_leaf.hpp"
#include "chapters/15_wide_bvh/triangle_leaf.hpp"

#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace course {

// Does for packed triangles what chapter 09's ShapeList does for shapes. Lane i of leaf k is slot 8 k + i; where a leaf
// holds fewer than eight, slots are left out.
template <class TheLeaf> class TriangleList {
  public:
    using Leaf = TheLeaf;

    // Packs the leaves of the tree, and lets its links say where they are. Takes the tree's order if ids are to be
    // found there.
    TriangleList(std::span<const Triangle<float>> triangles, WideTree &tree);

    Id slots() const { return static_cast<Id>(leaves_.size() * lanes); }
    Id primitives() const { return static_cast<Id>(slots_.size()); }
    Triangle<float> operator[](Id slot) const {
        const auto corner = [&](unsigned k) -> Vec<float> {
            const Leaf &leaf = leaves_[slot / lanes];
            return {leaf.at(k, 0, slot % lanes), leaf.at(k, 1, slot % lanes), leaf.at(k, 2, slot % lanes)};
        };
        return {corner(0), corner(1), corner(2)};
    }
    Id first_id(Id slot) const { return leaves_[slot / lanes].id(order_, slot % lanes); }
    Id slot_of(Id id) const { return slots_[id]; }

    const Leaf &leaf(WideLink link) const { return leaves_[link.first()]; }
    std::span<const Leaf> leaves() const { return leaves_; }
    static Id first_slot(WideLink link) { return link.first() * lanes; }

    std::size_t bytes() const { return leaves_.size() * sizeof(Leaf) + (slots_.size() + order_.size()) * sizeof(Id); }

  private:
    template <class Visit> static void for_each_leaf(WideTree &tree, const Visit &visit) {
        for (WideNode &node : tree.nodes)
            for (unsigned i = 0; i < lanes; ++i)
                if (node.planes[0][0][i] <= node.planes[0][1][i] && node.links[i].is_leaf()) // else no child is there
                    visit(node.links[i]);
    }

    WideLink pack(std::span<const Triangle<float>> triangles, std::span<const Id> order, WideLink link) {
        const auto number = static_cast<Id>(leaves_.size());
        leaves_.emplace_back(triangles, order, link.first(), link.count());
        for (unsigned i = 0; i < link.count(); ++i)
            slots_[order[link.first() + i]] = number * lanes + i;
        return WideLink::leaf(number, link.count());
    }

    LargeVector<Leaf> leaves_;
    std::vector<Id> slots_, order_; // by id; ids by leaf
};

template <class Leaf> TriangleList<Leaf>::TriangleList(std::span<const Triangle<float>> triangles, WideTree &tree)
    : slots_(triangles.size(), no_id) {
    std::size_t count = 0;
    for_each_leaf(tree, [&](WideLink &) { ++count; });
    leaves_.reserve(count);
    for_each_leaf(tree, [&](WideLink &link) { link = pack(triangles, tree.order, link); });
    if constexpr (std::is_same_v<Leaf, CompactLeaf>)
        order_ = std::move(tree.order);
}

template <WideOptions Options> using PackedTriangles =
    TriangleList<std::conditional_t<Options.leaf == WideOptions::Leaf::compact, CompactLeaf, TriangleLeaf>>;

#ifdef COURSE_COMPILED_ONCE // for all programs, in compiled_once.cpp
extern template TriangleList<TriangleLeaf>::TriangleList(std::span<const Triangle<float>>, WideTree &);
extern template TriangleList<CompactLeaf>::TriangleList(std::span<const Triangle<float>>, WideTree &);
#endif

} // namespace course
