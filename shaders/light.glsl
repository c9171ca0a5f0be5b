// Lamps and their shadows (chapter 03): what reaches a point straight from them. A lamp is LAMP_SIZE texels of the scene:
// place and kind, intensity; of a lamp with an area, radiance, its two sides or half-axes, and its area along its normal.
const int POINT_LAMP = 0, RECTANGLE_LAMP = 1, DISK_LAMP = 2;

struct Lamp {
    vec3 place, light, area;
    bool has_area;
};

#ifdef HAS_AREA_LIGHT
#include "random.glsl"
uniform vec2 lamp_cell; // of each lamp's strata x strata cells the one that this pass samples
uniform float strata;

// The place on the lamp that this pixel sees in this pass.
vec3 place_on(int at, int kind, vec3 corner) {
    vec2 uv = lamp_cell;
    uv.x += random(); // one after the other, as chapter 03 draws them
    uv.y += random();
    uv /= strata;
    if (kind == DISK_LAMP) // a ring's area grows with the square of its radius, hence the root
        uv = sqrt(uv.x) * vec2(cos(2 * pi * uv.y), sin(2 * pi * uv.y));
    return corner + uv.x * texelFetch(scene, at + 2).xyz + uv.y * texelFetch(scene, at + 3).xyz;
}
#endif

Lamp lamp_at(int at) {
    vec4 place = texelFetch(scene, at);
    Lamp lamp = Lamp(place.xyz, texelFetch(scene, at + 1).rgb, vec3(0), place.w != POINT_LAMP);
#ifdef HAS_AREA_LIGHT
    if (lamp.has_area) {
        lamp.place = place_on(at, int(place.w), place.xyz);
        lamp.area = texelFetch(scene, at + 4).xyz / pi;
    }
#endif
    return lamp;
}

vec3 direct_light(Surface surface, vec3 facing_normal) {
    vec3 sum = vec3(0);
    int i;
    for (i = 0; i < lights.y; ++i) {
        Lamp lamp = lamp_at(lights.x + LAMP_SIZE * i);
        vec3 to_light = lamp.place - surface.point;
        float far = length(to_light);
        vec3 direction = to_light / far;
        float share = dot(direction, facing_normal);
        if (lamp.has_area) // the less, the more aslant it is seen
            share *= max(-dot(lamp.area, direction), 0);
        if (share > 0) {
            // A lamp is not in its own way.
            float t_max = far - rounding_bound(norm_1(surface.point) + norm_1(lamp.place));
            if (!any_hit(spawn_ray(surface, direction, t_max)))
                sum += share / (far * far) * lamp.light;
        }
    }
    if (i < lights.y)
        out_of_steps = true;
    return sum;
}
