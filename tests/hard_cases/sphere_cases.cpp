// H1 to H3 and H14's easy neighbours: a sphere far away, grazed, and from next to its surface.
#include "tests/hard_cases/aim.hpp"
#include "tests/hard_cases/measure.hpp"
#include "tests/hard_cases/suites.hpp"

namespace course::hard {
namespace {

using Shape = Sphere<>;

Shape sphere_at(const Vec<double> &centre, double radius) { return {Vec<float>(centre), static_cast<float>(radius)}; }
Vec<double> centre_of(const Shape &sphere) { return Vec<double>(sphere.centre); }
double radius_of(const Shape &sphere) { return static_cast<double>(sphere.radius); }

// A ray from `eye` that passes the centre at about `impact` radii.
Case<Shape> passing(Random &random, const Shape &sphere, const Vec<double> &eye, double impact) {
    const Vec<double> aside = across(random, centre_of(sphere) - eye);
    return {aimed(random, eye, centre_of(sphere) + impact * radius_of(sphere) * aside), sphere};
}

Cell<Shape> far(double distance, const std::string &name) {
    return {"H1", "distance " + name, [=](Random &random) {
                const Vec<double> eye = in_cube(random, 2);
                const Shape sphere = sphere_at(eye + distance * unit_vector(random), 1);
                return passing(random, sphere, eye, random.uniform(0, 1.5));
            }};
}

Cell<Shape> grazing(double off, const std::string &name) {
    return {"H2", "impact 1 +- " + name, [=](Random &random) {
                const Shape sphere = sphere_at(in_cube(random, 3), over_scales(random, 0.1, 10));
                const Vec<double> eye =
                    centre_of(sphere) + radius_of(sphere) * over_scales(random, 1.5, 30) * unit_vector(random);
                // The ray that touches passes nearer to the eye's plane through the centre than 1 radius: aim there.
                const Vec<double> to_centre = centre_of(sphere) - eye;
                const double distance = length(to_centre), sine = radius_of(sphere) / distance;
                const double impact = (1 + off * random.uniform(-1, 1)) / std::sqrt(1 - sine * sine);
                return passing(random, sphere, eye, impact);
            }};
}

Cell<Shape> ground(double radius, const std::string &name) {
    return {"H3", "ground of radius " + name, [=](Random &random) {
                const Shape sphere = sphere_at({random.uniform(-3, 3), -radius, random.uniform(-3, 3)}, radius);
                const Vec<double> eye(random.uniform(-3, 3), 1, random.uniform(-3, 3));
                const double angle = random.uniform(0, 2 * pi), ahead = over_scales(random, 0.1, 3 * radius);
                return Case<Shape>{
                    aimed(random, eye, {eye.x + ahead * std::cos(angle), 0, eye.z + ahead * std::sin(angle)}), sphere};
            }};
}

Cell<Shape> next_to(double gap, const std::string &name) {
    return {"H3", "origin " + name + " radii off the surface", [=](Random &random) {
                const Shape sphere = sphere_at(in_cube(random, 4), over_scales(random, 0.1, 10));
                const Vec<double> normal = unit_vector(random);
                const Vec<double> eye =
                    centre_of(sphere) + radius_of(sphere) * (1 + gap * random.uniform(-1, 1)) * normal;
                const Vec<double> flat = across(random, normal);
                const double rise = either_sign(random) * over_scales(random, 1e-4, 10);
                return Case<Shape>{aimed(random, eye, eye + flat + rise * normal), sphere};
            }};
}

// As a bounced ray starts: an origin in double, a rounding error off the surface.
Cell<Shape> spawned() {
    return {"H3", "double origin 2^-45 off the surface",
            [](Random &random) {
                Case<Shape> made = next_to(0, "").make(random);
                const Vec<double> out = normalize(made.ray.origin - centre_of(made.shape));
                made.ray.origin =
                    centre_of(made.shape) + radius_of(made.shape) * (1 + 0x1p-45 * random.uniform(-1, 1)) * out;
                made.ray.direction += 1e-9 * in_cube(random, 1);
                return made;
            },
            true};
}

} // namespace

Suite sphere_suite() {
    const auto standard = [](const auto &ray, const auto &sphere) { return intersect(ray, sphere); };
    const auto textbook = [](const auto &ray, const auto &sphere) { return intersect_textbook(ray, sphere); };
    const auto crossed = [](const auto &ray, const auto &sphere) { return intersect_cross_product(ray, sphere); };
    Primitive<Shape> primitive{
        "sphere",
        {kernel<float, Shape>("textbook", textbook), kernel<double, Shape>("textbook", textbook),
         kernel<float, Shape>("cross product", crossed), kernel<double, Shape>("cross product", crossed),
         kernel<float, Shape>("guarded", standard, true), kernel<double, Shape>("guarded", standard, true)},
        {},
        [](Random &random) {
            const Shape sphere = sphere_at(in_cube(random, 3), random.uniform(0.3, 2));
            const Vec<double> eye = centre_of(sphere) + random.uniform(3, 12) * unit_vector(random);
            return passing(random, sphere, eye, random.uniform(0, 2));
        }};
    for (int power = 1; power <= 7; ++power)
        primitive.cells.push_back(far(std::pow(10, power), "1e" + std::to_string(power)));
    for (const int power : {2, 4, 6, 8})
        primitive.cells.push_back(grazing(std::pow(10, -power), "1e-" + std::to_string(power)));
    for (const int power : {2, 4, 6})
        primitive.cells.push_back(ground(std::pow(10, power), "1e" + std::to_string(power)));
    for (const int power : {3, 4, 5, 6})
        primitive.cells.push_back(next_to(std::pow(10, -power), "1e-" + std::to_string(power)));
    primitive.cells.push_back(next_to(0, "0"));
    primitive.cells.push_back(spawned());
    return suite(std::move(primitive));
}

} // namespace course::hard
