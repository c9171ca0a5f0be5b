// The disk, and chapter 07's disk with a hole: both rims belong to it.
struct Disk {
    vec3 centre, normal;
    float radius, hole;
    int material;
};

const int disk_size = 3; // texels
Disk disk_at(int at) {
    vec4 round = texelFetch(scene, at), facing = texelFetch(scene, at + 1);
    return Disk(round.xyz, facing.xyz, round.w, facing.w, int(texelFetch(scene, at + 2).x));
}

float intersect(Ray ray, Disk disk) {
    vec3 from_centre = ray.origin - disk.centre;
    float t = -precise_dot(disk.normal, from_centre) / precise_dot(disk.normal, ray.direction);
    from_centre += t * ray.direction;
    float distance_squared = precise_dot(from_centre, from_centre);
    bool inside = distance_squared <= disk.radius * disk.radius;
#ifdef HAS_HOLE
    inside = inside && distance_squared >= disk.hole * disk.hole;
#endif
    return inside && t > 0 ? t : no_hit;
}

Surface surface(Ray ray, float t, Disk disk) {
    vec3 normal = normalize(disk.normal), point = onto_plane(point_at(ray, t), disk.centre, normal);
    vec2 uv = vec2(0);
#ifdef HAS_TEXTURE
    uv = in_frame((point - disk.centre) / (2 * disk.radius), frame_around(disk.normal)) + 0.5;
#endif
    return Surface(point, normal, normal, uv, norm_1(point) + norm_1(disk.centre), disk.material);
}
