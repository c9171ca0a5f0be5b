// The roots of a t^2 + 2 b t + c = 0 in ascending order, without cancellation (chapter 02): of (-b +- s) / a one adds
// numbers of the same sign, the other follows from the product of the roots.
vec2 roots(float a, float b, float c, float discriminant) {
    float s = sqrt(discriminant), q = -(b < 0 ? b - s : b + s);
    float first = q / a, second = c / q;
    return second < first ? vec2(second, first) : vec2(first, second);
}
