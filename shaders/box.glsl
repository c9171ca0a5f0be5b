// The box, three pairs of planes. A ray along a pair lies between them or misses; telling so apart avoids 0 / 0.
struct Box {
    vec3 lo, hi;
    int material;
};

const int box_size = 2; // texels
Box box_at(int at) {
    vec4 lo = texelFetch(scene, at);
    return Box(lo.xyz, texelFetch(scene, at + 1).xyz, int(lo.w));
}

// Where the line is within the box: from x to y; empty where x > y.
vec2 span_within(Ray ray, vec3 lo, vec3 hi) {
    vec3 at_lo = (lo - ray.origin) / ray.direction, at_hi = (hi - ray.origin) / ray.direction;
    bvec3 along = equal(ray.direction, vec3(0));
    bvec3 between = bvec3(ivec3(lessThanEqual(lo, ray.origin)) & ivec3(lessThanEqual(ray.origin, hi)));
    vec3 near = mix(min(at_lo, at_hi), mix(vec3(infinity), vec3(-infinity), between), along);
    vec3 far = mix(max(at_lo, at_hi), mix(vec3(-infinity), vec3(infinity), between), along);
    return vec2(max(max(near.x, near.y), near.z), min(min(far.x, far.y), far.z));
}

float intersect(Ray ray, Box box) {
    vec2 span = span_within(ray, box.lo, box.hi);
    return span.x <= span.y ? first_ahead(span.x, span.y) : no_hit;
}

// The face that was hit is the one whose plane the ray meets nearest to t.
Surface surface(Ray ray, float t, Box box) {
    vec3 point = clamp(point_at(ray, t), box.lo, box.hi), normal = vec3(0, 1, 0), exact = point;
    float best = infinity;
    for (int face = 0; face < 6; ++face) {
        int axis = face / 2;
        bool high = ((face & 1) == 0) == (ray.direction[axis] < 0); // the near face first
        float coordinate = high ? box.hi[axis] : box.lo[axis];
        float off = abs((coordinate - ray.origin[axis]) / ray.direction[axis] - t);
        if (off < best) {
            best = off;
            normal = vec3(axis == 0, axis == 1, axis == 2) * (high ? 1 : -1);
            exact = mix(point, vec3(coordinate), abs(normal));
        }
    }
    vec2 uv = vec2(0);
#ifdef HAS_TEXTURE
    Frame frame = frame_around(normal);
    vec3 extent = box.hi - box.lo, from_middle = exact - 0.5 * (box.lo + box.hi);
    vec2 size = abs(in_frame(extent, frame));
    uv = vec2(0.5) + mix(vec2(0), in_frame(from_middle, frame) / size, greaterThan(size, vec2(0)));
#endif
    return Surface(exact, normal, normal, uv, norm_1(exact) + norm_1(box.lo) + norm_1(box.hi), box.material);
}
