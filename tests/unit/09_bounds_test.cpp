// Bounds hold their shapes and no more; the robust slab test loses nothing where the printed one does.
#include "chapters/01_ray_casting/camera.hpp"
#include "chapters/09_aabb/any_structure.hpp"
#include "chapters/09_aabb/other_bounds.hpp"
#include "chapters/09_aabb/slab.hpp"
#include "chapters/09_aabb/taught.hpp"
#include "common/random.hpp"

#include <gtest/gtest.h>

using namespace course;

namespace {

Vec<double> random_vector(Random &random, double size = 1) {
    return {random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
}

// Points of the shape, found by rays from all around; they must lie in the box, and come near all six faces.
template <class Shape> void expect_tight(const Shape &shape, double slack = 0.02) {
    const auto box = bounds(shape);
    const Vec<double> middle = centre(box);
    const double size = length(extent(box));
    Random random(5);
    auto seen = empty_box<double>();
    for (int i = 0; i < 40000; ++i) {
        const Vec<double> from = middle + size * normalize(random_vector(random));
        const Ray<double> ray{from, middle + random_vector(random, 0.5) * extent(box) - from};
        if (const auto t = intersect(ray, shape))
            seen = merge(seen, Box<double>{point_at(ray, *t), point_at(ray, *t)});
    }
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_GE(seen.lo[axis], static_cast<double>(box.lo[axis]) - 1e-12 * size);
        EXPECT_LE(seen.hi[axis], static_cast<double>(box.hi[axis]) + 1e-12 * size);
        EXPECT_LE(seen.lo[axis] - static_cast<double>(box.lo[axis]), slack * size);
        EXPECT_LE(static_cast<double>(box.hi[axis]) - seen.hi[axis], slack * size);
    }
}

TEST(Bounds, HoldEveryShapeTightly) {
    expect_tight(Sphere<>{{0.3f, -0.2f, 0.1f}, 0.7f});
    expect_tight(Disk<>{{0.1f, 0.2f, 0.3f}, {0.5f, 0.7f, -0.3f}, 0.8f});
    expect_tight(Cylinder<>{{0.1f, 0.2f, 0.3f}, {1, 0.5f, -0.7f}, 0.4f});
    expect_tight(Cone<>{{0.1f, 0.2f, 0.3f}, {1, 0.5f, -0.7f}, 0.6f});
    expect_tight(Box<>{{-1, -0.5f, 0.25f}, {1, 0.75f, 1}});
    expect_tight(Triangle<>{{0, 0.1f, 0.2f}, {1, 0.3f, -0.4f}, {-0.2f, 1, 0.6f}}, 0.05);
    expect_tight(affine_triangle<float>({0, 0.1f, 0.2f}, {1, 0.3f, -0.4f}, {-0.2f, 1, 0.6f}), 0.05);
}

TEST(Bounds, OfWhatIsExactAreExact) {
    const Box<float> ball = bounds(Sphere<>{{1, 2, 3}, 1});
    EXPECT_EQ(ball.lo, Vec<float>(0, 1, 2));
    EXPECT_EQ(ball.hi, Vec<float>(2, 3, 4));
    const Box<float> flat = bounds(Triangle<>{{0, 0, 5}, {1, 0, 5}, {0, 1, 5}});
    EXPECT_EQ(flat.lo.z, 5);
    EXPECT_EQ(flat.hi.z, 5);
    const Box<float> disk = bounds(Disk<>{{0, 0, 1}, {0, 0, 2}, 3});
    EXPECT_EQ(disk.lo, Vec<float>(-3, -3, 1));
}

TEST(Bounds, AreRoundedOutwards) {
    // 1 + 2^-30 is no float: the box must reach over it.
    const Box<float> box = bounds(Sphere<>{{1, 0, 0}, 0x1p-30f});
    EXPECT_LT(box.lo.x, 1);
    EXPECT_GT(box.hi.x, 1);
    EXPECT_EQ(rounded_up<float>(1 + 0x1p-40), std::nextafter(1.0f, 2.0f));
    EXPECT_EQ(rounded_down<float>(1 + 0x1p-40), 1.0f);
}

TEST(Bounds, OfNothingMergeIntoNothing) {
    EXPECT_FALSE(holds_any(empty_box<float>()));
    EXPECT_EQ(surface_area(empty_box<float>()), 0);
    const Box<float> some{{0, 0, 0}, {1, 2, 3}};
    EXPECT_EQ(merge(empty_box<float>(), some).hi, some.hi);
    EXPECT_EQ(surface_area(some), 22);
    EXPECT_FALSE(holds_any(bounds(Sphere<>{{NAN, 0, 0}, 1})));
}

// The printed test fails where it must: this is the erratum.
TEST(Slab, AsPrintedLosesFlatBoxesAndRaysInAFace) {
    const Box<float> flat{{0, 0, 1}, {2, 2, 1}}, cube{{0, 0, 0}, {2, 2, 2}};
    const Ray<double> ahead{{1, 1, 0}, {0, 0, 1}}, in_face{{0, 1, -1}, {0, 0, 1}};
    EXPECT_FALSE(meets_textbook(ahead, flat));
    EXPECT_FALSE(meets_textbook(in_face, cube));
    EXPECT_TRUE(SlabRay(ahead, flat).meets(flat, infinity<double>));
    EXPECT_TRUE(SlabRay(in_face, cube).meets(cube, infinity<double>));
}

// H8: from a lattice point through a lattice point of the box, so that the ray meets the box without any rounding.
TEST(Slab, LosesNoRayThatMeetsTheBox) {
    Random random(8);
    const auto whole = [&] { return std::floor(random.uniform(-4, 5)); };
    int lost = 0, lost_float = 0;
    for (int i = 0; i < 300000; ++i) {
        const Vec<double> a(whole(), whole(), whole()), b(whole(), whole(), whole());
        const Box<float> box{Vec<float>(min(a, b)), Vec<float>(max(a, b))};
        Vec<double> inside(box.lo), step(whole(), whole(), whole());
        for (int axis = 0; axis < 3; ++axis)
            if (random.bits() % 2)
                inside[axis] = static_cast<double>(box.hi[axis]);
        if (random.bits() % 2)
            step[static_cast<int>(random.bits() % 3)] = -0.0;
        if (step == Vec<double>(0))
            continue;
        const Ray<double> ray{inside - 2.0 * step, step};
        const Ray<float> rough{Vec<float>(ray.origin), Vec<float>(ray.direction)};
        const double t_max = next_up(2.0);
        lost += !SlabRay(ray, box).meets(box, t_max);
        lost_float += !SlabRay(rough, box).meets(box, t_max);
    }
    EXPECT_EQ(lost, 0);
    EXPECT_EQ(lost_float, 0);
}

TEST(Slab, CullsWhatIsBesideBehindAndBeyond) {
    const Box<float> box{{-1, -1, -1}, {1, 1, 1}};
    const auto meets_box = [&](const Ray<double> &ray, double t_max = infinity<double>) {
        return SlabRay(ray, box).meets(box, t_max);
    };
    EXPECT_TRUE(meets_box({{0, 0, 5}, {0, 0, -1}}));
    EXPECT_TRUE(meets_box({{0, 0, 0}, {0.3, 0.2, 1}})); // from inside
    EXPECT_FALSE(meets_box({{0, 0, 5}, {0, 0, 1}}));
    EXPECT_FALSE(meets_box({{0, 1.01, 5}, {0, 0, -1}}));
    EXPECT_FALSE(meets_box({{0, 0, 5}, {0, 0, -1}}, 3.9));
    EXPECT_FALSE(meets_box({{0, 0, 5}, {0, 0, -1}, 6.1}));
}

TEST(OtherBounds, HoldTheirPoints) {
    Random random(9);
    std::vector<Vec<float>> points;
    for (int i = 0; i < 200; ++i)
        points.push_back(Vec<float>(random_vector(random)));
    const Sphere<> ball = bounding_sphere(points);
    const Vec<double> n = normalize(Vec<double>(1, 2, 3)), m = normalize(cross(n, Vec<double>(0, 0, 1)));
    const Slabs slabs = slabs_around(points, {n, m, cross(n, m)});
    int lost = 0;
    for (const Vec<float> &point : points)
        for (int i = 0; i < 20; ++i) {
            const Vec<double> from = random_vector(random, 5);
            const Ray<double> ray{from, Vec<double>(point) - from};
            lost += !meets(ray, ball) || !meets(ray, slabs);
        }
    EXPECT_EQ(lost, 0);
    EXPECT_FALSE(meets(Ray<double>{{0, 9, 0}, {1, 0, 0}}, ball));
    EXPECT_FALSE(meets(Ray<double>{{0, 9, 0}, {1, 0, 0}}, slabs));
}

TEST(Accelerate, WrapsWhatIsBoundedAndLeavesPlanes) {
    const Scene scene(std::vector<Sphere<>>{{{0, 0, 0}, 1}}, std::vector<Plane<>>{{{0, -1, 0}, {0, 1, 0}}});
    static_assert(std::is_same_v<decltype(accelerate<OneBox>(scene)), Scene<OneBox<Sphere<>>, Plane<>>>);
    EXPECT_EQ(closest_hit(Ray<double>{{0, 5, 0}, {0, -1, 0}}, accelerate<OneBox>(scene)).t, 4);
}

TEST(AnyStructure, IsTheOneOfThatName) {
    const std::vector<Triangle<>> floor{{{-1, 0, -1}, {-1, 0, 1}, {1, 0, 0}}};
    const Ray<double> down{{0, 4, 0}, {0, -1, 0}}, up{{0, 4, 0}, {0, 1, 0}};
    for (const std::string &name : names_of(structures_of_09)) {
        const AnyStructure structure = any_structure(structures_of_09, name, floor);
        Counts counts;
        EXPECT_EQ(size(structure), 1u);
        EXPECT_EQ(closest_hit(down, structure).t, 4);
        EXPECT_EQ(closest_hit(CountedRay<>{down, &counts}, structure).t, 4);
        EXPECT_EQ(counts.nodes, name == "box") << name;
        EXPECT_TRUE(any_hit(down, structure));
        EXPECT_FALSE(any_hit(up, structure));
        EXPECT_EQ(with_hit(down, {4, 0}, structure, [](const auto &surface) { return surface.point; }), Vec<double>(0));
    }
}

} // namespace
