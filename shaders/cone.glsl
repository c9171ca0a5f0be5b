// The side of a cone: |p x n|^2 = (r^2 / |n|^2) (p n)^2, without the mirrored cone where p n < 0.
struct Cone {
    vec3 apex, base;
    float radius;
    int material;
};

const int cone_size = 2; // texels
Cone cone_at(int at) {
    vec4 tip = texelFetch(scene, at), foot = texelFetch(scene, at + 1);
    return Cone(tip.xyz, foot.xyz, tip.w, int(foot.w));
}

float intersect(Ray ray, Cone cone) {
    vec3 d = ray.direction, n = cone.base - cone.apex, m = ray.origin - cone.apex, w = precise_cross(d, m);
    float r = cone.radius, nn = precise_dot(n, n), wn = precise_dot(w, n), slope = r * r / nn;
    float discriminant = r * r * nn * precise_dot(w, w) - (nn + r * r) * wn * wn;
    if (!(discriminant >= 0))
        return no_hit;
    vec3 dxn = precise_cross(d, n), mxn = precise_cross(m, n);
    float dn = precise_dot(d, n), mn = precise_dot(m, n);
    float a = precise_dot(dxn, dxn) - slope * dn * dn, b = precise_dot(dxn, mxn) - slope * dn * mn,
          c = precise_dot(mxn, mxn) - slope * mn * mn;
    vec2 t = roots(a, b, c, discriminant), height = mn + t * dn;
    return first_ahead(height.x >= 0 && height.x <= nn ? t.x : no_hit, height.y >= 0 && height.y <= nn ? t.y : no_hit);
}

Surface surface(Ray ray, float t, Cone cone) {
    vec3 n = cone.base - cone.apex, m = point_at(ray, t) - cone.apex;
    float nn = dot(n, n);
    vec3 aside = m - dot(m, n) / nn * n, point = cone.apex, normal = -normalize(n);
    if (dot(aside, aside) > 0) { // else it is the apex, which has no side
        vec3 outward = normalize(aside), to_rim = n + cone.radius * outward;
        point += clamp(dot(m, to_rim) / dot(to_rim, to_rim), 0, 1) * to_rim;
        normal = normalize(nn * outward - cone.radius * n);
    }
    vec2 uv = vec2(0);
#ifdef HAS_TEXTURE
    uv = uv_along(cone.base, -n, point);
#endif
    float reach = norm_1(point) + norm_1(cone.apex) + norm_1(cone.base) + cone.radius;
    return Surface(point, normal, normal, uv, reach, cone.material);
}
