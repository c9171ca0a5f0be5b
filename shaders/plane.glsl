// The plane through a point. The equation n p + W = 0 (A eq. 16) is not used: far away its terms are large and cancel.
struct Plane {
    vec3 point, normal;
    int material;
};

const int plane_size = 2; // texels
Plane plane_at(int at) {
    vec4 point = texelFetch(scene, at);
    return Plane(point.xyz, texelFetch(scene, at + 1).xyz, int(point.w));
}

float plane_parameter(Ray ray, vec3 point, vec3 normal) {
    return precise_dot(normal, point - ray.origin) / precise_dot(normal, ray.direction);
}

float intersect(Ray ray, Plane plane) {
    float t = plane_parameter(ray, plane.point, plane.normal);
    return t > 0 && t < infinity ? t : no_hit;
}

vec3 onto_plane(vec3 p, vec3 point, vec3 normal) { return p - dot(p - point, normal) * normal; }

Surface surface(Ray ray, float t, Plane plane) {
    vec3 normal = normalize(plane.normal), point = onto_plane(point_at(ray, t), plane.point, normal);
    vec2 uv = vec2(0);
#ifdef HAS_TEXTURE
    uv = in_frame(point - plane.point, frame_around(plane.normal));
#endif
    return Surface(point, normal, normal, uv, norm_1(point) + norm_1(plane.point), plane.material);
}
