// Lesson 16, step 10b: who stays away from large scenes, and why, so that the full comparison ends.
#pragma once
#include "chapters/16_comparison/contest.hpp"

#include <array>
#include <cstddef>
#include <string>

namespace course {

struct Limit {
    const char *structure;
    double triangles; // it takes part on scenes of so many
    const char *why;
};
inline constexpr std::array limits{
    Limit{"none", 300'000, "each ray tests every triangle"},
    Limit{"kd-median", 300'000, "40 us and 360 bytes a triangle to build"},
    Limit{"bsp", 300'000, "50 us a triangle to build, and more"},
    Limit{"octree", 5'000'000, "8 us a triangle to build"},
    Limit{"kd-middle", 5'000'000, "12 us a triangle to build"},
    Limit{"kd-sah", 5'000'000, "2 to 9 us a triangle to build"},
    Limit{"bvh-median", 5'000'000, "spares memory for the others"},
    Limit{"cgal", 5'000'000, "spares memory for the others"},
    Limit{"embree-robust", 5'000'000, "spares memory for the others"},
    Limit{"embree-avx2", 5'000'000, "spares memory for the others"},
};
inline constexpr double most_for_plain = 150'000; // but for the BVH

// Why the entrant does not take part on a scene of so many triangles; empty where it does. `scale` makes all limits
// smaller or larger.
inline std::string left_out(const Entrant &entrant, std::size_t triangles, double scale) {
    const double size = static_cast<double>(triangles) / scale;
    for (const Limit &limit : limits)
        if (entrant.structure == limit.structure && size > limit.triangles)
            return limit.why;
    if (entrant.kernel == "plain" && entrant.structure != "bvh" && size > most_for_plain)
        return "the plain kernel is measured on smaller scenes";
    return {};
}

// Takes those out of the list that do not take part. Returns who they are, in words.
inline std::string leave_out(std::vector<Entrant> &entrants, std::size_t triangles, double scale) {
    std::string words;
    bool plain = false;
    for (const Entrant &entrant : entrants)
        if (const std::string why = left_out(entrant, triangles, scale); !why.empty()) {
            plain |= entrant.kernel == "plain";
            if (entrant.kernel != "plain")
                words += (words.empty() ? "" : "; ") + entrant.structure + " (" + why + ")";
        }
    if (plain)
        words +=
            std::string(words.empty() ? "" : "; ") + "the plain kernel but in the bvh (measured on smaller scenes)";
    std::erase_if(entrants, [&](const Entrant &entrant) { return !left_out(entrant, triangles, scale).empty(); });
    return words;
}

} // namespace course
