// Lesson 02, the measurement: what each test costs, beside the sphere's.
#pragma once
#include "chapters/02_primitives/marching.hpp"
#include "chapters/02_primitives/random_shapes.hpp"
#include "common/report.hpp"
#include "common/timing.hpp"

namespace course {

// The tests to be timed, each a loop over its own random pairs of ray and shape.
class CostTable {
  public:
    explicit CostTable(std::uint64_t seed) : seed_(seed) {}

    // `form` calls the test: form(ray, shape). Rays have the scalar T. Many pairs, so that the branch predictor does
    // not learn them by heart; slow tests time fewer, so that every round is short beside the system's time slices.
    template <class T, class Shape, class Form>
    void add(const std::string &shape_name, const std::string &form_name, Form form, std::size_t timed = pair_count) {
        std::vector<std::pair<Ray<T>, Shape>> pairs;
        int hits = 0;
        for (std::uint64_t i = 0; i < pair_count; ++i) {
            Random random(seed_, i);
            const Shape shape = random_shape(random, Shape{});
            const Ray<double> ray = random_ray(random);
            pairs.emplace_back(Ray<T>{Vec<T>(ray.origin), Vec<T>(ray.direction)}, shape);
            hits += form(pairs.back().first, shape).has_value();
        }
        pairs.resize(timed);
        rows_.push_back(Row().set("shape", shape_name).set("form", form_name));
        rows_.back()
            .set("scalar", sizeof(T) == 4 ? "float" : "double")
            .set("hit_percent", Value(100.0 * hits / pair_count));
        timed_.push_back(static_cast<double>(timed));
        loops_.push_back([pairs = std::move(pairs), form] {
            for (const auto &[ray, shape] : pairs)
                keep(form(ray, shape));
        });
    }

    // Nanoseconds a test, and their ratio to the first test that was added.
    std::vector<Row> measured(int rounds) const {
        const std::vector<double> seconds = median_seconds(loops_, rounds);
        std::vector<Row> rows = rows_;
        for (std::size_t i = 0; i < rows.size(); ++i)
            rows[i]
                .set("ns_per_test", Value(1e9 * seconds[i] / timed_[i]))
                .set("ratio_to_sphere", Value(seconds[i] / timed_[i] * timed_[0] / seconds[0]));
        return rows;
    }

  private:
    static constexpr int pair_count = 20000;
    std::uint64_t seed_;
    std::vector<Row> rows_;
    std::vector<double> timed_;
    std::vector<std::function<void()>> loops_;
};

inline std::vector<Row> cost_of_each_test(std::uint64_t seed, int rounds) {
    CostTable table(seed);
    const auto robust = [](const auto &ray, const auto &shape) { return intersect(ray, shape); };
    const auto textbook = [](const auto &ray, const auto &shape) { return intersect_textbook(ray, shape); };
    const auto add = [&]<class Shape>(const std::string &name, const Shape &) {
        table.add<double, Shape>(name, "default", robust);
        table.add<float, Shape>(name, "textbook", textbook);
    };
    add("sphere", Sphere<>{});
    add("plane", Plane<>{});
    add("disk", Disk<>{});
    add("triangle, affine", AffineTriangle<>{});
    add("cylinder", Cylinder<>{});
    add("cone", Cone<>{});
    add("box", Box<>{});
    const auto marching = [](const auto &ray, const auto &shape) { return intersect_marching(ray, shape, 100); };
    const auto add_implicit = [&]<class Shape>(const std::string &name, const Shape &) {
        table.add<double, Shape>(name, "default", robust, 200);
        table.add<double, Shape>(name, "100 steps", marching, 200);
    };
    add_implicit("implicit torus", Implicit<Torus<>>{});
    add_implicit("implicit thin ring", Implicit<ThinRing>{});
    add_implicit("implicit blob", Implicit<LatticeBlob<>>{});
    return table.measured(rounds);
}

} // namespace course
