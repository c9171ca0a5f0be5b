// The search. SCENE_LISTS names the scene's lists in its order, so that of two hits at the same t the first one stays:
// LIST(number, KIND, size, shape_at) for shapes, TREE(number) for meshes. Nothing else is compiled.
float rays_traced = 0;

Hit closest_hit(Ray ray) {
    ++rays_traced;
    Hit best = Hit(ray.t_max, NOTHING, 0);
    int i;
#define LIST(number, KIND, size, shape_at) \
    for (i = 0; i < lists[number].y; ++i) { \
        int at = lists[number].x + i * size; \
        float t = intersect(ray, shape_at(at)); \
        if (t > 0 && t < best.t) \
            best = Hit(t, KIND, at); \
    } \
    if (i < lists[number].y) \
        out_of_steps = true;
#define TREE(number) \
    for (i = 0; i < lists[number].y; ++i) \
        closest_in_tree(ray, lists[number].x + i, best);
    SCENE_LISTS
#undef LIST
#undef TREE
    return best;
}

bool any_hit(Ray ray) {
    ++rays_traced;
    bool found = false;
    int i;
#define LIST(number, KIND, size, shape_at) \
    for (i = 0; i < lists[number].y && !found; ++i) { \
        float t = intersect(ray, shape_at(lists[number].x + i * size)); \
        found = t > 0 && t < ray.t_max; \
    } \
    if (i < lists[number].y && !found) \
        out_of_steps = true;
#define TREE(number) \
    for (i = 0; i < lists[number].y && !found; ++i) \
        found = any_in_tree(ray, lists[number].x + i);
    SCENE_LISTS
#undef LIST
#undef TREE
    return found;
}

// SCENE_KINDS names the scene's kinds of shape, each once: ONE_KIND(KIND, shape_at).
Surface surface_of(Ray ray, Hit hit) {
#define ONE_KIND(KIND, shape_at) \
    if (hit.kind == KIND) \
        return surface(ray, hit.t, shape_at(hit.at));
    SCENE_KINDS
#undef ONE_KIND
    return Surface(vec3(0), vec3(0, 1, 0), vec3(0, 1, 0), vec2(0), 0, 0); // not reached
}
