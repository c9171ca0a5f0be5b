#include "chapters/08_mesh/ball.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace course {

Mesh<> ball(int level, float radius) {
    const float g = (1 + std::sqrt(5.0f)) / 2; // the golden ratio
    Mesh<> mesh{{{-1, g, 0},
                 {1, g, 0},
                 {-1, -g, 0},
                 {1, -g, 0},
                 {0, -1, g},
                 {0, 1, g},
                 {0, -1, -g},
                 {0, 1, -g},
                 {g, 0, -1},
                 {g, 0, 1},
                 {-g, 0, -1},
                 {-g, 0, 1}},
                {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                 {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                 {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
    for (; level > 0; --level) {
        // Each edge gets a point in its middle, the same for both of its triangles; each triangle becomes four.
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
        const auto middle = [&](std::uint32_t i, std::uint32_t j) {
            const auto [place, is_new] = middles.try_emplace(std::minmax(i, j), mesh.points.size());
            if (is_new)
                mesh.points.push_back((mesh.points[i] + mesh.points[j]) / 2.0f);
            return place->second;
        };
        std::vector<std::array<std::uint32_t, 3>> finer;
        for (const auto &[a, b, c] : mesh.indices) {
            const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
        }
        mesh.indices = std::move(finer);
    }
    for (Vec<float> &point : mesh.points)
        point *= radius / length(point);
    return mesh;
}

} // namespace course
