// Surfaces of degree four: along a ray each is a polynomial of degree four, whose first root is found without a guess.
// Where a polynomial's slope keeps its sign there is at most one root, and signs at both ends tell; so the roots of the
// second derivative part those of the first, and they part those of the polynomial itself.
struct Quartic {
    float c0, c1, c2, c3, c4;
};

float value_of(Quartic q, float s) { return (((q.c4 * s + q.c3) * s + q.c2) * s + q.c1) * s + q.c0; }
Quartic slope_of(Quartic q) { return Quartic(q.c1, 2 * q.c2, 3 * q.c3, 4 * q.c4, 0); }

// The root between two places where the signs differ, by Newton's steps, or by halving where a step leads outside.
float root_between(Quartic q, float low, float high) {
    Quartic slope = slope_of(q);
    bool rises = value_of(q, low) < 0;
    float s = 0.5 * (low + high);
    for (int i = 0; i < 20; ++i) {
        float f = value_of(q, s);
        if ((f < 0) == rises)
            low = s;
        else
            high = s;
        float next = s - f / value_of(slope, s);
        s = next > low && next < high ? next : 0.5 * (low + high);
    }
    return s;
}

// The first root in [0, 1], or no_hit.
float first_root(Quartic q) {
    Quartic slope = slope_of(q);
    float a = 12 * q.c4, b = 3 * q.c3, c = 2 * q.c2, discriminant = b * b - a * c;
    vec2 bends = discriminant >= 0 ? clamp(roots(a, b, c, discriminant), 0, 1) : vec2(1);
    float from = 0, at_from = q.c0, root = no_hit;
    for (int piece = 0; piece < 3 && root == no_hit; ++piece) {
        float to = piece == 0 ? bends.x : piece == 1 ? bends.y : 1, turn = to;
        if ((value_of(slope, from) < 0) != (value_of(slope, to) < 0))
            turn = root_between(slope, from, to);
        float at_turn = value_of(q, turn), at_to = value_of(q, to);
        if ((at_from < 0) != (at_turn < 0))
            root = root_between(q, from, turn);
        else if ((at_turn < 0) != (at_to < 0))
            root = root_between(q, turn, to);
        from = to;
        at_from = at_to;
    }
    return root;
}

// What the implicit shapes of chapter 02 share: the box within which they are looked for.
struct Bounds {
    vec3 lo, hi;
    int material;
};

Bounds bounds_at(int at) {
    vec4 lo = texelFetch(scene, at);
    return Bounds(lo.xyz, texelFetch(scene, at + 1).xyz, int(lo.w));
}

// Numbers are counted from where the ray enters the box, in shares of its way through: however far away the eye is.
Ray within(Ray ray, Bounds bounds) {
    vec2 span = span_within(ray, bounds.lo, bounds.hi);
    float enter = max(span.x, 0);
    return Ray(point_at(ray, enter), (span.y - enter) * ray.direction, span.y - enter);
}
float whole_t(Ray ray, Ray part, Bounds bounds, float s) {
    return s < 0 ? no_hit : max(span_within(ray, bounds.lo, bounds.hi).x, 0) + s * part.t_max;
}

Surface implicit_surface(vec3 point, vec3 gradient, Bounds bounds) {
    vec3 normal = normalize(gradient);
    float reach = norm_1(point) + norm_1(bounds.lo) + norm_1(bounds.hi);
    return Surface(point, normal, normal, vec2(0), 8 * reach, bounds.material);
}

// ---- The torus: (|p|^2 + R^2 - r^2)^2 = 4 R^2 (|p|^2 - h^2), with p from the centre and h along the axis. ----
struct Torus {
    vec3 centre, axis;
    float ring, tube;
    Bounds bounds;
};

const int torus_size = 4; // texels
Torus torus_at(int at) {
    vec4 round = texelFetch(scene, at), along = texelFetch(scene, at + 1);
    return Torus(round.xyz, normalize(along.xyz), round.w, along.w, bounds_at(at + 2));
}

float intersect(Ray ray, Torus torus) {
    Ray part = within(ray, torus.bounds);
    if (!(part.t_max > 0))
        return no_hit;
    vec3 p = part.origin - torus.centre, d = part.direction;
    float dd = dot(d, d), pd = dot(p, d), pp = dot(p, p), h = dot(p, torus.axis), g = dot(d, torus.axis);
    float rr = torus.ring * torus.ring, k = pp + rr - torus.tube * torus.tube;
    return whole_t(ray, part, torus.bounds,
                   first_root(Quartic(k * k - 4 * rr * (pp - h * h), 4 * pd * k - 8 * rr * (pd - h * g),
                                      4 * pd * pd + 2 * dd * k - 4 * rr * (dd - g * g), 4 * pd * dd, dd * dd)));
}

Surface surface(Ray ray, float t, Torus torus) {
    vec3 point = point_at(ray, t), p = point - torus.centre;
    float rr = torus.ring * torus.ring, k = dot(p, p) + rr - torus.tube * torus.tube;
    return implicit_surface(point, k * p - 2 * rr * (p - dot(p, torus.axis) * torus.axis), torus.bounds);
}

// ---- The lattice blob: (x^2 - 1)^2 + (y^2 - 1)^2 + (z^2 - 1)^2 = level, in units of its size. ----
struct Blob {
    vec3 centre;
    float size, level;
    Bounds bounds;
};

const int blob_size = 4; // texels
Blob blob_at(int at) {
    vec4 round = texelFetch(scene, at);
    return Blob(round.xyz, round.w, texelFetch(scene, at + 1).x, bounds_at(at + 2));
}

float intersect(Ray ray, Blob blob) {
    Ray part = within(ray, blob.bounds);
    if (!(part.t_max > 0))
        return no_hit;
    vec3 p = (part.origin - blob.centre) / blob.size, d = part.direction / blob.size;
    vec3 e0 = p * p - 1, e1 = 2 * p * d, e2 = d * d; // x^2 - 1 = e0 + e1 s + e2 s^2
    return whole_t(ray, part, blob.bounds,
                   first_root(Quartic(dot(e0, e0) - blob.level, 2 * dot(e0, e1), dot(e1, e1) + 2 * dot(e0, e2),
                                      2 * dot(e1, e2), dot(e2, e2))));
}

Surface surface(Ray ray, float t, Blob blob) {
    vec3 point = point_at(ray, t), p = (point - blob.centre) / blob.size;
    return implicit_surface(point, p * (p * p - 1), blob.bounds);
}
