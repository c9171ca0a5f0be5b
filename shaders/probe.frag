// A shape's own test, asked by itself: one ray and one shape to a pixel, and t is the pixel. This is how the hard cases
// of ./course accuracy come to the very lines that the tracer draws with.
#include "ray.glsl"
#include "scene.glsl"
#include "sphere.glsl"
#include "plane.glsl"
#include "disk.glsl"
#include "quadratic.glsl"
#include "cylinder.glsl"
#include "cone.glsl"
#include "box.glsl"
#include "triangle.glsl"

uniform samplerBuffer rays; // two texels a ray: origin and t_max, direction and t_min

layout(location = 0) out vec4 found;

void main() {
    int at = int(gl_FragCoord.y) * ROW + int(gl_FragCoord.x);
    vec4 origin = texelFetch(rays, 2 * at), direction = texelFetch(rays, 2 * at + 1);
    Ray ray = Ray(origin.xyz, direction.xyz, origin.w);
    float t = intersect(ray, SHAPE_AT(at * SHAPE_SIZE));
    bool hit = t > 0 && t < ray.t_max;                      // as closest.glsl asks
    found = vec4(hit && !(t <= direction.w) ? t : no_hit); // the tracer's rays have no t_min: they begin at 0
}
