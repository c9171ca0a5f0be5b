// How a primitive's kernels are judged: families of hard cases, each in several cells (one parameter value each), every
// kernel on the same cases, every case decided by the oracle. See README.md for the words.
#pragma once
#include "common/random.hpp"
#include "common/report.hpp"
#include "tests/oracle/oracle.hpp"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace course::hard {

class Reader;
class Shaders;

struct Settings {
    std::vector<std::string> families; // empty: all of them
    std::uint64_t seed = 1;
    std::size_t cases = 20'000;            // per cell
    std::size_t degenerate_cases = 20'000; // H14 has but one cell for each test, and ten times as many cases
    int timing_rounds = 7;
    bool quick = true;
    std::shared_ptr<Reader> reader;              // of --kernel
    std::shared_ptr<Shaders> shaders;            // chapter 17's, where OpenGL is to be had
    std::map<std::string, std::string> replaced; // of --replace-default: a test, and the kernel that plays its default
    std::function<void(double share)> done = [](double) {}; // a suite says what share of its work is done since last

    bool wants(const std::string &family) const {
        return families.empty() || std::ranges::find(families, family) != families.end();
    }
};

// Case i of every cell is made from (seed, i) alone: the same on any number of threads.
template <class Shape> struct Case {
    Ray<double> ray; // its numbers are floats, unless the family says otherwise
    Shape shape;
};

// The same rays twice, so that no kernel pays for a conversion.
template <class Shape> struct Batch {
    std::vector<Ray<double>> rays;
    std::vector<Ray<float>> float_rays;
    std::vector<Shape> shapes;

    void add(const Case<Shape> &one) {
        rays.push_back(one.ray);
        float_rays.push_back({Vec<float>(one.ray.origin), Vec<float>(one.ray.direction),
                              static_cast<float>(one.ray.t_min), static_cast<float>(one.ray.t_max)});
        shapes.push_back(one.shape);
    }
    std::size_t size() const { return shapes.size(); }
};

// What run() writes for a ray that the kernel lets pass.
inline constexpr double no_hit = -1;

template <class Shape> struct Kernel {
    std::string name, scalar; // scalar: of the ray that goes in and of the t that comes out
    bool is_default = false;
    std::function<void(const Batch<Shape> &, std::span<double> t)> run;
    // The median seconds of a run, for a kernel that must measure by itself; empty for all others.
    std::function<double(const Batch<Shape> &, std::span<double> t, int rounds)> seconds = {};
    // A kernel in float that must not be wrong more often than this one of the CPU's on the same cases.
    std::string no_worse_than = {};
};

// The row for a kernel written as a function of (ray, shape); the loop over the cases is compiled with it inside.
template <class T, class Shape, class Intersect>
Kernel<Shape> kernel(const std::string &name, Intersect intersect, bool is_default = false) {
    const auto run = [intersect](const Batch<Shape> &batch, std::span<double> t) {
        for (std::size_t i = 0; i < batch.size(); ++i) {
            std::optional<T> found;
            if constexpr (std::is_same_v<T, float>)
                found = intersect(batch.float_rays[i], batch.shapes[i]);
            else
                found = intersect(batch.rays[i], batch.shapes[i]);
            t[i] = found ? static_cast<double>(*found) : no_hit;
        }
    };
    return {name, sizeof(T) == 4 ? "float" : "double", is_default, run, {}};
}

template <class Shape> struct Cell {
    std::string family, parameter;
    std::function<Case<Shape>(Random &)> make;
    bool double_rays = false; // the rays' numbers are no floats: only kernels for double rays are asked
};

template <class Shape> struct Primitive {
    std::string test; // "sphere"
    std::vector<Kernel<Shape>> kernels;
    std::vector<Cell<Shape>> cells;
    std::function<Case<Shape>(Random &)> random; // easy rays, about half of which hit: the usual time of a test
    std::string all_in_float = "textbook";       // of the kernels, the best that has nothing but floats, as a shader
};

// What a family's default kernel must reach, and whether it is asked at all.
struct Threshold {
    double misclassified_per_million = 0, t_error_ulp = 1;
    bool false_hits_count = true;
};
Threshold threshold_of(const std::string &family, bool quick);

// |t - exact| in ulps of a float at the exact value.
double float_ulps(double t, double exact);

struct Tally {
    std::uint64_t cases = 0, false_misses = 0, false_hits = 0, nan = 0;
    std::vector<float> t_errors; // a sample, for the median
    double t_error_max = 0;

    // `t` as run() wrote it. A hit counts as one only if its t is a number in the ray's range.
    void judge(const exact::Answer &truth, double t);
    void add(const Tally &other);
    double t_error_median() const;
};

// One primitive's results: rows for the report, and whether every default kernel reached its threshold.
struct Outcome {
    std::vector<Row> rows;
    bool passed = true;
};
void append(Outcome &all, Outcome one);

// A measurement that the program can run: a primitive's cells, or a family with a measure of its own.
struct Suite {
    std::string name;
    std::vector<std::string> families;
    std::function<Outcome(const Settings &)> measure;
    double work = 1; // about how long a full run of it takes, beside the others'
};

} // namespace course::hard
