// H8: boxes met where slabs go wrong. A box bounds something, so a false miss is what must not happen.
#include "tests/hard_cases/aim.hpp"
#include "tests/hard_cases/measure.hpp"
#include "tests/hard_cases/suites.hpp"

namespace course::hard {
namespace {

using Shape = Box<>;

struct Corners {
    Vec<double> lo, hi;
};

Corners box_around(Random &random) {
    const Vec<double> p = as_float(in_cube(random, 3)), q = as_float(p + in_cube(random, 2));
    return {min(p, q), max(p, q)};
}
Shape box_of(const Corners &c) { return {Vec<float>(c.lo), Vec<float>(c.hi)}; }

Vec<double> within(Random &random, const Corners &c) {
    return c.lo + Vec<double>(random.uniform(), random.uniform(), random.uniform()) * (c.hi - c.lo);
}

// The target moved onto as many of the box's faces as are asked for: 1 a face, 2 an edge, 3 a corner.
Vec<double> onto(Random &random, const Corners &c, Vec<double> p, int faces) {
    for (int i = 0, axis = static_cast<int>(random.bits() % 3); i < faces; ++i, axis = (axis + 1) % 3)
        p[axis] = random.bits() % 2 ? c.lo[axis] : c.hi[axis];
    return p;
}

Vec<double> eye(Random &random) { return as_float(over_scales(random, 3, 30) * unit_vector(random)); }

using Change = std::function<void(Random &, Corners &, Ray<double> &)>;

// A ray at a place in the box or a little beside it, then changed.
Cell<Shape> cell(const std::string &name, int faces, Change change = {}) {
    return {"H8", name, [=](Random &random) {
                Corners corners = box_around(random);
                Vec<double> target = onto(random, corners, within(random, corners), faces);
                if (faces == 0)
                    target += 0.5 * in_cube(random, 1);
                Ray<double> ray = aimed(random, eye(random), target);
                if (change)
                    change(random, corners, ray);
                return Case<Shape>{ray, box_of(corners)};
            }};
}

int an_axis(Random &random) { return static_cast<int>(random.bits() % 3); }

// The ray's direction loses a component, and its origin lies between the box's planes, or on one.
Change zero_component(double zero, bool on_face) {
    return [=](Random &random, Corners &c, Ray<double> &ray) {
        const int axis = an_axis(random);
        ray.direction[axis] = zero;
        ray.origin[axis] = on_face ? (random.bits() % 2 ? c.lo[axis] : c.hi[axis])
                                   : as_float(random.uniform(c.lo[axis] - 0.2, c.hi[axis] + 0.2));
    };
}

void along_an_axis(Random &random, Corners &c, Ray<double> &ray) {
    const int axis = an_axis(random);
    for (int i = 0; i < 3; ++i)
        if (i != axis) {
            ray.direction[i] = random.bits() % 2 ? 0.0 : -0.0;
            ray.origin[i] = as_float(random.uniform(c.lo[i] - 0.1, c.hi[i] + 0.1));
        }
}

// A box without thickness along an axis, met in its plane: `sides` 1 anywhere, 2 on an edge.
Cell<Shape> flat_cell(const std::string &name, int sides) {
    return {"H8", name, [=](Random &random) {
                Corners corners = box_around(random);
                const int axis = an_axis(random);
                corners.hi[axis] = corners.lo[axis];
                Vec<double> target = within(random, corners);
                if (sides == 2) {
                    const int other = (axis + 1 + static_cast<int>(random.bits() % 2)) % 3;
                    target[other] = random.bits() % 2 ? corners.lo[other] : corners.hi[other];
                }
                return Case<Shape>{aimed(random, eye(random), target), box_of(corners)};
            }};
}

void start_on_a_face(Random &random, Corners &c, Ray<double> &ray) {
    const int axis = an_axis(random);
    ray.origin = as_float(within(random, c));
    ray.origin[axis] = random.bits() % 2 ? c.lo[axis] : c.hi[axis];
}

void start_inside(Random &random, Corners &c, Ray<double> &ray) { ray.origin = as_float(within(random, c)); }

} // namespace

Suite box_suite() {
    const auto standard = [](const auto &ray, const auto &box) { return intersect(ray, box); };
    const auto textbook = [](const auto &ray, const auto &box) { return intersect_textbook(ray, box); };
    const auto inside = [](const auto &ray, const auto &box) { return intersect_double(ray, box); };
    Primitive<Shape> primitive{"box",
                               {kernel<float, Shape>("textbook", textbook), kernel<double, Shape>("textbook", textbook),
                                kernel<float, Shape>("double inside", inside),
                                kernel<float, Shape>("guarded", standard, true),
                                kernel<double, Shape>("guarded", standard, true)},
                               {},
                               cell("random", 0).make};
    primitive.cells = {
        cell("random", 0),
        cell("aimed at a face", 1),
        cell("aimed at an edge", 2),
        cell("aimed at a corner", 3),
        cell("a zero component", 0, zero_component(0.0, false)),
        cell("a component of -0", 0, zero_component(-0.0, false)),
        cell("a zero component within a face", 0, zero_component(0.0, true)),
        cell("a component of -0 within a face", 0, zero_component(-0.0, true)),
        cell("along an axis", 0, along_an_axis),
        flat_cell("flat boxes", 1),
        flat_cell("flat boxes aimed at an edge", 2),
        cell("origin on a face", 0, start_on_a_face),
        cell("origin inside", 0, start_inside),
    };
    return suite(std::move(primitive));
}

} // namespace course::hard
