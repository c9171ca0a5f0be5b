// Lesson 15, step 4: eight triangles at once. What surely misses is dropped in float; chapter 08 decides about the
// rest.
#pragma once
#include "chapters/08_mesh/triangle.hpp"
#include "chapters/15_wide_bvh/lanes.hpp"
#include "chapters/15_wide_bvh/options.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace course {

// A leaf's triangles side by side: five cache lines. Lanes beyond the last triangle repeat it.
struct alignas(64) TriangleLeaf {
    float corners[3][3][lanes]; // by corner, axis, triangle
    Id ids_and_size[lanes];     // 28 bits are the id; the rest of the first two is the power of two above all edges

    static constexpr Id id_bits = (Id{1} << 28) - 1;

    TriangleLeaf(std::span<const Triangle<float>> triangles, std::span<const Id> ids) {
        float size = 0;
        for (std::size_t i = 0; i < lanes; ++i) {
            const std::size_t from = std::min(i, ids.size() - 1);
            const Triangle<float> &triangle = triangles[ids[from]];
            for (int axis = 0; axis < 3; ++axis) {
                const float a = triangle.a[axis], b = triangle.b[axis], c = triangle.c[axis];
                corners[0][axis][i] = a, corners[1][axis][i] = b, corners[2][axis][i] = c;
                size = std::max(size, std::max({a, b, c}) - std::min({a, b, c}));
            }
            ids_and_size[i] = ids[from];
        }
        // Rounded up to a power of two; infinity where that is beyond float.
        const Id exponent = std::min((std::bit_cast<Id>(size) >> 23) + 1, Id{255});
        ids_and_size[0] |= (exponent & 15) << 28;
        ids_and_size[1] |= (exponent >> 4) << 28;
    }

    Id id(unsigned lane) const { return ids_and_size[lane] & id_bits; }
    // No side of any triangle's box is longer.
    float size() const { return std::bit_cast<float>((ids_and_size[0] >> 28 | ids_and_size[1] >> 28 << 4) << 23); }

    Triangle<float> operator[](unsigned lane) const {
        const auto corner = [&](int k) -> Vec<float> {
            return {corners[k][0][lane], corners[k][1][lane], corners[k][2][lane]};
        };
        return {corner(0), corner(1), corner(2)};
    }
};
static_assert(sizeof(TriangleLeaf) == 320);

// A ray made ready for triangles, eight at a time. README.md derives its bounds.
template <WideOptions Options> class TriangleRay {
  public:
    template <class T> explicit TriangleRay(const Ray<T> &ray) {
        const Vec<double> origin(ray.origin), direction(ray.direction), size = abs(direction);
        z_ = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
        x_ = z_ == 2 ? 0 : z_ + 1;
        y_ = x_ == 2 ? 0 : x_ + 1;
        scale_ = size[z_];
        const double sign = std::copysign(1.0, direction[z_]);
        sign_ = all(static_cast<float>(sign));
        origin_x_ = all(static_cast<float>(origin[x_]));
        origin_y_ = all(static_cast<float>(origin[y_]));
        minus_origin_z_ = all(static_cast<float>(-sign * origin[z_]));
        slope_x_ = all(static_cast<float>(-direction[x_] / scale_));
        slope_y_ = all(static_cast<float>(-direction[y_] / scale_));

        const Vec<double> rounded(static_cast<double>(static_cast<float>(origin.x)),
                                  static_cast<double>(static_cast<float>(origin.y)),
                                  static_cast<double>(static_cast<float>(origin.z)));
        const Vec<double> off = abs(origin - rounded);
        origin_error_ = static_cast<float>(std::max({off.x, off.y, off.z})) * (1 + 0x1p-20f);
        t_min_ = static_cast<float>(static_cast<double>(ray.t_min) * scale_) * (1 - 0x1p-22f);
    }

    // A t of the ray as a distance along z, rounded up.
    float scaled(double t) const { return static_cast<float>(t * scale_) * (1 + 0x1p-22f); }

    // A bit for each triangle that the ray may hit before t_max (scaled).
    unsigned operator()(const TriangleLeaf &leaf, float t_max) const {
        constexpr float eps = 0x1p-24f;
        const Seen8 a = see(leaf, 0), b = see(leaf, 1), c = see(leaf, 2);
        const Floats u = edge(b, c), v = edge(c, a), w = edge(a, b);

        const float size = leaf.size();
        const Floats off = fused(absolute(a.z), all(Options.edge_bound * 10 * eps),
                                 all(Options.edge_bound * (3 * origin_error_ + 40 * eps * size) + 0x1p-60f));
        const Floats reach = fused(off, all(8.0f), all(8 * size)), edge_error = off * reach;
        const unsigned sides_differ =
            above(-edge_error, smaller(smaller(u, v), w)) & above(larger(larger(u, v), w), edge_error);

        const Floats area = u + v + w, size_of_area = absolute(area);
        const Floats sum = fused(u, a.z, fused(v, b.z, w * c.z)), along = with_sign_of(sum, area);
        const Floats error = fused(edge_error, reach, off * size_of_area) * all(Options.window_bound);
        const unsigned before = above(size_of_area * all(t_min_), along + error),
                       after = above(along - error, size_of_area * all(t_max));
        return ~(sides_differ | before | after) & 255;
    }

  private:
    struct Seen8 {
        Floats x, y, z;
    };
    Seen8 see(const TriangleLeaf &leaf, int corner) const {
        const auto &rows = leaf.corners[corner];
        const Floats z = fused(load(rows[z_]), sign_, minus_origin_z_);
        return {fused(slope_x_, z, load(rows[x_]) - origin_x_), fused(slope_y_, z, load(rows[y_]) - origin_y_), z};
    }
    static Floats edge(const Seen8 &b, const Seen8 &c) { return fused(c.x, b.y, -(c.y * b.x)); }

    int x_, y_, z_;
    double scale_;
    Floats sign_, origin_x_, origin_y_, minus_origin_z_, slope_x_, slope_y_;
    float origin_error_, t_min_;
};

} // namespace course
