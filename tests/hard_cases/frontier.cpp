#include "tests/hard_cases/frontier.hpp"

#include "chapters/02_primitives/random_shapes.hpp"
#include "chapters/08_mesh/moller_trumbore.hpp"
#include "chapters/14_bvh/bvh.hpp"
#include "common/timing.hpp"
#include "tests/hard_cases/aim.hpp"
#include "tests/unit/widened.hpp"

#include <map>

namespace course::hard {
namespace {

// ---- The textbook's form as a shape of its own, so that a tree can hold it ------------------------------------------

template <class S> struct Textbook { S shape; };

template <class T, class S> std::optional<T> intersect(const Ray<T> &ray, const Textbook<S> &textbook) {
    if constexpr (std::is_same_v<S, Triangle<>>)
        return moller_trumbore(ray, textbook.shape);
    else
        return intersect_textbook(ray, textbook.shape);
}
template <class S> auto bounds(const Textbook<S> &textbook) { return bounds(textbook.shape); }

// ---- What can be made ready before a loop --------------------------------------------------------------------------

// The same for both forms: a plane's n · p, or the bounds of its errors; numbers in the scalar that they are computed
// in. What depends on the ray alone, the compiler takes out of the inner loop.

struct TextbookPlane {
    Vec<float> normal;
    float w;
};

std::optional<float> intersect(const Ray<float> &ray, const TextbookPlane &plane) {
    const float t = -(dot(plane.normal, ray.origin) + plane.w) / dot(plane.normal, ray.direction);
    if (!in_range(ray, t))
        return {};
    return t;
}

TextbookPlane prepared(const Textbook<Plane<>> &plane) {
    return {plane.shape.normal, -dot(plane.shape.normal, plane.shape.point)};
}
template <class S> Textbook<S> prepared(const Textbook<S> &textbook) { return textbook; }

PreparedPlane<float> prepared(const Plane<> &plane) { return PreparedPlane<float>(plane); }
Triangle<double> prepared(const Triangle<> &t) { return {Vec<double>(t.a), Vec<double>(t.b), Vec<double>(t.c)}; }
template <class S> auto prepared(const S &shape) { return widened(shape); }

template <class Shape> auto prepared(const std::vector<Shape> &shapes) {
    std::vector<decltype(prepared(shapes.front()))> made;
    for (const Shape &shape : shapes)
        made.push_back(prepared(shape));
    return made;
}

// ---- What is timed --------------------------------------------------------------------------------------------------

using FloatRay = Ray<float>;

std::vector<FloatRay> narrowed(const std::vector<Ray<double>> &rays) {
    std::vector<FloatRay> narrow;
    for (const auto &ray : rays)
        narrow.push_back({Vec<float>(ray.origin), Vec<float>(ray.direction)});
    return narrow;
}

Triangle<> random_triangle(Random &random) {
    const Vec<float> a = random_point(random), b = random_point(random);
    return {a, b, random_point(random)};
}

template <class S> S a_shape(Random &random) {
    if constexpr (std::is_same_v<S, Triangle<>>)
        return random_triangle(random);
    else
        return random_shape(random, S{});
}

// The shape made smaller and moved.
Vec<float> moved(const Vec<float> &p, float size, const Vec<float> &to) { return size * p + to; }
template <class S> S placed(S shape, float size, const Vec<float> &to) {
    const auto move = [&](Vec<float> &p) { p = moved(p, size, to); };
    if constexpr (requires { shape.centre; })
        move(shape.centre);
    else if constexpr (requires { shape.a; })
        move(shape.a), move(shape.b), move(shape.c);
    else if constexpr (requires { shape.bottom; })
        move(shape.bottom), move(shape.top);
    else
        move(shape.apex), move(shape.base);
    if constexpr (requires { shape.radius; })
        shape.radius *= size;
    return shape;
}

// Every ray against every shape. A ray's share of the work is done once a ray, where the compiler sees that it can be.
template <class Rays, class Shapes> double all_pairs(const Rays &rays, const Shapes &shapes) {
    std::size_t hits = 0;
    double sum = 0;
    for (const auto &given : rays) {
        const auto ray = given; // a copy, as a search has
        for (const auto &shape : shapes)
            if (const auto t = intersect(ray, shape)) {
                ++hits;
                sum += static_cast<double>(*t);
            }
    }
    keep(sum);
    return static_cast<double>(hits);
}

template <class Rays, class Tree> double all_rays(const Rays &rays, const Tree &tree) {
    double hits = 0;
    for (const auto &ray : rays) {
        const auto hit = closest_hit(ray, tree);
        keep(hit);
        hits += static_cast<bool>(hit);
    }
    return hits;
}

// ---- The rows -------------------------------------------------------------------------------------------------------

struct Variant {
    std::string kernel;
    bool is_default;
    std::function<double()> run; // returns the number of hits
    std::size_t peer = 0; // the textbook's form in float to which this is compared, made ready as much as this is
};

void time_variants(std::vector<Row> &rows, const std::string &test, const std::string &place, double tests,
                   const std::vector<Variant> &variants) {
    std::vector<std::function<void()>> loops;
    for (const Variant &variant : variants)
        loops.push_back([&] { variant.run(); });
    const auto seconds = median_seconds(loops, 15);
    for (std::size_t i = 0; i < variants.size(); ++i)
        rows.push_back(Row()
                           .set("family", "frontier")
                           .set("test", test)
                           .set("kernel", variants[i].kernel)
                           .set("default", variants[i].is_default)
                           .set("parameter", place)
                           .set("ns", 1e9 * seconds[i] / tests)
                           .set("hit_share", variants[i].run() / tests)
                           .set("ratio_to_textbook_float", seconds[i] / seconds[variants[i].peer]));
}

template <class S> void time_in_loop(std::vector<Row> &rows, const std::string &test, std::uint64_t seed) {
    constexpr std::size_t side =
        256; // so many pairs that no branch is learnt by heart, so few bytes that all stay near
    std::vector<Ray<double>> rays;
    std::vector<S> shapes;
    std::vector<Textbook<S>> textbook;
    for (std::size_t i = 0; i < side; ++i) {
        Random random(seed, i);
        const Ray<double> ray = random_ray(random);
        rays.push_back({as_float(ray.origin), as_float(ray.direction)});
        shapes.push_back(a_shape<S>(random));
        textbook.push_back({shapes.back()});
    }
    const auto float_rays = narrowed(rays);
    const auto textbook_ready = prepared(textbook);
    const auto ready = prepared(shapes);
    std::vector<std::conditional_t<std::is_same_v<S, Triangle<>>, Sheared<Ray<double>>, Ray<double>>> ready_rays;
    for (const auto &ray : rays)
        ready_rays.emplace_back(ray);
    time_variants(rows, test, "loop", side * side,
                  {{"textbook, float", false, [&] { return all_pairs(float_rays, textbook); }},
                   {"textbook, double", false, [&] { return all_pairs(rays, textbook); }},
                   {"default, float", true, [&] { return all_pairs(float_rays, shapes); }},
                   {"default, double", true, [&] { return all_pairs(rays, shapes); }},
                   {"prepared textbook, float", false, [&] { return all_pairs(float_rays, textbook_ready); }},
                   {"prepared, double", true, [&] { return all_pairs(ready_rays, ready); }, 4}});
}

template <class S> void time_in_tree(std::vector<Row> &rows, const std::string &test, std::uint64_t seed) {
    constexpr std::size_t count = 50'000, ray_count = 20'000;
    std::vector<S> shapes;
    std::vector<Textbook<S>> textbook;
    for (std::size_t i = 0; i < count; ++i) {
        Random random(seed, i);
        const S shape = a_shape<S>(random);
        shapes.push_back(placed(shape, 0.02f, 2.0f * random_point(random)));
        textbook.push_back({shapes.back()});
    }
    const Bvh<S> tree{std::span<const S>(shapes)};
    const Bvh<Textbook<S>> textbook_tree{std::span<const Textbook<S>>(textbook)};

    std::vector<Ray<double>> camera, incoherent;
    constexpr int side = 142;
    for (std::size_t i = 0; i < ray_count; ++i) {
        Random random(seed + 1, i);
        const double x = static_cast<double>(i % side) / side - 0.5, y = static_cast<double>(i) / ray_count - 0.5;
        camera.push_back({{0, 0, 14}, as_float({x, y, -1})});
        incoherent.push_back({as_float(in_cube(random, 4)), as_float(unit_vector(random))});
    }
    for (const auto &[place, rays] : {std::pair{"tree, camera rays", camera}, {"tree, incoherent rays", incoherent}}) {
        const auto float_rays = narrowed(rays);
        time_variants(rows, test, place, ray_count,
                      {{"textbook, float", false, [&] { return all_rays(float_rays, textbook_tree); }},
                       {"default, double", true, [&] { return all_rays(rays, tree); }}});
    }
}

} // namespace

std::vector<Row> frontier_rows(std::uint64_t seed) {
    std::vector<Row> rows;
    const auto measure = [&]<class S>(const std::string &test, const S &, bool in_tree) {
        time_in_loop<S>(rows, test, seed);
        if constexpr (Bounded<S> && !std::is_same_v<S, AffineTriangle<>> && !std::is_same_v<S, Box<>>)
            if (in_tree)
                time_in_tree<S>(rows, test, seed);
    };
    measure("sphere", Sphere<>{}, true);
    measure("plane", Plane<>{}, false);
    measure("disk", Disk<>{}, true);
    measure("triangle", Triangle<>{}, true);
    measure("affine triangle", AffineTriangle<>{}, false);
    measure("cylinder", Cylinder<>{}, true);
    measure("cone", Cone<>{}, true);
    measure("box", Box<>{}, false);
    return rows;
}

std::vector<Row> frontier_table(const std::vector<Row> &rows) {
    const auto text = [](const Row &row, const char *name) { return std::get<std::string>(*row.find(name)); };
    const auto number = [](const Row &row, const char *name) { return std::get<double>(*row.find(name)); };
    std::vector<Row> table;
    for (const Row &row : rows) {
        if (table.empty() || text(table.back(), "primitive") != text(row, "test"))
            table.push_back(Row().set("primitive", text(row, "test")));
        const std::string kernel = text(row, "kernel"), place = text(row, "parameter");
        if (kernel == "textbook, float" && place == "loop")
            table.back().set("textbook, ns", number(row, "ns")).set("hit, %", 100 * number(row, "hit_share"));
        else if (place == "loop")
            table.back().set("loop: " + kernel, number(row, "ratio_to_textbook_float"));
        else if (kernel != "textbook, float")
            table.back().set(place, number(row, "ratio_to_textbook_float"));
    }
    return table;
}

} // namespace course::hard
