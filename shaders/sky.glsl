// What a ray sees that meets nothing: one of chapter 05's skies, or chapter 08's studio.
#ifdef SKY_CONSTANT
uniform vec3 sky_colour;
vec3 sky_radiance(vec3 direction) { return sky_colour; }
#endif

#ifdef SKY_GRADIENT
uniform vec3 sky_horizon, sky_zenith, sky_ground;
vec3 sky_radiance(vec3 direction) {
    if (direction.y < 0)
        return sky_ground;
    return mix(sky_horizon, sky_zenith, sqrt(direction.y / length(direction)));
}
#endif

#ifdef SKY_PICTURE
uniform int sky_table; // where the scene's buffer describes the picture
vec3 sky_radiance(vec3 direction) {
    vec2 globe = spherical_uv(direction);
    return picture_colour(sky_table, vec2(rest(1.75 - globe.x), globe.y));
}
#endif

#ifdef SKY_BOX
uniform int sky_table; // six pictures in a row: +x -x +y -y +z -z
vec3 sky_radiance(vec3 direction) {
    vec3 size = abs(direction);
    int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    vec3 normal = vec3(axis == 0, axis == 1, axis == 2) * (direction[axis] < 0 ? -1 : 1);
    vec2 outside = 0.5 + 0.5 * in_frame(direction / size[axis], frame_around(normal));
    return picture_colour(sky_table + 2 * axis + int(direction[axis] < 0), vec2(1 - outside.x, outside.y));
}
#endif

#ifdef SKY_STUDIO
vec3 sky_radiance(vec3 direction) {
    return mix(vec3(0.13, 0.135, 0.15), vec3(0.015, 0.018, 0.026), 0.5 + 0.5 * normalize(direction).y);
}
// The little light that a room sends from everywhere, more from above.
vec3 ambient(vec3 normal) { return (0.6 + 0.4 * normal.y) * vec3(0.085, 0.095, 0.115); }
#endif
