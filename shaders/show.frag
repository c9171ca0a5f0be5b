// The mean of the passes on the screen, sRGB-encoded. A coarse picture is stretched.
uniform sampler2D sums;
uniform vec2 scale; // texels of the sums for each pixel of the screen
uniform int height; // of the screen, whose rows count from below

layout(location = 0) out vec4 colour;

void main() {
    vec2 pixel = vec2(gl_FragCoord.x, float(height) - gl_FragCoord.y);
    vec4 sum = texelFetch(sums, min(ivec2(pixel * scale), textureSize(sums, 0) - 1), 0);
    vec3 linear = clamp(sum.rgb / sum.w, 0, 1);
    colour = vec4(mix(12.92 * linear, 1.055 * pow(linear, vec3(1 / 2.4)) - 0.055, greaterThan(linear, vec3(0.0031308))), 1);
}
