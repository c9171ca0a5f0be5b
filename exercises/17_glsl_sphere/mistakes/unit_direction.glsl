// Mistake: the direction is taken to have length one.
// Caught by: the direction may have any length
float hit_sphere(vec3 origin, vec3 direction, vec3 centre, float radius) {
    vec3 to_centre = centre - origin, miss = cross(to_centre, direction);
    float a = 1, b = dot(to_centre, direction);
    float discriminant = radius * radius * a - dot(miss, miss);
    if (!(discriminant >= 0))
        return -1;
    float c = dot(to_centre, to_centre) - radius * radius;
    float q = b >= 0 ? b + sqrt(discriminant) : b - sqrt(discriminant);
    float near = b >= 0 ? c / q : q / a, far = b >= 0 ? q / a : c / q;
    return near > 0 ? near : far > 0 ? far : -1;
}
