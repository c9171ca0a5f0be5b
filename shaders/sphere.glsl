// The sphere, by the cross product (A eq. 23), which measures the miss distance directly and so does not cancel.
struct Sphere {
    vec3 centre;
    float radius;
    int material;
};

const int sphere_size = 2; // texels
Sphere sphere_at(int at) {
    vec4 round = texelFetch(scene, at);
    return Sphere(round.xyz, round.w, int(texelFetch(scene, at + 1).x));
}

float intersect(Ray ray, Sphere sphere) {
    vec3 to_centre = sphere.centre - ray.origin;
    vec3 miss = precise_cross(to_centre, ray.direction);
    float a = precise_dot(ray.direction, ray.direction), b = precise_dot(to_centre, ray.direction);
    float discriminant = sphere.radius * sphere.radius * a - precise_dot(miss, miss);
    if (!(discriminant >= 0))
        return no_hit;
    float c = precise_dot(to_centre, to_centre) - sphere.radius * sphere.radius;
    float root = sqrt(discriminant), sum = b >= 0 ? b + root : b - root; // adds numbers of the same sign
    return b >= 0 ? first_ahead(c / sum, sum / a) : first_ahead(sum / a, c / sum);
}

Surface surface(Ray ray, float t, Sphere sphere) {
    vec3 normal = normalize(point_at(ray, t) - sphere.centre);
    vec3 point = sphere.centre + sphere.radius * normal;
    vec2 uv = vec2(0);
#ifdef HAS_TEXTURE
    uv = spherical_uv(normal);
#endif
    return Surface(point, normal, normal, uv, norm_1(point) + norm_1(sphere.centre) + sphere.radius, sphere.material);
}
