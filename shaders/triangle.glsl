// The triangle as note A stores it: p = corner + u e1 + v e2 with u = k1 (p - corner), v = k2 (p - corner) (A eq. 17
// to 22). triangles.vert has worked out normal, k1 and k2 on the GPU.
uniform samplerBuffer triangles;
#ifdef HAS_NORMALS
uniform samplerBuffer normals; // three for each triangle, 0 for a flat one
#endif

struct Triangle {
    vec3 corner, normal, k1, k2;
    int material, at;
};

const int triangle_size = 4; // texels
Triangle triangle_at(int at) {
    vec4 corner = texelFetch(triangles, at);
    return Triangle(corner.xyz, texelFetch(triangles, at + 1).xyz, texelFetch(triangles, at + 2).xyz,
                    texelFetch(triangles, at + 3).xyz, int(corner.w), at);
}

// Edges belong to the triangle; one without area has no finite k1 and is never hit.
float intersect(Ray ray, Triangle triangle) {
    vec3 from_corner = ray.origin - triangle.corner;
    float t = -precise_dot(triangle.normal, from_corner) / precise_dot(triangle.normal, ray.direction);
    from_corner += t * ray.direction;
    float u = precise_dot(triangle.k1, from_corner), v = precise_dot(triangle.k2, from_corner);
    return u >= 0 && v >= 0 && u + v <= 1 && t > 0 ? t : no_hit;
}

Surface surface(Ray ray, float t, Triangle triangle) {
    vec3 normal = normalize(triangle.normal), point = onto_plane(point_at(ray, t), triangle.corner, normal);
    vec2 uv = vec2(dot(triangle.k1, point - triangle.corner), dot(triangle.k2, point - triangle.corner));
    vec3 smooth_normal = normal;
#ifdef HAS_NORMALS
    int first = triangle.at / triangle_size * 3;
    vec3 mean = (1 - uv.x - uv.y) * texelFetch(normals, first).xyz + uv.x * texelFetch(normals, first + 1).xyz +
                uv.y * texelFetch(normals, first + 2).xyz;
    if (dot(mean, mean) > 0)
        smooth_normal = normalize(mean);
#endif
    return Surface(point, normal, smooth_normal, uv, norm_1(point) + norm_1(triangle.corner), triangle.material);
}
