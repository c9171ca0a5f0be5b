// Rays and hits, as chapter 01 has them, in float. A ray begins at t = 0; a hit counts for 0 < t < t_max.
struct Ray {
    vec3 origin, direction;
    float t_max;
};

const float infinity = 1.0 / 0.0;
const float no_hit = -1.0; // what an intersection returns beside t > 0

vec3 point_at(Ray ray, float t) { return ray.origin + t * ray.direction; }

// The sum from the left, rounded after each step, on every driver alike: a compiler may reorder and fuse dot().
float precise_dot(vec3 a, vec3 b) {
    precise float sum = a.x * b.x + a.y * b.y + a.z * b.z;
    return sum;
}

vec3 precise_cross(vec3 a, vec3 b) {
    precise vec3 v = a.yzx * b.zxy - a.zxy * b.yzx;
    return v;
}

// The first of two roots in ascending order that lies before the ray's eye; NaN and infinity do not.
float first_ahead(float near, float far) { return near > 0 ? near : far > 0 ? far : no_hit; }

// What shading needs of the hit that won. `reach` is the size of the numbers that the point was made of.
struct Surface {
    vec3 point, normal, shading_normal;
    vec2 uv;
    float reach;
    int material;
};

float norm_1(vec3 v) { return abs(v.x) + abs(v.y) + abs(v.z); }

// How far a computed point may lie from its shape: chapter 03's bound, 32 roundings, with float's rounding.
float rounding_bound(float reach) { return reach / 524288.0; } // 2^-19

// The ray that leaves the surface: moved along the normal to the side to which it goes (chapter 03).
Ray spawn_ray(Surface surface, vec3 direction, float t_max) {
    float offset = rounding_bound(surface.reach);
    vec3 aside = dot(direction, surface.normal) < 0 ? -surface.normal : surface.normal;
    return Ray(surface.point + offset * aside, direction, t_max);
}
