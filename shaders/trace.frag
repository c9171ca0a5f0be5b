// The tracer: one ray for each pixel and pass. What the scene does not hold is not compiled.
#include "ray.glsl"
#include "scene.glsl"
#if defined(HAS_TEXTURE) || defined(SKY_PICTURE) || defined(SKY_BOX)
#define HAS_FRAME
#endif
#if defined(HAS_FRAME) || defined(HAS_AREA_LIGHT)
#include "frame.glsl"
#endif
#ifdef HAS_FRAME
#include "texture.glsl"
#endif
#ifdef HAS_SPHERE
#include "sphere.glsl"
#endif
#ifdef HAS_FLAT
#include "plane.glsl"
#endif
#ifdef HAS_DISK
#include "disk.glsl"
#endif
#ifdef HAS_QUADRIC
#include "quadratic.glsl"
#endif
#ifdef HAS_CYLINDER
#include "cylinder.glsl"
#endif
#ifdef HAS_CONE
#include "cone.glsl"
#endif
#ifdef HAS_CUBOID
#include "box.glsl"
#endif
#ifdef HAS_TRIANGLE
#include "triangle.glsl"
#endif
#ifdef HAS_QUARTIC
#include "quartic.glsl"
#endif
#ifdef HAS_MESH
#include "tree.glsl"
#endif
#include "closest.glsl"
#include "sky.glsl"
#include "material.glsl"
#ifdef HAS_DIFFUSE
#include "light.glsl"
#endif
#if defined(HAS_MIRROR) || defined(HAS_GLASS)
#include "optics.glsl"
#endif
#include "trace.glsl"
#include "camera.glsl"

uniform vec2 sample_place; // within the pixel
uniform int pass;

vec3 trace_pixel(vec2 pixel) {
#if defined(HAS_DIFFUSE) && defined(HAS_AREA_LIGHT)
    start_random(uvec2(pixel), uint(pass));
#endif
    return trace(camera_ray(pixel + sample_place));
}

#ifdef COMPUTE
#include "trace_compute.glsl"
#else
layout(location = 0) out vec4 colour; // added up over the passes; w counts them
layout(location = 1) out vec4 counts; // rays, rays that the stack did not keep, 1 where the loops were cut short

void main() {
    colour = vec4(trace_pixel(floor(gl_FragCoord.xy)), 1);
    counts = vec4(rays_traced, rays_not_kept, out_of_steps, 0);
}
#endif
