#include "tests/structures/structure_test.hpp"

#include <array>
#include <cstring>

namespace course::structure_test {

bool same(const Hit<double> &a, const Hit<double> &b) {
    return a.id == b.id && std::memcmp(&a.t, &b.t, sizeof(double)) == 0;
}

void expect_agreement(const std::string &name, const Asked &brute, const Asked &structure,
                      const std::vector<Ray<double>> &rays) {
    SCOPED_TRACE(name);
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const auto expected = brute.closest(rays[i]), found = structure.closest(rays[i]);
        const bool any = structure.any(rays[i]);
        if (same(expected, found) && any == bool(expected))
            continue;
        if (wrong++ == 0)
            ADD_FAILURE() << "ray " << i << ": brute force finds id " << expected.id << " at " << expected.t
                          << ", the structure id " << found.id << " at " << found.t << ", any_hit says " << any;
    }
    EXPECT_EQ(wrong, 0u) << "of " << rays.size() << " rays";
}

template <class Shape> std::unique_ptr<const Asked> brute_force(const std::vector<Shape> &shapes) {
    return std::make_unique<const AskedOf<Scene<Shape>>>(shapes);
}

// ---- Meshes ---------------------------------------------------------------------------------------------------------

void agrees_with_brute_force_on_hard_meshes(const Around &around) {
    std::uint64_t seed = 100;
    for (const auto &[name, mesh, inside] : hard_meshes()) {
        const auto built = around(mesh);
        EXPECT_EQ(built->primitives(), mesh.size()) << name;
        expect_agreement(name, *brute_force(mesh), *built, hard_rays(mesh, 4000, ++seed));
    }
}

void closed_meshes_neither_leak_nor_miscount(const Around &around) {
    for (const auto &[name, mesh, inside] : hard_meshes()) {
        if (inside.empty())
            continue;
        SCOPED_TRACE(name);
        const auto built = around(mesh);
        Random random(7);
        std::size_t leaks = 0, even = 0;
        for (std::size_t i = 0; i < 4000; ++i) {
            const Vec<double> origin = inside[i % inside.size()];
            const auto &[a, b, c] = mesh[random.bits() % mesh.size()];
            const Vec<double> edge = Vec<double>(a) + random.uniform() * (Vec<double>(b) - Vec<double>(a));
            const Vec<double> aims[] = {Vec<double>(random_point(random)), Vec<double>(a) - origin, edge - origin};
            const Ray<double> ray{origin, aims[i / inside.size() % 3]}; // every aim from every place
            leaks += !built->closest(ray);
            even += built->hits_along(ray) % 2 == 0;
        }
        EXPECT_EQ(leaks, 0u);
        EXPECT_EQ(even, 0u);
    }
}

// ---- Other shapes ---------------------------------------------------------------------------------------------------

Box<float> bounds(const AnyShape &shape) {
    return std::visit([](const auto &one) { return bounds(one); }, shape.kind);
}
std::optional<double> intersect(const Ray<double> &ray, const AnyShape &shape) {
    return std::visit([&](const auto &one) { return intersect(ray, one); }, shape.kind);
}

namespace {

AnyShape random_disk(Random &random) {
    return {Disk<>{random_point(random), random_point(random), static_cast<float>(random.uniform(0.01, 0.4))}};
}
AnyShape random_box(Random &random) {
    const Vec<float> lo = random_point(random), edges = abs(random_point(random, 0.3));
    return {Box<>{lo, lo + edges}};
}
AnyShape random_cylinder(Random &random) {
    const Vec<float> bottom = random_point(random);
    return {Cylinder<>{bottom, bottom + random_point(random, 0.4), static_cast<float>(random.uniform(0.01, 0.2))}};
}
AnyShape random_cone(Random &random) {
    const Vec<float> apex = random_point(random);
    return {Cone<>{apex, apex + random_point(random, 0.4), static_cast<float>(random.uniform(0.01, 0.3))}};
}
AnyShape random_affine_triangle(Random &random) {
    const Vec<float> a = random_point(random);
    return {affine_triangle(a, a + random_point(random, 0.4f), a + random_point(random, 0.4f))};
}

// By the number of the kind.
constexpr std::array makers{random_disk, random_box, random_cylinder, random_cone, random_affine_triangle};

} // namespace

std::vector<Sphere<>> random_spheres(std::size_t count, std::uint64_t seed) {
    Random random(seed);
    std::vector<Sphere<>> spheres;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec<float> centre = random_point(random);
        spheres.push_back({centre, static_cast<float>(random.uniform(0.01, 0.3))});
    }
    return spheres;
}

std::vector<AnyShape> random_shapes(std::size_t count, std::uint64_t seed, std::size_t kind) {
    Random random(seed);
    std::vector<AnyShape> shapes;
    for (std::size_t i = 0; i < count; ++i)
        shapes.push_back(makers[kind < makers.size() ? kind : i % makers.size()](random));
    return shapes;
}

std::vector<Ray<double>> random_rays(std::size_t count, std::uint64_t seed) {
    return hard_rays(soup(200, 0.5, seed), count, seed);
}

template std::unique_ptr<const Asked> brute_force(const Mesh &);
template std::unique_ptr<const Asked> brute_force(const std::vector<Sphere<>> &);
template std::unique_ptr<const Asked> brute_force(const std::vector<AnyShape> &);

} // namespace course::structure_test
