// Point lights and their shadows (chapter 03): what reaches a point straight from the lamps. Each is two texels of the
// scene: position, intensity.

vec3 direct_light(Surface surface, vec3 facing_normal) {
    vec3 sum = vec3(0);
    int i;
    for (i = 0; i < lights.y; ++i) {
        vec3 place = texelFetch(scene, lights.x + 2 * i).xyz, intensity = texelFetch(scene, lights.x + 2 * i + 1).rgb;
        vec3 to_light = place - surface.point;
        float far = length(to_light);
        vec3 direction = to_light / far;
        float cosine = dot(direction, facing_normal);
        if (cosine > 0) {
            float t_max = far - rounding_bound(norm_1(surface.point) + norm_1(place)); // a lamp is not in its own way
            if (!any_hit(spawn_ray(surface, direction, t_max)))
                sum += cosine / (far * far) * intensity;
        }
    }
    if (i < lights.y)
        out_of_steps = true;
    return sum;
}
