#include "chapters/16_comparison/built_scenes.hpp"
#include "chapters/16_comparison/hall.hpp"
#include "chapters/16_comparison/landscape.hpp"
#include "chapters/16_comparison/run.hpp"
#include "chapters/16_comparison/scattered.hpp"

#include <chrono>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <thread>
#include <utility>

using namespace course;

namespace {

TestScene tiny(const Triangles &triangles) { return seen_from("tiny", triangles, {0.3, 0.35, 1}); }

Effort tiny_effort() {
    Effort effort = quick_effort();
    effort.side = 16;
    effort.rounds = 1;
    effort.builds = 1;
    effort.seconds = 10; // every ray, however slow
    effort.brute_tests = 1e12;
    return effort;
}

std::vector<Row> compare_tiny(const Triangles &triangles, const std::vector<Entrant> &entrants) {
    return compare_scene(tiny(triangles), entrants, find_entrant(contestants(), "bvh"), tiny_effort());
}

TEST(Comparison, EveryStructureOfTheCourseIsExactOnEveryKindOfScene) {
    const std::vector<Entrant> entrants = our_structures();
    std::set<std::string> structures;
    for (const Entrant &entrant : entrants)
        structures.insert(entrant.structure);
    EXPECT_TRUE(structures.contains("none") && structures.contains("grid") && structures.contains("bvh"));
    const std::vector<Triangles> scenes{
        triangle_soup(300, 1), needles(200, 2), hair(20, 4, 3), sphereflake(1, 1), tetra(3),      hall(2, 1),
        rings(2, 12, 8, 4),    terrain(12, 5),  tree(1, 6, 6),  gears(2, 8),       mount(2, 1, 7)};
    for (const Triangles &triangles : scenes)
        for (const Row &row : compare_tiny(triangles, entrants)) {
            EXPECT_EQ(number_of(row, "ray_count"), 16 * 16);
            if (text_of(row, "kernel") == "default") {
                EXPECT_EQ(number_of(row, "mismatches"), 0) << json_line(row);
            }
        }
}

TEST(Comparison, RowsHaveTheFieldsThatReadersRelyOn) {
    const auto rows = compare_tiny(triangle_soup(200, 1), contestants());
    ASSERT_FALSE(rows.empty());
    for (const Row &row : rows)
        for (const char *field :
             {"scene", "triangles", "structure", "kernel", "rays", "ray_count", "build_ms", "bytes_per_triangle",
              "mrays_per_s", "ratio_to_embree", "nodes_per_ray", "tests_per_ray", "mismatches"})
            EXPECT_TRUE(row.find(field)) << field;
    std::set<std::string> kinds;
    for (const Row &row : rows)
        kinds.insert(text_of(row, "rays"));
    EXPECT_EQ(kinds, all_kinds);
}

// A contestant that now and then says the wrong thing.
class Liar final : public Contestant {
  public:
    explicit Liar(std::unique_ptr<Contestant> honest, int kind) : honest_(std::move(honest)), kind_(kind) {}
    void closest(std::span<const TestRay> rays, std::span<Hit<double>> found) const override {
        honest_->closest(rays, found);
        const auto lie = std::ranges::find_if(found, [](const Hit<double> &hit) { return bool(hit); });
        if (lie == found.end())
            return;
        if (kind_ == 0)
            *lie = {};
        else if (kind_ == 1)
            lie->id ^= 1;
        else
            lie->t = next_up(lie->t);
    }
    void shadow(std::span<const TestRay> rays, std::span<unsigned char> blocked) const override {
        honest_->shadow(rays, blocked);
        blocked[0] = !blocked[0];
    }
    std::size_t bytes() const override { return honest_->bytes(); }

  private:
    std::unique_ptr<Contestant> honest_;
    int kind_;
};

TEST(Comparison, ALieIsFoundOut) {
    const Entrant bvh = find_entrant(our_structures(), "bvh");
    for (int kind = 0; kind < 3; ++kind) {
        const std::vector<Entrant> liars{{"liar", "default", [&](std::span<const Triangle<>> triangles) {
                                              return std::make_unique<Liar>(bvh.build(triangles), kind);
                                          }}};
        for (const Row &row : compare_tiny(triangle_soup(300, 1), liars)) {
            EXPECT_EQ(number_of(row, "mismatches"), 1) << json_line(row);
            EXPECT_EQ(number_of(row, "leaks"), kind == 0 || text_of(row, "rays") == "shadow" ? 1 : 0);
        }
    }
}

TEST(Comparison, BruteForceIsAskedEvenWhereTheTracerLies) {
    const TestScene scene = tiny(triangle_soup(300, 1));
    const Entrant bvh = find_entrant(our_structures(), "bvh");
    const auto honest = bvh.build(scene.triangles);
    const Liar liar(bvh.build(scene.triangles), 0);
    const Scene<Triangle<>> brute(scene.triangles);
    for (const RayBatch &batch : ray_batches(scene, *honest, 16, 1)) {
        const Truth truth = truth_of(batch, brute, liar, 1e9), expected = truth_of(batch, brute, *honest, 0);
        for (std::size_t i = 0; i < truth.size(); ++i)
            EXPECT_EQ(truth[i].id, expected[i].id);
    }
}

// A contestant that is slow the first time, as all are with cold caches, and so would be given a third of the rays.
class SlowToBegin final : public Contestant {
  public:
    void closest(std::span<const TestRay>, std::span<Hit<double>>) const override {
        if (!std::exchange(begun_, true))
            std::this_thread::sleep_for(std::chrono::milliseconds(30));
    }
    void shadow(std::span<const TestRay>, std::span<unsigned char>) const override {}
    std::size_t bytes() const override { return 0; }

  private:
    mutable bool begun_ = false;
};

TEST(Comparison, AColdStartCostsNoRays) {
    const RayBatch batch{"primary", std::vector<TestRay>(4096)};
    EXPECT_EQ(share_for(SlowToBegin(), batch, 0.5).rays.size(), batch.rays.size());
}

TEST(Comparison, RaysAreTheSameForTheSameSeed) {
    const TestScene scene = tiny(terrain(20, 3));
    const auto tracer = find_entrant(our_structures(), "bvh").build(scene.triangles);
    const auto a = ray_batches(scene, *tracer, 16, 7), b = ray_batches(scene, *tracer, 16, 7);
    ASSERT_EQ(a.size(), 5u);
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < a[i].rays.size(); ++j)
            EXPECT_EQ(a[i].rays[j].direction, b[i].rays[j].direction);
    const auto tracer_finds = [&](const RayBatch &batch) {
        std::vector<Hit<double>> found(batch.rays.size());
        tracer->closest(batch.rays, found);
        return std::ranges::count_if(found, [](const Hit<double> &hit) { return bool(hit); });
    };
    EXPECT_GT(tracer_finds(a[0]), 0);
    EXPECT_EQ(tracer_finds(a[4]), 0); // the rays that must miss
}

TEST(Comparison, AShadowRayMeetsNothingBeyondItsLight) {
    const Triangles wall{{{-9, -9, 0}, {9, -9, 0}, {0, 9, 0}}};
    for (const Entrant &entrant : contestants()) {
        const auto built = entrant.build(wall);
        const std::vector<TestRay> rays{{{0, 0, 2}, {0, 0, -1}, 1}, {{0, 0, 2}, {0, 0, -1}, 3}};
        std::vector<unsigned char> blocked(2);
        built->shadow(rays, blocked);
        EXPECT_FALSE(blocked[0]) << entrant.structure;
        EXPECT_TRUE(blocked[1]) << entrant.structure;
        EXPECT_GE(built->bytes(), sizeof(Triangle<>)) << entrant.structure;
    }
}

// On two scenes: in the mean, one call is best for primary rays and another for shuffled ones. The robust mode does not
// count, and neither does a scene that was not named.
TEST(Comparison, RatiosAreToEmbreesBestCallForEachKind) {
    std::vector<Row> rows;
    const auto add = [&](const char *scene, const char *structure, const char *kind, double speed) {
        rows.push_back(Row()
                           .set("scene", scene)
                           .set("structure", structure)
                           .set("kernel", "own")
                           .set("rays", kind)
                           .set("mrays_per_s", speed)
                           .set("floor_ns", 10 * speed));
    };
    for (const double scale : {1.0, 4.0}) {
        const char *const scene = scale == 1 ? "a" : "b";
        add(scene, "wide-packets", "primary", 3 * scale);
        add(scene, "wide-packets", "shuffled", 1);
        add(scene, "embree", "primary", 1);
        add(scene, "embree", "shuffled", 2);
        add(scene, "embree-robust", "primary", 100);
        add(scene, "embree-8-coherent", "primary", 4);
        add(scene, "embree-8-coherent", "shuffled", 1);
    }
    add("c", "embree", "primary", 1000);
    EXPECT_TRUE(has_batches(rows));
    const std::vector<Row> table = best_calls_table(rows, {"a", "b"});
    EXPECT_EQ(text_of(table.back(), "primary"), "embree-8-coherent");
    EXPECT_EQ(text_of(table.back(), "shuffled"), "embree");
    EXPECT_EQ(text_of(table.front(), "structure"), "wide-packets");
    EXPECT_DOUBLE_EQ(number_of(table.front(), "primary"), 1.5); // the root of 3/4 times 12/4
    EXPECT_DOUBLE_EQ(number_of(table.front(), "shuffled"), 0.5);
    EXPECT_DOUBLE_EQ(number_of(table.front(), "floor ns"), 120);
}

TEST(Comparison, TheExponentOfAPowerIsFound) {
    std::vector<std::pair<double, double>> points;
    for (const double n : {1e3, 1e4, 1e6})
        points.push_back({n, 3 * std::pow(n, 0.25)});
    EXPECT_NEAR(*fitted_exponent(points), 0.25, 1e-12);
    EXPECT_FALSE(fitted_exponent({{1e3, 5.0}}));
}

TEST(Comparison, ScenesHaveTheTrianglesThatTheyPromise) {
    EXPECT_EQ(tetra(4).size(), 4u * 4 * 4 * 4 * 4);
    EXPECT_EQ(terrain(10, 1).size(), 200u);
    EXPECT_EQ(sphereflake(2, 1).size(), (1 + 9 + 81) * 80u);
    EXPECT_EQ(subdivided(tetra(0), 2).size(), 64u);
    EXPECT_EQ(gears(2, 12).size(), 8 * 32 * 12u);
    EXPECT_EQ(mount(3, 1, 1).size(), 4 * 64 + 4 * 80u);
    for (const Triangles &triangles :
         {sphereflake(1, 1), hall(3, 1), tree(1, 5, 1), rings(2, 8, 6, 1), gears(2, 8), mount(4, 1, 1)})
        for (const Triangle<> &triangle : triangles)
            for (const Vec<float> &corner : {triangle.a, triangle.b, triangle.c})
                EXPECT_TRUE(std::isfinite(corner.x + corner.y + corner.z));
}

// How often each edge is passed in one direction and not in the other: never in a closed surface with one outside.
std::size_t open_edges(const Triangles &triangles) {
    using Point = std::array<float, 3>;
    std::map<std::pair<Point, Point>, int> passed;
    const auto key = [](const Vec<float> &p) { return Point{p.x + 0.0f, p.y + 0.0f, p.z + 0.0f}; };
    for (const auto &[a, b, c] : triangles)
        for (const auto &[from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
            ++passed[{key(from), key(to)}];
            --passed[{key(to), key(from)}];
        }
    return static_cast<std::size_t>(std::ranges::count_if(passed, [](const auto &edge) { return edge.second > 0; }));
}

TEST(Comparison, TheMountainHasNoCracksAndAGearIsClosed) {
    EXPECT_EQ(open_edges(mount(4, 1, 1)), 4 * 16u); // the rim at the foot of the pyramid
    for (const bool between : {false, true}) {
        Triangles gear;
        add_gear(gear, 8, {0, 0, 0}, between);
        EXPECT_EQ(open_edges(gear), 0u);
        double volume = 0;
        for (const auto &[a, b, c] : gear)
            volume += dot(Vec<double>(a), cross(Vec<double>(b), Vec<double>(c))) / 6;
        EXPECT_GT(volume, 0); // its outside is outside
    }
}

} // namespace
