// Where on a shape a point lies (chapter 05): a frame around an axis, and the turn about it.
const float pi = 3.14159265358979;

struct Frame {
    vec3 e0, e1, e2;
};

// e2 is the axis; seen from its tip e0 points to the right and e1 upwards; where the axis is vertical, e0 is +x.
Frame frame_around(vec3 axis) {
    vec3 e2 = normalize(axis);
    float horizontal = sqrt(axis.x * axis.x + axis.z * axis.z);
    vec3 e0 = horizontal > 0 ? vec3(axis.z, 0, -axis.x) / horizontal : vec3(1, 0, 0);
    return Frame(e0, cross(e2, e0), e2);
}

vec2 in_frame(vec3 v, Frame frame) { return vec2(dot(v, frame.e0), dot(v, frame.e1)); }

// From 0 at e0 on towards e1: 0 <= turn < 1. atan(0, 0) may be anything, but not undefined: it is 0 here.
float turn(vec2 v) {
    float u = v == vec2(0) ? 0 : atan(v.y, v.x) / (2 * pi);
    u = u < 0 ? u + 1 : u;
    return u < 1 ? u : 0;
}

vec2 spherical_uv(vec3 d) {
    float horizontal = length(d.xz);
    float from_north = horizontal == 0 && d.y == 0 ? 0 : atan(horizontal, d.y);
    return vec2(turn(vec2(d.x, -d.z)), 1 - from_north / pi);
}

vec2 uv_along(vec3 foot, vec3 axis, vec3 point) {
    return vec2(turn(in_frame(point - foot, frame_around(axis))), dot(point - foot, axis) / dot(axis, axis));
}
