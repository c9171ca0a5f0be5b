// An example for ./course accuracy --kernel tests/hard_cases/example_kernel.cpp: the sphere test that most books print.
//
// Define any of these, with float or with double in place of T; the shape's numbers are always floats. Return t of the
// nearest hit with t_min < t < t_max, or a negative number for a miss. The direction has any length.
//   T sphere  (const T o[3], const T d[3], T t_min, T t_max, const float centre[3], float radius)
//   T plane   (const T o[3], const T d[3], T t_min, T t_max, const float point[3], const float normal[3])
//   T disk    (const T o[3], const T d[3], T t_min, T t_max, const float centre[3], const float normal[3], float
//   radius) T triangle(const T o[3], const T d[3], T t_min, T t_max, const float a[3], const float b[3], const float
//   c[3]) T box     (const T o[3], const T d[3], T t_min, T t_max, const float lo[3], const float hi[3]) T
//   cylinder(const T o[3], const T d[3], T t_min, T t_max, const float bottom[3], const float top[3], float radius) T
//   cone    (const T o[3], const T d[3], T t_min, T t_max, const float apex[3], const float base[3], float radius)
#include <cmath>

namespace {
float dot(const float a[3], const float b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
} // namespace

float sphere(const float o[3], const float d[3], float t_min, float t_max, const float centre[3], float radius) {
    const float f[3] = {o[0] - centre[0], o[1] - centre[1], o[2] - centre[2]};
    const float a = dot(d, d), b = 2 * dot(f, d), c = dot(f, f) - radius * radius;
    const float discriminant = b * b - 4 * a * c;
    if (discriminant < 0)
        return -1;
    const float root = std::sqrt(discriminant), near = (-b - root) / (2 * a), far = (-b + root) / (2 * a);
    if (near > t_min && near < t_max)
        return near;
    return far > t_min && far < t_max ? far : -1;
}
