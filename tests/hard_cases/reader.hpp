// The reader's own kernels (--kernel FILE): compiled into a program of their own, so that a crash or an endless loop in
// them ends that program alone. README.md says how such a file looks; example_kernel.cpp is one.
#pragma once
#include "tests/hard_cases/suite.hpp"

#include <filesystem>
#include <memory>
#include <mutex>
#include <vector>

namespace course::hard {

class Reader {
  public:
    // Throws InputError naming the file: missing, not compiling (with the compiler's first complaint), or without a
    // function that is known here.
    explicit Reader(const std::string &file, int seconds_allowed = 20);
    ~Reader();
    Reader(const Reader &) = delete;
    Reader &operator=(const Reader &) = delete;

    // Whether the file has a kernel for this test ("sphere") that takes this scalar ("float").
    bool has(const std::string &test, const std::string &scalar) const;

    // Runs the kernel over `count` rays and shapes, as they lie in memory, `rounds` times; returns the median seconds.
    // After a crash or a loop every t is `no_hit`, and failures() tells.
    double run(const std::string &test, const std::string &scalar, const void *rays, std::size_t ray_bytes,
               const void *shapes, std::size_t shape_bytes, std::span<double> t, int rounds);

    // "sphere, float: crashed (signal 11)", each once.
    std::vector<std::string> failures() const;

  private:
    void fail(const std::string &test, const std::string &scalar, const std::string &how);

    std::string file_;
    int seconds_allowed_;
    std::filesystem::path folder_;
    std::vector<std::string> known_; // "sphere float"
    std::vector<std::string> failures_;
    mutable std::mutex guard_;
};

// The rows for the reader's kernels of one primitive.
template <class Shape>
void add_reader_rows(const std::shared_ptr<Reader> &reader, const std::string &test, std::vector<Kernel<Shape>> &rows) {
    for (const std::string scalar : {"float", "double"}) {
        if (!reader || !reader->has(test, scalar))
            continue;
        const auto run = [=](const Batch<Shape> &batch, std::span<double> t, int rounds) {
            const bool is_float = scalar == "float";
            const void *rays = is_float ? static_cast<const void *>(batch.float_rays.data()) : batch.rays.data();
            const std::size_t size = is_float ? sizeof(Ray<float>) : sizeof(Ray<double>);
            return reader->run(test, scalar, rays, size * batch.size(), batch.shapes.data(),
                               sizeof(Shape) * batch.size(), t, rounds);
        };
        Kernel<Shape> row{"yours", scalar, false, {}, {}};
        row.run = [run](const Batch<Shape> &batch, std::span<double> t) { run(batch, t, 1); };
        row.seconds = run;
        rows.push_back(row);
    }
}

} // namespace course::hard
