// The bounding volume hierarchy of chapter 14, node for node: the boxes of both children, axis by axis.
uniform samplerBuffer nodes;  // three texels a node: lo of both children, hi of both, for x, y and z
uniform isamplerBuffer links; // a texel a node: where both children are

// A node's number, or for a leaf ~(16 first + count): the slots first .. first + count - 1 of the triangles.
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

// When the ray enters both children's boxes; infinity for one that it does not meet between 0 and t_max.
vec2 entries(NodeRay ray, int node, float t_max) {
    vec4 x = texelFetch(nodes, 3 * node), y = texelFetch(nodes, 3 * node + 1), z = texelFetch(nodes, 3 * node + 2);
    x = (ray.down.x ? x.zwxy : x) * ray.inverse.x - vec4(ray.near.xx, ray.far.xx);
    y = (ray.down.y ? y.zwxy : y) * ray.inverse.y - vec4(ray.near.yy, ray.far.yy);
    z = (ray.down.z ? z.zwxy : z) * ray.inverse.z - vec4(ray.near.zz, ray.far.zz);
    vec2 enter = max(max(x.xy, y.xy), max(z.xy, vec2(0))), leave = min(min(x.zw, y.zw), min(z.zw, vec2(t_max)));
    return mix(enter, vec2(infinity), greaterThan(enter, leave));
}

// The walk goes to the nearer child first; the other waits. `any` ends it at the first hit. A tree of the scene is a
// texel: its root, and its largest coordinate.
void walk(Ray ray, int tree, bool any, inout Hit best) {
    int waiting[TREE_DEPTH];
    float enters[TREE_DEPTH];
    int count = 0;
    vec4 root = texelFetch(scene, tree);
    NodeRay prepared = node_ray(ray, root.y);
    int at = int(root.x);
    while (at != NO_MORE) {
        // Down to a leaf: rays that reach theirs early wait here for their neighbours.
        while (at >= 0) {
            vec2 enter = entries(prepared, at, best.t);
            ivec2 children = texelFetch(links, at).xy;
            bool swapped = enter.y < enter.x;
            float near = min(enter.x, enter.y), far = max(enter.x, enter.y);
            if (far < infinity) {
                waiting[count] = swapped ? children.x : children.y;
                enters[count] = far;
                ++count;
            }
            at = swapped ? children.y : children.x;
            if (!(near < infinity))
                break;
        }
        int slots = ~at;
        int past = (slots >> 4) + (slots & 15);
        if (at < 0)
            for (int slot = slots >> 4; slot < past; ++slot) {
                float t = intersect(ray, triangle_at(slot * triangle_size));
                if (t > 0 && t < best.t)
                    best = Hit(t, TRIANGLE, slot * triangle_size);
            }
        at = NO_MORE;
        if (any && best.kind != NOTHING)
            count = 0;
        while (count > 0 && at == NO_MORE) {
            --count;
            if (enters[count] <= best.t)
                at = waiting[count];
        }
    }
}

void closest_in_tree(Ray ray, int tree, inout Hit best) { walk(ray, tree, false, best); }

bool any_in_tree(Ray ray, int tree) {
    Hit hit = Hit(ray.t_max, NOTHING, 0);
    walk(ray, tree, true, hit);
    return hit.kind != NOTHING;
}
