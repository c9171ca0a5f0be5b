// H4 plane and disk, H5 triangles (the mesh's, and note A's affine form).
#include "tests/hard_cases/aim.hpp"
#include "tests/hard_cases/measure.hpp"
#include "tests/hard_cases/suites.hpp"
#include "tests/hard_cases/triangle_kernels.hpp"

namespace course::hard {
namespace {

// A place on a flat shape (as nearly as doubles say), and the unit normal there.
struct Place {
    Vec<double> point, normal;
};

// Where the ray comes from: `steep` of 1 is head on, 1e-3 nearly within the plane; `away` is its distance.
Ray<double> towards(Random &random, const Place &place, double steep, double away) {
    const Vec<double> flat = across(random, place.normal);
    const Vec<double> out = normalize(flat + steep * either_sign(random) * place.normal);
    return aimed(random, place.point + away * out, place.point);
}

// ---- Plane ---------------------------------------------------------------------------------------------------------

template <class Shape> Shape flat_at(const Vec<double> &point, const Vec<double> &normal);
template <> Plane<> flat_at<Plane<>>(const Vec<double> &point, const Vec<double> &normal) {
    return {Vec<float>(point), Vec<float>(normal)};
}
template <> Disk<> flat_at<Disk<>>(const Vec<double> &point, const Vec<double> &normal) {
    return {Vec<float>(point), Vec<float>(normal), 1};
}

// `spread`: how far from the shape's point the ray is aimed, at most; `world`: how far off the origin all of it is.
template <class Shape> Case<Shape> flat_case(Random &random, double steep, double away, double spread, double world) {
    const Vec<double> normal = over_scales(random, 0.3, 3) * unit_vector(random);
    const Shape shape = flat_at<Shape>(world * unit_vector(random) + in_cube(random, 1), normal);
    const Vec<double> exact_normal(shape.normal);
    Vec<double> anchor;
    if constexpr (requires { shape.point; })
        anchor = Vec<double>(shape.point);
    else
        anchor = Vec<double>(shape.centre);
    const Vec<double> aside = across(random, exact_normal);
    const Place place{anchor + random.uniform(0, spread) * aside, normalize(exact_normal)};
    Ray<double> ray = towards(random, place, steep, away);
    if (random.bits() % 4 == 0)
        ray.direction = -ray.direction; // the plane lies behind
    return {ray, shape};
}

template <class Shape> std::vector<Cell<Shape>> flat_cells() {
    const auto cell = [](const std::string &name, double steep, double away, double spread, double world) {
        return Cell<Shape>{"H4", name,
                           [=](Random &random) { return flat_case<Shape>(random, steep, away, spread, world); }};
    };
    return {cell("random", 1, 5, 1.5, 0),
            cell("grazing at 1e-3", 1e-3, 5, 1.5, 0),
            cell("grazing at 1e-6", 1e-6, 5, 1.5, 0),
            cell("origin 1e-6 off", 1, 1e-6, 1.5, 0),
            cell("world offset 1e4", 1, 5, 1.5, 1e4),
            cell("world offset 1e4, grazing at 1e-3", 1e-3, 5, 1.5, 1e4),
            cell("origin in the plane as nearly as floats can", 1e-9, 1, 1.5, 3)};
}

Cell<Disk<>> rim(double off, const std::string &name) {
    return {"H4", "rim +- " + name, [=](Random &random) {
                const Disk<> disk{Vec<float>(in_cube(random, 3)), Vec<float>(unit_vector(random)),
                                  static_cast<float>(over_scales(random, 0.1, 10))};
                const Vec<double> normal(disk.normal);
                const double reach = static_cast<double>(disk.radius) * (1 + off * random.uniform(-1, 1));
                const Place place{Vec<double>(disk.centre) + reach * across(random, normal), normalize(normal)};
                return Case<Disk<>>{towards(random, place, over_scales(random, 0.1, 3), over_scales(random, 0.01, 10)),
                                    disk};
            }};
}

template <class Shape> Primitive<Shape> flat_primitive(const std::string &name) {
    const auto standard = [](const auto &ray, const auto &shape) { return intersect(ray, shape); };
    const auto textbook = [](const auto &ray, const auto &shape) { return intersect_textbook(ray, shape); };
    const auto inside = [](const auto &ray, const auto &shape) { return intersect_double(ray, shape); };
    return {name,
            {kernel<float, Shape>("textbook", textbook), kernel<double, Shape>("textbook", textbook),
             kernel<float, Shape>("double inside", inside), kernel<float, Shape>("guarded", standard, true),
             kernel<double, Shape>("guarded", standard, true)},
            {},
            {}};
}

// ---- Triangles -----------------------------------------------------------------------------------------------------

struct Corners {
    Vec<double> a, b, c;
};

Vec<double> at(const Corners &corners, double u, double v) {
    return corners.a + u * (corners.b - corners.a) + v * (corners.c - corners.a);
}

// A triangle of about the given size around a place: `thin` is its height over its length.
Corners triangle_around(Random &random, const Vec<double> &place, double size, double thin) {
    const Vec<double> along = unit_vector(random), aside = across(random, along);
    const auto near = [&](double x, double y) { return as_float(place + size * (x * along + y * thin * aside)); };
    return {near(random.uniform(-1, -0.5), random.uniform(-1, 1)), near(random.uniform(0.5, 1), random.uniform(-1, 1)),
            near(random.uniform(-1, 1), either_sign(random) * random.uniform(0.5, 1))};
}

enum class Aim { around, edge, corner };

template <class Shape> Shape triangle_of(const Corners &corners);
template <> Triangle<> triangle_of<Triangle<>>(const Corners &c) {
    return {Vec<float>(c.a), Vec<float>(c.b), Vec<float>(c.c)};
}
template <> AffineTriangle<> triangle_of<AffineTriangle<>>(const Corners &c) {
    return affine_triangle(Vec<float>(c.a), Vec<float>(c.b), Vec<float>(c.c));
}

struct TriangleFamily {
    std::string name;
    double size = 1, thin = 1, away = 5, steep = 1;
    Aim aim = Aim::around;
    double world = 0;
};

template <class Shape> Case<Shape> triangle_case(Random &random, const TriangleFamily &family) {
    const Vec<double> place = family.world * unit_vector(random) + in_cube(random, 1);
    Corners corners = triangle_around(random, place, family.size, family.thin);
    Vec<double> normal = cross(corners.b - corners.a, corners.c - corners.a);
    while (!(dot(normal, normal) > 0)) {
        corners = triangle_around(random, place, family.size, family.thin);
        normal = cross(corners.b - corners.a, corners.c - corners.a);
    }
    const double along = random.uniform(-0.2, 1.2);
    const Vec<double> target = family.aim == Aim::corner ? corners.b
                               : family.aim == Aim::edge
                                   ? at(corners, along, 1 - along)
                                   : at(corners, random.uniform(-0.2, 1), random.uniform(-0.2, 1));
    return {towards(random, {target, normalize(normal)}, family.steep, family.away), triangle_of<Shape>(corners)};
}

template <class Shape> std::vector<Cell<Shape>> triangle_cells() {
    const std::vector<TriangleFamily> families{
        {"random"},
        {.name = "grazing at 1e-3", .steep = 1e-3},
        {.name = "needle of 1e4", .thin = 1e-4},
        {.name = "seen from 1e4 away", .away = 1e4},
        {.name = "of size 1e-3 at 1e3", .size = 1e-3, .away = 1, .world = 1e3},
        {.name = "of size 1e6", .size = 1e6},
        {.name = "near-coplanar, 1e-6", .steep = 1e-6},
        {.name = "aimed at an edge", .aim = Aim::edge},
        {.name = "aimed at a corner", .aim = Aim::corner},
        {.name = "needle of 1e4 aimed at an edge", .thin = 1e-4, .aim = Aim::edge},
    };
    std::vector<Cell<Shape>> cells;
    for (const auto &family : families)
        cells.push_back({"H5", family.name, [family](Random &random) { return triangle_case<Shape>(random, family); }});
    return cells;
}

} // namespace

Suite plane_suite() {
    auto primitive = flat_primitive<Plane<>>("plane");
    primitive.cells = flat_cells<Plane<>>();
    primitive.random = [](Random &random) { return flat_case<Plane<>>(random, 1, 5, 1.5, 0); };
    return suite(std::move(primitive));
}

Suite disk_suite() {
    auto primitive = flat_primitive<Disk<>>("disk");
    primitive.cells = flat_cells<Disk<>>();
    for (const int power : {3, 6, 8})
        primitive.cells.push_back(rim(std::pow(10, -power), "1e-" + std::to_string(power)));
    primitive.random = [](Random &random) { return flat_case<Disk<>>(random, 1, 5, 1.5, 0); };
    return suite(std::move(primitive));
}

Suite affine_triangle_suite() {
    auto primitive = flat_primitive<AffineTriangle<>>("affine triangle");
    primitive.cells = triangle_cells<AffineTriangle<>>();
    primitive.random = [](Random &random) { return triangle_case<AffineTriangle<>>(random, {"random"}); };
    return suite(std::move(primitive));
}

Suite triangle_suite() {
    using Shape = Triangle<>;
    Primitive<Shape> primitive{"triangle", triangle_kernels(), triangle_cells<Shape>(),
                               [](Random &random) { return triangle_case<Shape>(random, {"random"}); },
                               "Moller-Trumbore"};
    return suite(std::move(primitive));
}

} // namespace course::hard
