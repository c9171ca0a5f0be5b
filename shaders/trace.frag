// The tracer: one ray for each pixel and pass. What the scene does not hold is not compiled.
#include "ray.glsl"
#include "scene.glsl"
#if defined(HAS_TEXTURE) || defined(SKY_PICTURE) || defined(SKY_BOX)
#include "frame.glsl"
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

#ifdef COMPUTE
#include "trace_compute.glsl"
#else
layout(location = 0) out vec4 colour; // added up over the passes; w counts them
layout(location = 1) out vec4 counts; // rays, rays that the stack did not keep, 1 where the loops were cut short

void main() {
    colour = vec4(trace(camera_ray(floor(gl_FragCoord.xy) + sample_place)), 1);
    counts = vec4(rays_traced, rays_not_kept, out_of_steps, 0);
}
#endif
