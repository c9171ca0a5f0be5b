// H9 cylinder and H10 cone.
#include "chapters/02_primitives/errata.hpp"
#include "tests/hard_cases/aim.hpp"
#include "tests/hard_cases/measure.hpp"
#include "tests/hard_cases/suites.hpp"

namespace course::hard {
namespace {

// A shape's own frame: `start` is a cylinder's bottom or a cone's apex, n runs to the other end.
struct Frame {
    Vec<double> start, n;
    double length, radius;
};

template <class Shape> Frame frame_of(const Shape &shape) {
    if constexpr (requires { shape.bottom; }) {
        const Vec<double> start(shape.bottom), n = Vec<double>(shape.top) - start;
        return {start, n, glm::length(n), static_cast<double>(shape.radius)};
    } else {
        const Vec<double> start(shape.apex), n = Vec<double>(shape.base) - start;
        return {start, n, glm::length(n), static_cast<double>(shape.radius)};
    }
}

template <class Shape> Shape shape_with(Random &random, double thin) {
    const Vec<double> start = as_float(in_cube(random, 2));
    const Vec<double> end = as_float(start + over_scales(random, 0.5, 4) * unit_vector(random));
    const double radius = thin * over_scales(random, 0.3, 3);
    return {Vec<float>(start), Vec<float>(end), static_cast<float>(radius)};
}

// The point at a share of the height, at `reach` times the wall's distance from the axis.
template <class Shape> Vec<double> near_wall(Random &random, const Shape &shape, double share, double reach) {
    const Frame f = frame_of(shape);
    const double wall = std::is_same_v<Shape, Cone<>> ? f.radius * share : f.radius;
    return f.start + share * f.n + reach * wall * across(random, f.n);
}

template <class Shape> using Maker = std::function<Ray<double>(Random &, const Shape &)>;

template <class Shape>
Cell<Shape> cell(const std::string &family, const std::string &name, const Maker<Shape> &ray, double thin = 1) {
    return {family, name, [=](Random &random) {
                const auto shape = shape_with<Shape>(random, thin);
                return Case<Shape>{ray(random, shape), shape};
            }};
}

// ---- Rays that both shapes are given -------------------------------------------------------------------------------

template <class Shape> Ray<double> at_random(Random &random, const Shape &shape) {
    const Vec<double> target = near_wall(random, shape, random.uniform(-0.3, 1.3), random.uniform(0, 1.4));
    return aimed(random, target + over_scales(random, 2, 10) * unit_vector(random), target);
}

template <class Shape> Maker<Shape> tangent(double away, double off) {
    return [=](Random &random, const Shape &shape) {
        const Frame f = frame_of(shape);
        const Vec<double> unit = normalize(f.n), aside = across(random, f.n), forth = cross(unit, aside);
        const double share = random.uniform(0.1, 1);
        const double wall = std::is_same_v<Shape, Cone<>> ? f.radius * share : f.radius;
        const Vec<double> touch = f.start + share * f.n + wall * (1 + off * random.uniform(-1, 1)) * aside;
        // A direction within the tangent plane: around the shape and along its wall.
        const Vec<double> wall_line = std::is_same_v<Shape, Cone<>> ? f.n + f.radius * aside : f.n;
        const Vec<double> direction = normalize(forth + random.uniform(-1, 1) * normalize(wall_line));
        return aimed(random, touch - away * direction, touch);
    };
}

template <class Shape> Maker<Shape> at_rim(double off) {
    return [=](Random &random, const Shape &shape) {
        const double end = std::is_same_v<Shape, Cone<>> || random.bits() % 2 ? 1 : 0;
        const Vec<double> target = near_wall(random, shape, end + off * random.uniform(-1, 1), 1);
        return aimed(random, target + over_scales(random, 1, 10) * unit_vector(random), target);
    };
}

template <class Shape> Ray<double> from_inside(Random &random, const Shape &shape) {
    const Vec<double> eye = near_wall(random, shape, random.uniform(0.1, 1), random.uniform(0, 0.99));
    return aimed(random, eye, eye + unit_vector(random));
}

template <class Shape> Ray<double> from_the_wall(Random &random, const Shape &shape) {
    const Vec<double> eye = near_wall(random, shape, random.uniform(0.05, 0.95), 1);
    return aimed(random, eye, eye + unit_vector(random));
}

// ---- Cylinder ------------------------------------------------------------------------------------------------------

Maker<Cylinder<>> nearly_along_the_axis(double angle) {
    return [=](Random &random, const Cylinder<> &shape) {
        const Frame f = frame_of(shape);
        const double tilt = angle * over_scales(random, 0.5, 2);
        const Vec<double> direction = normalize(normalize(f.n) + tilt * across(random, f.n));
        // Through the wall at about its own angle: the wall is passed within the height, or just beside.
        const Vec<double> target =
            near_wall(random, shape, random.uniform(-0.2, 1.2), 1 + 0.5 * tilt * random.uniform(-2, 2));
        return aimed(random, target - either_sign(random) * random.uniform(0.1, 10) * direction, target);
    };
}

// ---- Cone ----------------------------------------------------------------------------------------------------------

Maker<Cone<>> past_the_apex(double off) {
    return [=](Random &random, const Cone<> &shape) {
        const Frame f = frame_of(shape);
        const Vec<double> target = f.start + off * random.uniform(0, 1) * unit_vector(random);
        return aimed(random, target + random.uniform(2, 6) * unit_vector(random), target);
    };
}

// Straight at the origin, which floats can do exactly, with the apex moved off it by as little as is asked for.
Cell<Cone<>> past_an_apex_near_the_origin(double off, const std::string &name) {
    return {"H10", name + " from an apex near the origin", [=](Random &random) {
                const Vec<double> apex = as_float(off * random.uniform(0, 1) * unit_vector(random));
                const Vec<double> base = apex + over_scales(random, 0.5, 4) * unit_vector(random);
                const Cone<> shape{Vec<float>(apex), Vec<float>(base), static_cast<float>(over_scales(random, 0.3, 3))};
                const Vec<double> eye = as_float(random.uniform(2, 6) * unit_vector(random));
                return Case<Cone<>>{{eye, -eye}, shape};
            }};
}

Maker<Cone<>> along_a_generator(double off) {
    return [=](Random &random, const Cone<> &shape) {
        const Frame f = frame_of(shape);
        const Vec<double> aside = across(random, f.n), line = f.n + f.radius * aside;
        const Vec<double> direction = normalize(line) + off * random.uniform(-1, 1) * unit_vector(random);
        const Vec<double> target = near_wall(random, shape, random.uniform(-0.2, 1.2), random.uniform(0, 1.5));
        return aimed(random, target - either_sign(random) * random.uniform(1, 8) * direction, target);
    };
}

Ray<double> through_the_mirror(Random &random, const Cone<> &shape) {
    const Frame f = frame_of(shape);
    const Vec<double> in_mirror = near_wall(random, shape, -random.uniform(0.05, 1), random.uniform(0, 1.2));
    const Vec<double> target = random.bits() % 2 ? near_wall(random, shape, random.uniform(0, 1), 1)
                                                 : in_mirror + f.length * across(random, f.n);
    return aimed(random, in_mirror + 3.0 * (in_mirror - target), target);
}

template <class Shape> Primitive<Shape> round_primitive(const std::string &name) {
    const auto standard = [](const auto &ray, const auto &shape) { return intersect(ray, shape); };
    const auto textbook = [](const auto &ray, const auto &shape) { return intersect_textbook(ray, shape); };
    const auto crossed = [](const auto &ray, const auto &shape) { return intersect_cross_product(ray, shape); };
    // The printed formulas hold for directions of length one; t then counts in units of length.
    const auto printed = []<class T>(const Ray<T> &ray, const Shape &shape) {
        const T length = glm::length(ray.direction);
        auto t = intersect_as_printed(
            Ray<T>{ray.origin, ray.direction / length, ray.t_min * length, ray.t_max * length}, shape);
        if (t)
            *t /= length;
        return t;
    };
    Primitive<Shape> primitive{
        name,
        {kernel<float, Shape>("as printed", printed), kernel<double, Shape>("as printed", printed),
         kernel<float, Shape>("textbook", textbook), kernel<double, Shape>("textbook", textbook),
         kernel<float, Shape>("cross product", crossed), kernel<double, Shape>("cross product", crossed),
         kernel<float, Shape>("guarded", standard, true), kernel<double, Shape>("guarded", standard, true)},
        {},
        cell<Shape>("", "", at_random<Shape>).make};
    return primitive;
}

template <class Shape> void add_common(Primitive<Shape> &primitive, const std::string &family) {
    primitive.cells.push_back(cell<Shape>(family, "random", at_random<Shape>));
    primitive.cells.push_back(cell<Shape>(family, "radius about 1e-3", at_random<Shape>, 1e-3));
    primitive.cells.push_back(cell<Shape>(family, "tangent +- 1e-4", tangent<Shape>(5, 1e-4)));
    primitive.cells.push_back(cell<Shape>(family, "tangent +- 1e-6, from 1e3 away", tangent<Shape>(1e3, 1e-6)));
    primitive.cells.push_back(cell<Shape>(family, "rim +- 1e-6", at_rim<Shape>(1e-6)));
    primitive.cells.push_back(cell<Shape>(family, "origin inside", from_inside<Shape>));
    primitive.cells.push_back(cell<Shape>(family, "origin on the wall", from_the_wall<Shape>));
}

} // namespace

Suite cylinder_suite() {
    auto primitive = round_primitive<Cylinder<>>("cylinder");
    add_common(primitive, "H9");
    for (const int power : {0, 2, 4, 6})
        primitive.cells.push_back(cell<Cylinder<>>("H9", "angle to the axis 1e-" + std::to_string(power),
                                                   nearly_along_the_axis(std::pow(10, -power))));
    return suite(std::move(primitive));
}

Suite cone_suite() {
    auto primitive = round_primitive<Cone<>>("cone");
    add_common(primitive, "H10");
    primitive.cells.push_back(cell<Cone<>>("H10", "0.5 from the apex", past_the_apex(0.5)));
    for (const int power : {2, 4, 5, 6, 7}) {
        const std::string name = "1e-" + std::to_string(power);
        primitive.cells.push_back(cell<Cone<>>("H10", name + " from the apex", past_the_apex(std::pow(10, -power))));
        primitive.cells.push_back(past_an_apex_near_the_origin(std::pow(10, -power), name));
    }
    primitive.cells.push_back(cell<Cone<>>("H10", "along a generator +- 1e-3", along_a_generator(1e-3)));
    primitive.cells.push_back(cell<Cone<>>("H10", "along a generator +- 1e-7", along_a_generator(1e-7)));
    primitive.cells.push_back(cell<Cone<>>("H10", "through the mirrored nappe", through_the_mirror));
    return suite(std::move(primitive));
}

} // namespace course::hard
