// The same tracer as a compute shader: no triangle, no rasteriser; squares of 8 x 8 pixels, each added to its texel.
layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba32f, binding = 0) uniform image2D colours;
layout(rgba32f, binding = 1) uniform image2D counts;

uniform ivec2 size; // of what is drawn

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (pixel.x >= size.x || pixel.y >= size.y)
        return;
    vec4 colour = vec4(trace_pixel(vec2(pixel)), 1);
    imageStore(colours, pixel, imageLoad(colours, pixel) + colour);
    imageStore(counts, pixel, imageLoad(counts, pixel) + vec4(rays_traced, rays_not_kept, out_of_steps, 0));
}
