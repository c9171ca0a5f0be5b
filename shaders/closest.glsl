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

Surface surface_of(Ray ray, Hit hit) {
#ifdef HAS_SPHERE
    if (hit.kind == SPHERE)
        return surface(ray, hit.t, sphere_at(hit.at));
#endif
#ifdef HAS_PLANE
    if (hit.kind == PLANE)
        return surface(ray, hit.t, plane_at(hit.at));
#endif
#ifdef HAS_DISK
    if (hit.kind == DISK)
        return surface(ray, hit.t, disk_at(hit.at));
#endif
#ifdef HAS_CYLINDER
    if (hit.kind == CYLINDER)
        return surface(ray, hit.t, cylinder_at(hit.at));
#endif
#ifdef HAS_CONE
    if (hit.kind == CONE)
        return surface(ray, hit.t, cone_at(hit.at));
#endif
#ifdef HAS_BOX
    if (hit.kind == BOX)
        return surface(ray, hit.t, box_at(hit.at));
#endif
#ifdef HAS_TRIANGLE
    if (hit.kind == TRIANGLE)
        return surface(ray, hit.t, triangle_at(hit.at), hit.at);
#endif
#ifdef HAS_QUARTIC
    if (hit.kind == TORUS)
        return surface(ray, hit.t, torus_at(hit.at));
    if (hit.kind == BLOB)
        return surface(ray, hit.t, blob_at(hit.at));
#endif
    return Surface(vec3(0), vec3(0, 1, 0), vec3(0, 1, 0), vec2(0), 0, 0); // not reached
}
