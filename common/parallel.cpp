#include "common/parallel.hpp"

#include <algorithm>
#include <execution>
#include <memory>
#include <numeric>
#include <tbb/global_control.h>
#include <thread>

namespace course {

void parallel_for(std::size_t count, const std::function<void(std::size_t)> &work) {
    std::vector<std::size_t> indices(count);
    std::iota(indices.begin(), indices.end(), std::size_t{0});
    std::for_each(std::execution::par, indices.begin(), indices.end(), work);
}

unsigned use_threads(unsigned threads) {
    static std::unique_ptr<tbb::global_control> limit;
    const unsigned cores = std::max(1u, std::thread::hardware_concurrency());
    const unsigned allowed = threads ? std::min(threads, cores) : cores; // more of them would never be used
    limit.reset(); // two limits at once would leave the lower one in force
    limit = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism, allowed);
    return allowed;
}

std::vector<Tile> tiles_of(int width, int height, int side) {
    std::vector<Tile> tiles;
    for (int y = 0; y < height; y += side)
        for (int x = 0; x < width; x += side)
            tiles.push_back({x, y, std::min(x + side, width), std::min(y + side, height)});
    return tiles;
}

} // namespace course
