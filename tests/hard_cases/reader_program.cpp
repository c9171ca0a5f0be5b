// The program that --kernel compiles around the reader's file: it reads rays and shapes from its input, runs the kernel
// over them, and writes the median seconds of a round and every t.
#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

// What a name means that the file does not define: the worst match of all.
struct Absent {};
Absent sphere(...);
Absent plane(...);
Absent disk(...);
Absent triangle(...);
Absent box(...);
Absent cylinder(...);
Absent cone(...);

#include READER_FILE

namespace {

// One function object per shape, from a ray (origin, direction, t_min, t_max) and the shape's floats to t.
struct AsSphere {
    static constexpr int floats = 4;
    template <class T> auto operator()(const T *r, const float *s) const {
        return sphere(r, r + 3, r[6], r[7], s, s[3]);
    }
};
struct AsPlane {
    static constexpr int floats = 6;
    template <class T> auto operator()(const T *r, const float *s) const {
        return plane(r, r + 3, r[6], r[7], s, s + 3);
    }
};
struct AsDisk {
    static constexpr int floats = 7;
    template <class T> auto operator()(const T *r, const float *s) const {
        return disk(r, r + 3, r[6], r[7], s, s + 3, s[6]);
    }
};
struct AsTriangle {
    static constexpr int floats = 9;
    template <class T> auto operator()(const T *r, const float *s) const {
        return triangle(r, r + 3, r[6], r[7], s, s + 3, s + 6);
    }
};
struct AsBox {
    static constexpr int floats = 6;
    template <class T> auto operator()(const T *r, const float *s) const { return box(r, r + 3, r[6], r[7], s, s + 3); }
};
struct AsCylinder {
    static constexpr int floats = 7;
    template <class T> auto operator()(const T *r, const float *s) const {
        return cylinder(r, r + 3, r[6], r[7], s, s + 3, s[6]);
    }
};
struct AsCone {
    static constexpr int floats = 7;
    template <class T> auto operator()(const T *r, const float *s) const {
        return cone(r, r + 3, r[6], r[7], s, s + 3, s[6]);
    }
};

template <class F, class T> constexpr bool is_there =
    !std::is_same_v<decltype(F{}(static_cast<const T *>(nullptr), static_cast<const float *>(nullptr))), Absent>;

template <class F, class T> void run(std::size_t count, int rounds) {
    if constexpr (is_there<F, T>) {
        std::vector<T> rays(8 * count);
        std::vector<float> shapes(F::floats * count);
        std::vector<double> t(count), seconds;
        if (std::fread(rays.data(), sizeof(T), rays.size(), stdin) != rays.size() ||
            std::fread(shapes.data(), sizeof(float), shapes.size(), stdin) != shapes.size())
            std::exit(3);
        for (int round = 0; round < rounds; ++round) {
            const auto start = std::chrono::steady_clock::now();
            for (std::size_t i = 0; i < count; ++i) {
                const double found = static_cast<double>(F{}(&rays[8 * i], &shapes[F::floats * i]));
                t[i] = found < 0 || found == std::numeric_limits<double>::infinity() ? -1 : found;
            }
            seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
        }
        std::nth_element(seconds.begin(), seconds.begin() + rounds / 2, seconds.end());
        std::fwrite(&seconds[static_cast<std::size_t>(rounds / 2)], sizeof(double), 1, stdout);
        std::fwrite(t.data(), sizeof(double), t.size(), stdout);
    }
}

template <class F> void offer(const char *name, int argc, char **argv) {
    if (argc < 5) {
        if (is_there<F, float>)
            std::printf("%s float\n", name);
        if (is_there<F, double>)
            std::printf("%s double\n", name);
    } else if (std::strcmp(argv[1], name) == 0) {
        const auto count = static_cast<std::size_t>(std::atoll(argv[3]));
        std::string(argv[2]) == "float" ? run<F, float>(count, std::atoi(argv[4]))
                                        : run<F, double>(count, std::atoi(argv[4]));
    }
}

} // namespace

int main(int argc, char **argv) {
    offer<AsSphere>("sphere", argc, argv);
    offer<AsPlane>("plane", argc, argv);
    offer<AsDisk>("disk", argc, argv);
    offer<AsTriangle>("triangle", argc, argv);
    offer<AsBox>("box", argc, argv);
    offer<AsCylinder>("cylinder", argc, argv);
    offer<AsCone>("cone", argc, argv);
}
