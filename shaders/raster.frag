// Rasterisation: the light of what is nearest in a pixel, with each lamp's shadow asked of its map (chapter 04). The last
// triangles are the square around the table; what lies beyond the table's rim is thrown away.
uniform samplerBuffer lamps;        // two texels each: position, intensity
uniform sampler2D shadow_maps[LAMPS]; // the depth of what each lamp sees
uniform mat4 to_lamp[LAMPS];
uniform vec3 eye, mesh_colour, table_colour, table_centre;
uniform float table_radius;
uniform int mesh_triangles;
uniform bool depth_only; // a lamp's picture

in vec3 point, normal;
layout(location = 0) out vec4 colour;

// The little light that a room sends from everywhere, as sky.glsl has it.
vec3 ambient(vec3 normal) { return (0.6 + 0.4 * normal.y) * vec3(0.085, 0.095, 0.115); }

bool in_shadow(int lamp, vec3 place) {
    vec4 seen = to_lamp[lamp] * vec4(place, 1);
    vec3 at = 0.5 + 0.5 * seen.xyz / seen.w;
    return texture(shadow_maps[lamp], at.xy).x < at.z;
}

void main() {
    bool is_table = gl_PrimitiveID >= mesh_triangles;
    if (is_table && distance(point, table_centre) > table_radius)
        discard;
    colour = vec4(0);
    if (depth_only)
        return;
    vec3 flat_normal = normalize(cross(dFdx(point), dFdy(point))), n = normal == vec3(0) ? flat_normal : normalize(normal);
    vec3 to_eye = eye - point;
    flat_normal = dot(flat_normal, to_eye) < 0 ? -flat_normal : flat_normal;
    n = dot(n, flat_normal) < 0 ? -n : n;
    vec3 light = ambient(n);
    for (int i = 0; i < LAMPS; ++i) {
        vec3 to_lamp_here = texelFetch(lamps, 2 * i).xyz - point;
        float far = length(to_lamp_here), cosine = dot(to_lamp_here, n) / far;
        // A texel is about far / RESOLUTION wide: so far off the surface the map is asked, along the normal.
        if (cosine > 0 && !in_shadow(i, point + 3 * far / RESOLUTION * flat_normal))
            light += cosine / (far * far) * texelFetch(lamps, 2 * i + 1).rgb;
    }
    colour = vec4((is_table ? table_colour : mesh_colour) * light, 1);
}
