// Checkers and pictures (chapter 05). Pictures lie one behind the other in a buffer and are filtered by hand: the four
// nearest texels, with the same shares on every GPU.
uniform samplerBuffer pictures;

// x without its whole part: 0 <= result < 1, and 0 where x is not finite.
float rest(float x) {
    float r = x - floor(x);
    return r >= 0 && r < 1 ? r : 0;
}

vec3 checker(vec2 at, vec3 even, vec3 odd) {
    return (rest(at.x / 2) < 0.5) == (rest(at.y / 2) < 0.5) ? even : odd;
}

int picture_texel(float place, int count, bool repeats) {
    int i = int(floor(place));
    return repeats ? (i + count) % count : clamp(i, 0, count - 1);
}

// `table` is where the scene's buffer keeps the picture's first texel, width, height and border: 0 around, 1 repeat,
// 2 hold.
vec3 picture_colour(int table, vec2 at) {
    ivec4 picture = ivec4(texelFetch(scene, table));
    int first = picture.x, width = picture.y, height = picture.z;
    bool across = picture.w != 2, up = picture.w == 1;
    vec2 uv = vec2(across ? rest(at.x) : clamp(at.x, 0, 1), up ? rest(at.y) : clamp(at.y, 0, 1));
    vec2 place = vec2(uv.x * width, (1 - uv.y) * height) - 0.5, share = place - floor(place);
    int x0 = picture_texel(place.x, width, across), x1 = picture_texel(place.x + 1, width, across);
    int y0 = first + width * picture_texel(place.y, height, up);
    int y1 = first + width * picture_texel(place.y + 1, height, up);
    vec3 above = mix(texelFetch(pictures, y0 + x0).rgb, texelFetch(pictures, y0 + x1).rgb, share.x);
    vec3 below = mix(texelFetch(pictures, y1 + x0).rgb, texelFetch(pictures, y1 + x1).rgb, share.x);
    return mix(above, below, share.y);
}
