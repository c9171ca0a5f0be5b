// Lesson 02, beside the way: how often a printed formula is right, counted on rays whose answer is plain.
#pragma once
#include "chapters/02_primitives/errata.hpp"
#include "common/random.hpp"
#include "common/report.hpp"

namespace course {

// What became of a number of rays that all point at the axis of an upright shape, so that all of them hit it.
struct Tally {
    int right = 0;     // the reported point lies on the shape
    int missed = 0;    // nothing reported
    int elsewhere = 0; // the reported point lies off the shape
};

// form(ray) is the test, off(point) the distance from the shape. The rays have length one, come from five units away
// and point at the axis between the heights 0.5 and 1.9; `across` sends them perpendicularly to it.
template <class Form, class Off> Tally tally(const Form &form, const Off &off, bool across = false) {
    Tally result;
    for (std::uint64_t i = 0; i < 10000; ++i) {
        Random random(34, i);
        const double angle = random.uniform(0, 2 * pi), z = random.uniform(0.5, 1.9), low = random.uniform(-3, 7);
        const Vec<double> from(5 * std::cos(angle), 5 * std::sin(angle), across ? z : low);
        const Ray<double> ray{from, normalize(Vec<double>(0, 0, z) - from)};
        const auto t = form(ray);
        ++(!t ? result.missed : off(point_at(ray, *t)) < 1e-9 ? result.right : result.elsewhere);
    }
    return result;
}

// The shapes of the tally, and the distance of a point from their sides.
inline const Cylinder<> tally_cylinder{{0, 0, 0}, {0, 0, 4}, 1};
inline const Cone<> tally_cone{{0, 0, 0}, {0, 0, 2}, 1};
inline double off_cylinder(const Vec<double> &p) { return std::abs(std::hypot(p.x, p.y) - 1); }
inline double off_cone(const Vec<double> &p) { return std::abs(2 * std::hypot(p.x, p.y) - p.z) / std::sqrt(5.0); }

inline std::vector<Row> errata_rows() {
    std::vector<Row> rows;
    const auto add = [&](const char *shape, const char *form, const char *rays, const Tally &count) {
        rows.push_back(Row().set("shape", shape).set("form", form).set("rays", rays));
        rows.back().set("right", count.right).set("missed", count.missed).set("elsewhere", count.elsewhere);
    };
    for (const bool across : {true, false}) {
        const char *rays = across ? "across the axis" : "slanted";
        const auto count = [&](const auto &form, const auto &off) { return tally(form, off, across); };
        add("cylinder", "A eq. 34 as printed", rays,
            count([](const auto &ray) { return intersect_as_printed(ray, tally_cylinder); }, off_cylinder));
        add("cylinder", "derived", rays,
            count([](const auto &ray) { return intersect(ray, tally_cylinder); }, off_cylinder));
        add("cone", "A eq. 40 as printed", rays,
            count([](const auto &ray) { return intersect_as_printed(ray, tally_cone); }, off_cone));
        add("cone", "derived", rays, count([](const auto &ray) { return intersect(ray, tally_cone); }, off_cone));
    }
    return rows;
}

} // namespace course
