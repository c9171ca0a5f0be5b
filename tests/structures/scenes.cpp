#include "tests/structures/scenes.hpp"

#include <cmath>
#include <limits>

namespace course::structure_test {

Mesh soup(std::size_t count, double size, std::uint64_t seed) {
    Random random(seed);
    Mesh mesh;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec<float> a = random_point(random);
        mesh.push_back({a, a + random_point(random, size), a + random_point(random, size)});
    }
    return mesh;
}

Mesh needles(std::size_t count, std::uint64_t seed) {
    Random random(seed);
    Mesh mesh;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec<float> a = random_point(random), b = random_point(random);
        mesh.push_back({a, b, b + random_point(random, 1e-3)});
    }
    return mesh;
}

TestMesh voxels(int side, std::uint64_t seed) {
    Random random(seed);
    std::vector<bool> filled(static_cast<std::size_t>(side * side * side));
    for (std::size_t i = 0; i < filled.size(); ++i)
        filled[i] = random.uniform() < 0.6;
    const auto at = [&](const glm::ivec3 &p) {
        for (int axis = 0; axis < 3; ++axis)
            if (p[axis] < 0 || p[axis] >= side)
                return false;
        return static_cast<bool>(filled[static_cast<std::size_t>((p.x * side + p.y) * side + p.z)]);
    };
    TestMesh result{"voxels", {}, {}};
    for (int x = 0; x < side; ++x)
        for (int y = 0; y < side; ++y)
            for (int z = 0; z < side; ++z) {
                const glm::ivec3 p(x, y, z);
                if (!at(p))
                    continue;
                result.inside.push_back(Vec<double>(p) + 0.5);
                for (int axis = 0; axis < 3; ++axis)
                    for (const int sign : {-1, 1}) {
                        glm::ivec3 step(0);
                        step[axis] = sign;
                        if (at(p + step))
                            continue;
                        Vec<float> corner(p), u(0), v(0);
                        corner[axis] += sign > 0 ? 1.0f : 0.0f;
                        u[(axis + 1) % 3] = v[(axis + 2) % 3] = 1;
                        if (sign < 0)
                            std::swap(u, v);
                        result.triangles.push_back({corner, corner + u, corner + u + v});
                        result.triangles.push_back({corner, corner + u + v, corner + v});
                    }
            }
    return result;
}

TestMesh sliced_sphere(int around, int along, const Vec<double> &centre, double radius, std::string name) {
    const auto vertex = [&](int i, int j) -> Vec<float> {
        const double theta = pi * i / along, phi = 2 * pi * (j % around) / around;
        const double ring = i == 0 || i == along ? 0 : std::sin(theta); // every slice meets the same pole
        return centre + radius * Vec<double>(ring * std::cos(phi), std::cos(theta), ring * std::sin(phi));
    };
    TestMesh result{std::move(name), {}, {centre, centre + 0.3 * radius, centre - Vec<double>(0, 0.6 * radius, 0)}};
    for (int i = 0; i < along; ++i)
        for (int j = 0; j < around; ++j) {
            const Vec<float> a = vertex(i, j), b = vertex(i, j + 1), c = vertex(i + 1, j + 1), d = vertex(i + 1, j);
            if (i > 0)
                result.triangles.push_back({a, b, c});
            if (i + 1 < along)
                result.triangles.push_back({a, c, d});
        }
    return result;
}

Mesh scaled(Mesh mesh, float scale, const Vec<float> &shift) {
    for (auto &[a, b, c] : mesh) {
        a = scale * a + shift;
        b = scale * b + shift;
        c = scale * c + shift;
    }
    return mesh;
}

std::vector<TestMesh> hard_meshes() {
    std::vector<TestMesh> meshes{{"soup", soup(600, 0.2, 1), {}},  {"large overlapping", soup(200, 2, 2), {}},
                                 {"needles", needles(300, 3), {}}, {"one", soup(1, 1, 4), {}},
                                 {"two", soup(2, 1, 5), {}},       {"empty", {}, {}}};
    meshes.push_back(voxels(5, 6));
    meshes.push_back(sliced_sphere(96, 6, {0, 0, 0}, 1, "slices"));
    meshes.push_back(sliced_sphere(12, 16, {148376, 1234, -223423}, 10, "far away"));
    meshes.push_back(sliced_sphere(12, 16, {0, 0, 0}, 1e-6, "tiny"));
    meshes.push_back(sliced_sphere(12, 16, {0, 0, 0}, 1e6, "huge"));
    meshes.push_back({"tiny soup", scaled(soup(300, 0.2, 7), 1e-6f), {}});
    meshes.push_back({"huge soup", scaled(soup(300, 0.2, 8), 1e6f), {}});
    meshes.push_back({"far soup", scaled(soup(300, 0.2, 9), 1, {10000, -20000, 5000}), {}});

    // All in one plane, where the bounds have no thickness; then also along one line.
    Mesh flat = soup(300, 0.2, 10), line = soup(100, 0.1, 11);
    for (auto &[a, b, c] : flat)
        a.z = b.z = c.z = 0.25f;
    for (auto &[a, b, c] : line) {
        a.y = b.y = 0.5f;
        a.z = b.z = c.z = -0.5f;
        c.y = 0.50001f;
    }
    meshes.push_back({"flat", flat, {}});
    meshes.push_back({"line", line, {}});

    // Every triangle three times over, in an order that no structure would choose: ties on every hit.
    Mesh ties = soup(150, 0.4, 12);
    const Mesh once = ties;
    ties.insert(ties.end(), once.rbegin(), once.rend());
    ties.insert(ties.end(), once.begin(), once.end());
    meshes.push_back({"ties", ties, {}});
    meshes.push_back({"all the same", Mesh(100, once.front()), {}});

    // A crowd in a large hall, and what no scene should hold but some will.
    Mesh uneven = scaled(soup(300, 0.1, 13), 1e-3f);
    for (const auto &triangle : scaled(soup(30, 1, 14), 100))
        uneven.push_back(triangle);
    meshes.push_back({"uneven", uneven, {}});
    Mesh poisoned = soup(200, 0.3, 15);
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = infinity<float>;
    const float most = std::numeric_limits<float>::max();
    poisoned[3].a.x = nan;
    poisoned[10].b = Vec<float>(nan);
    poisoned[20].c = {0, inf, 0};
    poisoned[30].a = {most, -most, most};
    poisoned[40].b = poisoned[40].a;
    poisoned[50] = {Vec<float>(0), Vec<float>(0), Vec<float>(0)};
    meshes.push_back({"poisoned", poisoned, {}});
    return meshes;
}

std::vector<Ray<double>> hard_rays(const Mesh &mesh, std::size_t count, std::uint64_t seed) {
    Random random(seed);
    const auto pick = [&]() -> Triangle<> {
        return mesh.empty() ? Triangle<>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}} : mesh[random.bits() % mesh.size()];
    };
    const auto near = [&](const Triangle<> &triangle) { // a place whose distance suits the size of the scene
        const Vec<double> a(pick().a), b(triangle.b);
        return a + random.uniform(-1, 2) * (Vec<double>(random_point(random)) * (length(a - b) + 1e-3 * length(a)));
    };
    std::vector<Ray<double>> rays;
    for (std::size_t i = 0; i < count; ++i) {
        const Triangle<> target = pick();
        const Vec<double> a(target.a), b(target.b), c(target.c), origin = near(target);
        const double u = random.uniform(), v = random.uniform(0, 1 - u);
        Vec<double> axis(0);
        axis[static_cast<int>(random.bits() % 3)] = random.bits() % 2 ? 1 : -1;
        switch (i % kinds_of_hard_rays) {
        case 0:
            rays.push_back({origin, Vec<double>(random_point(random))});
            break;
        case 1:
            rays.push_back({origin, a - origin});
            break;
        case 2:
            rays.push_back({origin, a + u * (b - a) - origin});
            break;
        case 3:
            rays.push_back({origin, a + u * (b - a) + v * (c - a) - origin});
            break;
        case 4:
            rays.push_back({a - (random.bits() % 3) * 0.5 * axis, axis});
            break; // begins at a corner, or beside
        case 5:
            rays.push_back({a - axis, axis + 1e-7 * Vec<double>(random_point(random))});
            break;
        case 6:
            rays.push_back({a + u * (b - a) + v * (c - a), Vec<double>(random_point(random))});
            break;
        case 7:
            rays.push_back({b - (c - a), c - a});
            break; // in the triangle's plane
        default: { // as fast along two axes, or along all three
            Vec<double> way(random.uniform(0.5, 1));
            for (int k = 0; k < 3; ++k)
                way[k] = random.bits() % 2 ? way[k] : -way[k];
            way[static_cast<int>(random.bits() % 3)] *= random.bits() % 4 ? random.uniform() : 1;
            rays.push_back({a + u * (b - a) + v * (c - a) - length(b - a) * way, way});
            break;
        }
        }
        if (i % 5 == 0)
            rays.back().t_max = random.uniform(0.5, 1.5);
        if (i % 7 == 0)
            rays.back().t_min = random.uniform(0, 0.9);
    }
    return rays;
}

} // namespace course::structure_test
