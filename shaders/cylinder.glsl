// The side of a cylinder: |(m + t d) x n|^2 = r^2 |n|^2, with the discriminant from the distance of ray and axis.
struct Cylinder {
    vec3 bottom, top;
    float radius;
    int material;
};

const int cylinder_size = 2; // texels
Cylinder cylinder_at(int at) {
    vec4 low = texelFetch(scene, at), high = texelFetch(scene, at + 1);
    return Cylinder(low.xyz, high.xyz, low.w, int(high.w));
}

float intersect(Ray ray, Cylinder cylinder) {
    vec3 n = cylinder.top - cylinder.bottom, m = ray.origin - cylinder.bottom;
    vec3 w = precise_cross(ray.direction, n), q = precise_cross(m, n);
    float r = cylinder.radius, nn = precise_dot(n, n), ww = precise_dot(w, w), mw = precise_dot(m, w);
    float discriminant = nn * (r * r * ww - mw * mw);
    if (!(discriminant >= 0))
        return no_hit;
    vec2 t = roots(ww, precise_dot(w, q), precise_dot(q, q) - r * r * nn, discriminant);
    vec2 height = precise_dot(m, n) + t * precise_dot(ray.direction, n);
    return first_ahead(height.x >= 0 && height.x <= nn ? t.x : no_hit, height.y >= 0 && height.y <= nn ? t.y : no_hit);
}

Surface surface(Ray ray, float t, Cylinder cylinder) {
    vec3 n = cylinder.top - cylinder.bottom, m = point_at(ray, t) - cylinder.bottom;
    float share = dot(m, n) / dot(n, n);
    vec3 normal = normalize(m - share * n);
    vec3 point = cylinder.bottom + clamp(share, 0, 1) * n + cylinder.radius * normal;
    vec2 uv = vec2(0);
#ifdef HAS_TEXTURE
    uv = uv_along(cylinder.bottom, n, point);
#endif
    float reach = norm_1(point) + norm_1(cylinder.bottom) + norm_1(cylinder.top) + cylinder.radius;
    return Surface(point, normal, normal, uv, reach, cylinder.material);
}
