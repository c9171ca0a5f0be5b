// What a surface does with light. A material is a record in the scene's buffer, of coefficients that are each constant,
// a checker or a picture. Only the parts that the scene's type holds are compiled.
const int coefficient_size = 4; // texels
const int DIFFUSE = 0, GLOW = 1, REFLECTION = 2, TRANSMISSION = 3, FACING = 4;
const int MEDIA = 5 * coefficient_size; // what is inside, what is outside: absorption and refractive index

vec3 coefficient(int material, int which, vec2 uv) {
    int at = material + which * coefficient_size;
    vec4 first = texelFetch(scene, at);
#ifdef HAS_TEXTURE
    if (first.w > 0) { // 1: a checker, above: a picture
        vec4 second = texelFetch(scene, at + 1), placed = texelFetch(scene, at + 2);
        vec2 place = placed.xy + uv.x * placed.zw + uv.y * texelFetch(scene, at + 3).xy;
#if defined(HAS_CHECKER) && defined(HAS_PICTURE)
        return first.w == 1 ? checker(place, first.rgb, second.rgb) : picture_colour(int(second.w), place);
#elif defined(HAS_CHECKER)
        return checker(place, first.rgb, second.rgb);
#else
        return picture_colour(int(second.w), place);
#endif
    }
#endif
    return first.rgb;
}
