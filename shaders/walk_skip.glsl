// A walk without a stack: the boxes lie in the order of a walk that always takes the first child first, and each knows
// where to go on when the ray misses it. Simple; but near boxes do not come first.
uniform samplerBuffer boxes;  // two texels a box: lo, hi
uniform isamplerBuffer skips; // a texel a box: where to go on after a miss, and the leaf, or 0

void walk(Ray ray, int tree, bool any, inout Hit best) {
    vec4 root = texelFetch(scene, tree);
    NodeRay prepared = node_ray(ray, root.y);
    int at = int(root.z), past = int(root.w);
    while (at < past) {
        vec3 lo = texelFetch(boxes, 2 * at).xyz, hi = texelFetch(boxes, 2 * at + 1).xyz;
        ivec2 skip = texelFetch(skips, at).xy;
        vec3 enter = mix(lo, hi, prepared.down) * prepared.inverse - prepared.near;
        vec3 leave = mix(hi, lo, prepared.down) * prepared.inverse - prepared.far;
        bool met = max(max(enter.x, enter.y), max(enter.z, 0)) <= min(min(leave.x, leave.y), min(leave.z, best.t));
        if (met && skip.y < 0)
            test_leaf(ray, skip.y, best);
        at = met ? at + 1 : skip.x;
        if (any && best.kind != NOTHING)
            at = past;
    }
    if (at < past)
        out_of_steps = true;
}
