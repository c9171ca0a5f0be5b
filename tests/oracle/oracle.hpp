// The oracle: where a ray meets a shape, decided in exact arithmetic.
//
// Every number handed in is taken for exactly what it is, a double (or a float, which every double can hold); nothing
// is normalised and nothing is rounded on the way to a decision. Only the t that comes back is rounded, in the end.
// The work is done in oracle.cpp, which alone knows CGAL.
#pragma once
#include "chapters/01_ray_casting/ray.hpp"

namespace course::exact {

enum class Verdict {
    miss,
    hit,
    boundary // triangles only: the ray meets an edge or a corner, and a lone triangle may say either
};

struct Answer {
    Verdict verdict = Verdict::miss;
    double t = infinity<double>; // of the nearest hit in range, within 2^-44 of it; on a miss, infinity

    bool may_hit() const { return verdict != Verdict::miss; }
    bool may_miss() const { return verdict != Verdict::hit; }
};

// A hit counts for t_min < t < t_max, compared exactly. Every shape is closed: a touch is a hit. A ray that runs
// within the surface itself (in a plane, along a cylinder's wall) misses, and so does a direction of zero. All numbers
// must be finite (t_max may be infinite) and radii positive.
using Line = Ray<double>;
using Point = Vec<double>;

Answer plane(const Line &, const Point &point, const Vec<double> &normal);
Answer disk(const Line &, const Point &centre, const Vec<double> &normal, double radius);
Answer triangle(const Line &, const Point &a, const Point &b, const Point &c);
// The triangle of points p with n · (p - corner) = 0 and u, v, 1 - u - v >= 0, where u = k1 · (p - corner) and
// v = k2 · (p - corner).
Answer affine_triangle(const Line &, const Point &corner, const Vec<double> &normal, const Vec<double> &k1,
                       const Vec<double> &k2);
Answer sphere(const Line &, const Point &centre, double radius);

// The solid's surface: where the ray enters or, from inside, where it leaves. A ray within a face counts, since a box
// that bounds something must not lose it.
Answer box(const Line &, const Point &lo, const Point &hi);

// The wall between the two end circles, and the wall between the apex and the base circle; no caps.
Answer cylinder(const Line &, const Point &bottom, const Point &top, double radius);
Answer cone(const Line &, const Point &apex, const Point &base, double radius);

// Snell's law: whether n_from sin i > n_to for the angle with that cosine, in [0, 1].
bool totally_reflects(double cosine, double n_from, double n_to);

// How many answers needed exact rationals because intervals could not decide, and how many were given, on all threads.
struct Tally {
    unsigned long long answers, exact;
};
Tally tally();

} // namespace course::exact
