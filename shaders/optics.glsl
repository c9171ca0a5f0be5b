// Mirror, Snell and Fresnel (chapters 06 and 07), in float.
vec3 mirror_direction(vec3 direction, vec3 normal) { return direction - 2 * dot(direction, normal) * normal; }

#ifdef HAS_GLASS
// (n_to cos t)^2 = n_to^2 - n_from^2 + (n_from cos i)^2: below 0 the light is totally reflected.
float refracted_square(float cos_i, float n_from, float n_to) {
    precise float square = (n_to - n_from) * (n_to + n_from) + (n_from * cos_i) * (n_from * cos_i);
    return square;
}

// The shares that are mirrored and let through: (a - b)^2 and 4 a b over their own sum, so that R + T = 1.
vec2 divided(float a, float b) {
    float mirrored = (a - b) * (a - b), passed = 4 * a * b, sum = mirrored + passed;
    return sum > 0 ? vec2(mirrored, passed) / sum : vec2(1, 0);
}
vec2 fresnel(float cos_i, float n_from, float n_to) {
    float square = refracted_square(cos_i, n_from, n_to);
    if (!(square >= 0))
        return vec2(1, 0);
    float along = sqrt(square); // n_to cos t
    float across = n_from * cos_i;
    return 0.5 * (divided(across, along) + divided(n_to * cos_i, n_from * along / n_to));
}

vec3 refracted_direction(vec3 direction, vec3 normal, float n_from, float n_to) {
    float along = dot(direction, normal), cos_i = min(abs(along), 1);
    float ratio = n_from / n_to, cos_t = sqrt(max(refracted_square(cos_i, n_from, n_to), 0)) / n_to;
    float change = ratio * cos_i - cos_t;
    return normalize(ratio * direction + (along < 0 ? change : -change) * normal);
}
#endif
