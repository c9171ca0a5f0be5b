// Lesson 15, step 5: the triangles of a wide BVH, in leaves of eight, under the ids of the scene.
#pragma once
#include "chapters/15_wide_bvh/collapse.hpp"
#include "chapters/15_wide_bvh/triangle_leaf.hpp"

#include <span>
#include <vector>

namespace course {

// Does for packed triangles what chapter 09's ShapeList does for shapes. Lane i of leaf k is slot 8 k + i; where a leaf
// holds fewer than eight, slots are left out.
class TriangleList {
  public:
    // Packs the leaves of the tree, and lets its links say where they are.
    TriangleList(std::span<const Triangle<float>> triangles, WideTree &tree)
        : slots_(triangles.size(), no_id), primitives_(static_cast<Id>(triangles.size())) {
        for (WideNode &node : tree.nodes)
            for (unsigned i = 0; i < lanes; ++i)
                if (node.planes[0][0][i] <= node.planes[0][1][i]) // else no child is there
                    if (WideLink &link = node.links[i]; link.is_leaf())
                        link = pack(triangles, std::span(tree.order).subspan(link.first(), link.count()));
        leaves_.shrink_to_fit();
    }

    Id slots() const { return static_cast<Id>(leaves_.size() * lanes); }
    Id primitives() const { return primitives_; }
    Triangle<float> operator[](Id slot) const { return leaves_[slot / lanes][slot % lanes]; }
    Id first_id(Id slot) const { return leaves_[slot / lanes].ids[slot % lanes]; }
    Id slot_of(Id id) const { return slots_[id]; }

    const TriangleLeaf &leaf(WideLink link) const { return leaves_[link.first()]; }
    std::span<const TriangleLeaf> leaves() const { return leaves_; }
    static Id first_slot(WideLink link) { return link.first() * lanes; }

    std::size_t bytes() const { return leaves_.size() * sizeof(TriangleLeaf) + slots_.size() * sizeof(Id); }

  private:
    WideLink pack(std::span<const Triangle<float>> triangles, std::span<const Id> ids) {
        const auto number = static_cast<Id>(leaves_.size());
        leaves_.emplace_back(triangles, ids);
        for (unsigned i = 0; i < ids.size(); ++i)
            slots_[ids[i]] = number * lanes + i;
        return WideLink::leaf(number, static_cast<Id>(ids.size()));
    }

    std::vector<TriangleLeaf> leaves_;
    std::vector<Id> slots_; // by id
    Id primitives_;
};

} // namespace course
