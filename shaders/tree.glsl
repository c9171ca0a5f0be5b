// The bounding volume hierarchy of chapter 14: how a ray meets its boxes. How it walks is in walk_skip.glsl, the lesson's
// first way, or walk_stack.glsl. A tree of the scene is a texel: its root, its largest coordinate, its stretch of boxes.

// A leaf is ~(16 first + count): the triangles first .. first + count - 1. So ~0 is a leaf with nothing in it.
const int NO_MORE = ~0;

// What the boxes' test needs of a ray, prepared once (NodeRay of chapter 14): the planes are met a margin early and
// left a margin late, so that rounding loses no box.
struct NodeRay {
    vec3 inverse, near, far;
    bvec3 down;
};

NodeRay node_ray(Ray ray, float reach) {
    vec3 size = abs(ray.direction), place = abs(ray.origin);
    float largest = max(max(size.x, size.y), size.z);
    float margin = (max(max(place.x, place.y), place.z) + reach) / 1048576; // 2^-20
    bvec3 down = lessThan(ray.direction, vec3(0));
    vec3 side = mix(vec3(1), vec3(-1), down);
    vec3 inverse = 1 / (side * max(size, largest / 1073741824)); // 2^-30: no division by 0
    return NodeRay(inverse, (ray.origin + margin * side) * inverse, (ray.origin - margin * side) * inverse, down);
}

// The triangles of a leaf.
void test_leaf(Ray ray, int leaf, inout Hit best) {
    int slot = ~leaf >> 4, past = slot + (~leaf & 15);
    for (; slot < past; ++slot) {
        float t = intersect(ray, triangle_at(slot * triangle_size));
        if (t > 0 && t < best.t)
            best = Hit(t, TRIANGLE, slot * triangle_size);
    }
    if (slot < past)
        out_of_steps = true;
}

#ifdef WALK_SKIP
#include "walk_skip.glsl"
#else
#include "walk_stack.glsl"
#endif

void closest_in_tree(Ray ray, int tree, inout Hit best) { walk(ray, tree, false, best); }

bool any_in_tree(Ray ray, int tree) {
    Hit hit = Hit(ray.t_max, NOTHING, 0);
    walk(ray, tree, true, hit);
    return hit.kind != NOTHING;
}
