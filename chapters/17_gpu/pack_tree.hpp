// Lesson 17, step 6: chapter 14's hierarchy as texels, for a walk with a stack and for one without.
#pragma once
#include "chapters/08_mesh/normals.hpp"
#include "chapters/14_bvh/bvh.hpp"
#include "common/errors.hpp"

#include <algorithm>
#include <vector>

namespace course {

// A mesh in its hierarchy, with its smooth normals: what the shader draws as one shape.
struct SmoothMesh {
    const Bvh<Triangle<>> *bvh;
    const Mesh<> *mesh; // the bvh is over its triangles
};

// The meshes of a scene. Triangles lie in the order of the leaves.
struct PackedTrees {
    std::vector<glm::vec4> nodes;            // three to a node, as tree.glsl reads them
    std::vector<glm::ivec2> links;           // one to a node
    std::vector<glm::vec4> boxes;            // two to a box, for the walk without a stack
    std::vector<glm::ivec2> skips;           // one to a box
    std::vector<glm::vec4> corners, normals; // three of each to a triangle
    int depth = 1;                           // the most children that ever wait

    int triangles() const { return static_cast<int>(corners.size() / 3); }
};

// A leaf as the shader has it: ~(16 first + count), which is negative.
inline int leaf_code(const Link &leaf, int first_triangle) {
    return ~(16 * (static_cast<int>(leaf.first) + first_triangle) + static_cast<int>(leaf.count));
}

inline int link_code(const Link &link, int first_node, int first_triangle) {
    return link.is_leaf() ? leaf_code(link, first_triangle) : static_cast<int>(link.first) + first_node;
}

// How many children can wait at once below this link: one for each node on the way down.
inline int depth_below(const Tree &tree, const Link &link) {
    if (link.is_leaf())
        return 0;
    const Node &node = tree.nodes[link.first];
    return 1 + std::max(depth_below(tree, node.children[0]), depth_below(tree, node.children[1]));
}

// The boxes in the order of a walk that always takes the first child first. Each knows where the walk goes on when the
// ray misses it: behind all that lies within.
inline void append_boxes(PackedTrees &packed, const Tree &tree, const Link &link, const Box<float> &box,
                         int first_triangle) {
    const std::size_t at = packed.skips.size();
    packed.boxes.insert(packed.boxes.end(), {{box.lo, 0}, {box.hi, 0}});
    packed.skips.emplace_back(0, link.is_leaf() ? leaf_code(link, first_triangle) : 0);
    if (!link.is_leaf()) {
        const Node &node = tree.nodes[link.first];
        for (const std::size_t child : {0, 1}) {
            Box<float> own;
            for (int axis = 0; axis < 3; ++axis) {
                own.lo[axis] = node.planes[axis][0][child];
                own.hi[axis] = node.planes[axis][1][child];
            }
            append_boxes(packed, tree, node.children[child], own, first_triangle);
        }
    }
    packed.skips[at].x = static_cast<int>(packed.skips.size());
}

inline void append_triangle(PackedTrees &packed, const Vec<float> &a, const Vec<float> &b, const Vec<float> &c,
                            float material) {
    packed.corners.insert(packed.corners.end(), {{a, material}, {b, 0}, {c, 0}});
    packed.normals.insert(packed.normals.end(), 3, glm::vec4(0));
}

// Appends the mesh and returns the texel that stands for it in the scene: the root, the largest coordinate, and the
// stretch of its boxes. Throws InputError where the numbers of triangles no longer fit in a float or a leaf's code.
inline glm::vec4 append_mesh(PackedTrees &packed, const SmoothMesh &shape, float material) {
    const Tree &tree = shape.bvh->tree;
    const int first_node = static_cast<int>(packed.links.size()), first_triangle = packed.triangles(),
              first_box = static_cast<int>(packed.skips.size());
    constexpr std::size_t most = std::size_t{1} << 24;
    if (size(*shape.mesh) + static_cast<std::size_t>(first_triangle) > most)
        throw InputError("mesh", "has more than the 16,777,216 triangles that the shader can number");
    for (const Node &node : tree.nodes) {
        for (const auto &axis : node.planes)
            packed.nodes.emplace_back(axis[0][0], axis[0][1], axis[1][0], axis[1][1]);
        packed.links.emplace_back(link_code(node.children[0], first_node, first_triangle),
                                  link_code(node.children[1], first_node, first_triangle));
    }
    if (shape.bvh->shapes.slots() > 0)
        append_boxes(packed, tree, tree.root, tree.box, first_triangle);
    for (Id slot = 0; slot < shape.bvh->shapes.slots(); ++slot) {
        const Triangle<> &flat = shape.bvh->shapes[slot];
        append_triangle(packed, flat.a, flat.b, flat.c, material);
        if (!shape.mesh->normals.empty())
            for (std::size_t corner = 0; corner < 3; ++corner)
                packed.normals[packed.normals.size() - 3 + corner] = {
                    shape.mesh->normals[shape.mesh->indices[shape.bvh->shapes.first_id(slot)][corner]], 0};
    }
    packed.depth = std::max(packed.depth, depth_below(tree, tree.root));
    const int root = shape.bvh->shapes.slots() > 0 ? link_code(tree.root, first_node, first_triangle) : ~0;
    return {root, largest_coordinate(tree.box), first_box, packed.skips.size()};
}

} // namespace course
