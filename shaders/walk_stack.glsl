// The walk to the nearer child first; the other waits. Two loops, one within the other: rays that have come to a leaf
// wait for their neighbours, and then all test triangles together. Chapter 14 keeps the t at which a child that waits is
// entered, and drops it without a look if a hit has been found before; here a look is as cheap as keeping it.
uniform samplerBuffer nodes;  // three texels a node: lo of both children, hi of both, for x, y and z
uniform isamplerBuffer links; // a texel a node: where the children are; a node's number, or a leaf

// When the ray enters both children's boxes; infinity for one that it does not meet before t_max.
vec2 entries(NodeRay ray, int node, float t_max) {
    vec4 x = texelFetch(nodes, 3 * node), y = texelFetch(nodes, 3 * node + 1), z = texelFetch(nodes, 3 * node + 2);
    x = (ray.down.x ? x.zwxy : x) * ray.inverse.x - vec4(ray.near.xx, ray.far.xx);
    y = (ray.down.y ? y.zwxy : y) * ray.inverse.y - vec4(ray.near.yy, ray.far.yy);
    z = (ray.down.z ? z.zwxy : z) * ray.inverse.z - vec4(ray.near.zz, ray.far.zz);
    vec2 enter = max(max(x.xy, y.xy), max(z.xy, vec2(0))), leave = min(min(x.zw, y.zw), min(z.zw, vec2(t_max)));
    return mix(enter, vec2(infinity), greaterThan(enter, leave));
}

void walk(Ray ray, int tree, bool any, inout Hit best) {
    int waiting[TREE_DEPTH]; // as many as the tree is deep: it cannot overflow
    int count = 0;
    vec4 root = texelFetch(scene, tree);
    NodeRay prepared = node_ray(ray, root.y);
    int at = int(root.x);
    bool ended = false;
    while (!ended) {
        while (at >= 0) {
            vec2 enter = entries(prepared, at, best.t);
            ivec2 children = texelFetch(links, at).xy;
            bool second = enter.y < enter.x;
            float near = min(enter.x, enter.y), far = max(enter.x, enter.y);
            if (far < infinity) {
                waiting[count] = second ? children.x : children.y;
                ++count;
            }
            at = near < infinity ? (second ? children.y : children.x) : NO_MORE;
        }
        if (at >= 0)
            out_of_steps = true;
        test_leaf(ray, at, best);
        at = NO_MORE;
        if (any && best.kind != NOTHING)
            count = 0;
        if (count > 0) {
            --count;
            at = waiting[count];
        }
        ended = at == NO_MORE && count == 0;
    }
    if (!ended)
        out_of_steps = true;
}
