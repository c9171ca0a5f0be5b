#include "common/rendering.hpp"

#include "common/parallel.hpp"
#include "common/progress.hpp"

#include <atomic>
#include <chrono>

namespace course {

RenderedPicture render_picture(const std::string &label, int width, int height, const TileFunction &fill) {
    Picture picture(width, height);
    const auto tiles = tiles_of(width, height);
    std::atomic<std::uint64_t> rays{0}, finished{0};
    Progress progress(label, tiles.size());
    const auto start = std::chrono::steady_clock::now();
    parallel_for(tiles.size(), [&](std::size_t i) {
        if (interrupted())
            return;
        const std::uint64_t before = rays_of_this_thread;
        fill(tiles[i], picture);
        rays += rays_of_this_thread - before;
        ++finished;
        progress.advance();
    });
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return {std::move(picture), seconds, rays, static_cast<double>(finished) / static_cast<double>(tiles.size())};
}

} // namespace course
