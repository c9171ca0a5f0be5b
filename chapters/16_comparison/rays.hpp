// Lesson 16, step 9: the rays: from the eye, bounced, the same shuffled, and towards a light.
#pragma once
#include "chapters/01_ray_casting/camera.hpp"
#include "chapters/16_comparison/contest.hpp"
#include "chapters/16_comparison/scenes.hpp"
#include "common/random.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace course {

struct RayBatch {
    std::string kind; // primary, bounce, shuffled or shadow; miss for rays that are far from everything
    std::vector<TestRay> rays;

    bool is_shadow() const { return kind == "shadow"; }
};

// Where a ray met the scene, and the normal on the side that it came from.
struct Bouncing {
    Vec<double> point, normal;
};

inline Bouncing bounce_of(const TestRay &ray, const Hit<double> &hit, const Triangle<> &triangle) {
    const Vec<double> direction(ray.direction), normal = normalize(area_vector(triangle));
    return {Vec<double>(ray.origin) + hit.t * direction, dot(normal, direction) > 0 ? -normal : normal};
}

// A place just off the surface that is still off it as floats. (A renderer of this course keeps doubles instead; but
// here each contestant shall get the same ray, and most take floats.)
inline Vec<float> lifted(const Bouncing &from) {
    const Vec<double> size = abs(from.point);
    return Vec<float>(from.point + 0x1p-19 * std::max({size.x, size.y, size.z}) * from.normal);
}

// A random direction around the normal, the likelier the nearer to it (with the cosine).
inline Vec<float> cosine_direction(const Vec<double> &normal, Random &random) {
    const double z = random.uniform(-1, 1), turn = random.uniform();
    const Vec<double> sum = normal + std::sqrt(1 - z * z) * around_z(turn) + Vec<double>(0, 0, z);
    return Vec<float>(length(sum) > 1e-3 ? normalize(sum) : normal);
}

// All kinds of rays for a scene, side² of each; `tracer` finds out where the eye's rays end. A kind that the scene
// gives no ray for is left out.
inline std::vector<RayBatch> ray_batches(const TestScene &scene, const Contestant &tracer, int side,
                                         std::uint64_t seed) {
    const auto count = static_cast<std::size_t>(side) * static_cast<std::size_t>(side);
    RayBatch primary{"primary", {}}, bounce{"bounce", {}}, shadow{"shadow", {}}, miss{"miss", {}};
    const Camera camera(scene.view, side, side);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const Ray<double> ray = camera.ray(x + 0.5, y + 0.5);
            primary.rays.push_back({Vec<float>(ray.origin), Vec<float>(ray.direction)});
        }
    std::vector<Hit<double>> hits(count);
    tracer.closest(primary.rays, hits);
    std::vector<Bouncing> places, lit;
    for (std::size_t i = 0; i < count; ++i)
        if (hits[i]) {
            places.push_back(bounce_of(primary.rays[i], hits[i], scene.triangles[hits[i].id]));
            if (dot(scene.light - places.back().point, places.back().normal) > 0)
                lit.push_back(places.back());
        }

    // In the order of the picture. Where few of the eye's rays hit, each hit sends out several.
    for (std::size_t i = 0; i < count && !places.empty(); ++i) {
        Random random(seed, i);
        const Bouncing &from = places[i * places.size() / count];
        bounce.rays.push_back({lifted(from), cosine_direction(from.normal, random)});
    }
    for (std::size_t i = 0; i < count && !lit.empty(); ++i) {
        const Vec<float> from = lifted(lit[i * lit.size() / count]);
        shadow.rays.push_back({from, Vec<float>(scene.light - Vec<double>(from)), 1});
    }
    RayBatch shuffled{"shuffled", bounce.rays};
    Random random(seed, count);
    for (std::size_t i = shuffled.rays.size(); i > 1; --i)
        std::swap(shuffled.rays[i - 1], shuffled.rays[random.bits() % i]);

    // Beyond the upper corner, and on from there.
    const Box<float> box = bounds(std::span<const Triangle<>>(scene.triangles));
    const Vec<float> beyond = box.hi + (box.hi - box.lo) + abs(box.hi);
    for (std::size_t i = 0; i < count; ++i) {
        Random stream(seed, count + 1 + i);
        const Vec<double> way(stream.uniform(0.2, 1), stream.uniform(0.2, 1), stream.uniform(0.2, 1));
        miss.rays.push_back({beyond, Vec<float>(way)});
    }
    std::vector<RayBatch> batches{primary, bounce, shuffled, shadow, miss};
    std::erase_if(batches, [](const RayBatch &batch) { return batch.rays.empty(); });
    return batches;
}

} // namespace course
