// H11: a ray that starts on a surface must not meet it again (acne), nor start beyond what is close by (leak).
#include "chapters/03_light_and_shadow/spawn.hpp"
#include "chapters/08_mesh/triangle.hpp"
#include "tests/hard_cases/aim.hpp"
#include "tests/hard_cases/measure.hpp"
#include "tests/hard_cases/rows.hpp"
#include "tests/hard_cases/suites.hpp"

namespace course::hard {
namespace {

template <class Shape> Shape made(Random &random, double scale, const Vec<double> &centre);

template <> Sphere<> made(Random &random, double scale, const Vec<double> &centre) {
    return {Vec<float>(centre), static_cast<float>(scale * random.uniform(0.3, 1))};
}
template <> Plane<> made(Random &random, double, const Vec<double> &centre) {
    return {Vec<float>(centre), Vec<float>(unit_vector(random))};
}
template <> Disk<> made(Random &random, double scale, const Vec<double> &centre) {
    return {Vec<float>(centre), Vec<float>(unit_vector(random)), static_cast<float>(scale)};
}
template <> Triangle<> made(Random &random, double scale, const Vec<double> &centre) {
    const auto corner = [&] { return Vec<float>(centre + in_cube(random, scale)); };
    return {corner(), corner(), corner()};
}
template <> AffineTriangle<> made(Random &random, double scale, const Vec<double> &centre) {
    const Triangle<> corners = made<Triangle<>>(random, scale, centre);
    return affine_triangle(corners.a, corners.b, corners.c);
}
template <> Box<> made(Random &random, double scale, const Vec<double> &centre) {
    const Vec<double> half =
        scale * Vec<double>(random.uniform(0.2, 1), random.uniform(0.2, 1), random.uniform(0.2, 1));
    return {Vec<float>(centre - half), Vec<float>(centre + half)};
}
template <> Cylinder<> made(Random &random, double scale, const Vec<double> &centre) {
    const Vec<double> half = scale * unit_vector(random);
    return {Vec<float>(centre - half), Vec<float>(centre + half), static_cast<float>(scale * random.uniform(0.2, 1))};
}
template <> Cone<> made(Random &random, double scale, const Vec<double> &centre) {
    const Vec<double> half = scale * unit_vector(random);
    return {Vec<float>(centre - half), Vec<float>(centre + half), static_cast<float>(scale * random.uniform(0.2, 1))};
}

template <class Shape> constexpr bool is_closed =
    std::is_same_v<Shape, Sphere<>> || std::is_same_v<Shape, Box<>>; // has an inside all around
template <class Shape> constexpr bool is_wall =
    std::is_same_v<Shape, Cylinder<>> || std::is_same_v<Shape, Cone<>>; // convex, with open ends

// Whether the oracle agrees with the default kernel about the spawned ray: false hits are acne, false misses leaks.
template <class Shape> void ask_kernel(const Ray<double> &spawned, const Shape &shape, bool &acne, bool &leak) {
    const auto truth = exact::answer(spawned, shape);
    const bool hit = intersect(spawned, shape).has_value();
    acne = acne || (hit && !truth.may_hit());
    leak = leak || (!hit && !truth.may_miss());
}

// Whether a point of a wall lies next to one of its ends, where the way straight out passes the rim.
template <class Shape> bool next_to_an_end(const Shape &shape, const Vec<double> &point) {
    const auto between = [&](const Vec<double> &from, const Vec<double> &to) {
        const double height = dot(point - from, to - from) / dot(to - from, to - from);
        return !(height > 1e-6 && height < 1 - 1e-6);
    };
    if constexpr (std::is_same_v<Shape, Cylinder<>>)
        return between(Vec<double>(shape.bottom), Vec<double>(shape.top));
    else
        return between(Vec<double>(shape.apex), Vec<double>(shape.base));
}

// One hit and one ray that leaves from it; constant_offset > 0: note A's way, that many sizes of the shape back.
template <class Shape>
void spawn_one(Random &random, double scale, double away, double grazing, double constant_offset, SpawnTally &tally) {
    const Vec<double> centre = as_float(away * scale * unit_vector(random));
    const auto shape = made<Shape>(random, scale, centre);
    const Ray<double> ray =
        aimed(random, centre + 5 * scale * unit_vector(random), centre + in_cube(random, 0.6 * scale));
    const auto t = intersect(ray, shape);
    if (!t)
        return;
    const auto found = surface(ray, *t, shape);
    const double side = either_sign(random);
    const Vec<double> aside = across(random, found.normal);
    const double rise = grazing > 0 ? grazing * random.uniform(0.1, 1) : std::tan(random.uniform(0, 1.5));
    Ray<double> spawned = spawn_ray(found, normalize(aside + side * rise * found.normal));
    if (constant_offset > 0) {
        const Vec<float> unit = normalize(Vec<float>(ray.direction));
        const float reach = static_cast<float>(*t * length(ray.direction));
        spawned.origin =
            Vec<double>(Vec<float>(ray.origin) + (reach - static_cast<float>(constant_offset * scale)) * unit);
        if (dot(ray.direction, found.normal) * side > 0)
            return; // it always stays on the side that the ray came from
    }
    ++tally.spawned;

    // Outside of a convex shape or a plane, a ray that leaves never meets it again. From inside, the way straight out
    // meets it (on a wall, unless that is next to an open end): then the ray starts inside indeed, and whatever it
    // meets is another place. That is the oracle's word; the test that the chapters use must agree.
    const Ray<double> straight_out{spawned.origin, found.normal};
    bool acne = false, lost = false;
    if (side > 0)
        acne = exact::answer(spawned, shape).verdict == exact::Verdict::hit;
    else if constexpr (is_closed<Shape>)
        acne = !exact::answer(straight_out, shape).may_hit();
    else if constexpr (is_wall<Shape>)
        acne = !next_to_an_end(shape, found.point) && !exact::answer(straight_out, shape).may_hit();
    else
        acne = exact::answer(spawned, shape).verdict == exact::Verdict::hit;
    ask_kernel(spawned, shape, acne, lost);
    tally.acne += acne;
    tally.leaks += lost;
    bool leaked = lost;

    const Vec<double> largest = abs(spawned.origin);
    const double ulp = std::ldexp(1.0, std::ilogb(std::max({largest.x, largest.y, largest.z})) - 23);
    const double offset = std::abs(dot(spawned.origin - found.point, found.normal));
    tally.note_offset(offset / ulp);
    for (const double gap : {1e-2, 1e-3, 1e-4, 1e-5})
        if (gap * scale >= 64 * ulp) {
            ++tally.leaks_asked;
            tally.leaks += offset >= gap * scale;
            leaked |= offset >= gap * scale;
        }
    tally.wrong += acne || leaked;
}

template <class Shape> void spawn_rows(const std::string &test, const Settings &settings, Outcome &outcome) {
    for (const double away : {2.0, 100.0})
        for (const double grazing : {0.0, 1e-2, 1e-5, 1e-7})
            for (const double constant_offset : {0.0, 1e-3}) {
                char parameter[96];
                std::snprintf(parameter, sizeof parameter, "scales 1e-3 to 1e6, %g sizes away, %s", away,
                              grazing > 0 ? ("grazing at " + std::to_string(std::lround(std::log10(grazing)))).c_str()
                                          : "any angle");
                const std::uint64_t stream = stream_of(test + parameter, settings.seed);
                SpawnTally all;
                std::mutex adding;
                const std::size_t cases = settings.cases / 4;
                parallel_for((cases + batch_size - 1) / batch_size, [&](std::size_t chunk) {
                    SpawnTally tally;
                    for (std::size_t i = chunk * batch_size; i < std::min(cases, (chunk + 1) * batch_size); ++i) {
                        Random random(stream, i);
                        const double scale = std::pow(10.0, static_cast<int>(random.bits() % 10) - 3);
                        spawn_one<Shape>(random, scale, away, grazing, constant_offset, tally);
                    }
                    const std::lock_guard lock(adding);
                    all.add(tally);
                });
                const bool is_default = constant_offset == 0;
                close_spawn_row(outcome,
                                result_row("H11", test + " spawn",
                                           is_default ? "offset by a bound" : "constant step back, 1e-3 sizes",
                                           is_default, is_default ? "double" : "float", parameter, settings),
                                std::move(all), is_default);
            }
}

Outcome spawns(const Settings &settings) {
    Outcome outcome;
    spawn_rows<Sphere<>>("sphere", settings, outcome);
    spawn_rows<Plane<>>("plane", settings, outcome);
    spawn_rows<Disk<>>("disk", settings, outcome);
    spawn_rows<AffineTriangle<>>("affine triangle", settings, outcome);
    spawn_rows<Triangle<>>("triangle", settings, outcome);
    spawn_rows<Box<>>("box", settings, outcome);
    spawn_rows<Cylinder<>>("cylinder", settings, outcome);
    spawn_rows<Cone<>>("cone", settings, outcome);
    return outcome;
}

} // namespace

Suite spawn_suite() { return {"spawned rays", {"H11"}, spawns}; }

} // namespace course::hard
