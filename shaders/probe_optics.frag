// Glass, asked by itself: one boundary between two media to a pixel. The pixel is the shares that are mirrored and let
// through, and where the light goes that passes, in the plane of incidence (0, 0: nowhere, all of it is mirrored).
#include "optics.glsl"

uniform samplerBuffer boundaries; // cosine and sine of the angle of incidence, the indices before and behind

layout(location = 0) out vec4 found;

void main() {
    vec4 given = texelFetch(boundaries, int(gl_FragCoord.y) * ROW + int(gl_FragCoord.x));
    float cos_i = given.x, n_from = given.z, n_to = given.w;
    vec3 direction = vec3(given.y, 0, -cos_i), passed = vec3(0);
    if (refracted_square(cos_i, n_from, n_to) >= 0)
        passed = refracted_direction(direction, vec3(0, 0, 1), n_from, n_to);
    found = vec4(fresnel(cos_i, n_from, n_to), passed.xz);
}
