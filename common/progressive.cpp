#include "common/progressive.hpp"

#include "common/image_files.hpp"
#include "common/parallel.hpp"

#include <algorithm>
#include <chrono>

namespace course {
namespace {

constexpr int coarsest_stride = 32;
constexpr int tile_side = 16;  // smaller than a file's tiles: a coarse level is small, and a restart waits for a tile
constexpr double blink = 0.04; // seconds

int divided_up(int pixels, int stride) { return (pixels + stride - 1) / stride; }

} // namespace

ProgressivePainter::ProgressivePainter(const Renderer &renderer)
    : renderer_(renderer), thread_([this](std::stop_token stop) { run(std::move(stop)); }) {}

void ProgressivePainter::start(const Viewpoint &viewpoint, int width, int height) {
    const std::lock_guard lock(mutex_);
    view_ = {viewpoint, width, height};
    ++version_;
    state_.busy = true;
    finished_ = {};
    wanted_.notify_one();
}

ProgressivePainter::State ProgressivePainter::state() const {
    const std::lock_guard lock(mutex_);
    return state_;
}

bool ProgressivePainter::take_screen(Screen &screen) {
    const std::lock_guard lock(mutex_);
    if (failure_)
        std::rethrow_exception(failure_);
    if (!changed_)
        return false;
    screen = screen_;
    changed_ = false;
    return true;
}

std::optional<Picture> ProgressivePainter::finished() const {
    const std::lock_guard lock(mutex_);
    return finished_.pixels.empty() ? std::nullopt : std::optional(finished_);
}

void ProgressivePainter::run(std::stop_token stop) {
    std::uint64_t painted = 0;
    while (true) {
        View view;
        {
            std::unique_lock lock(mutex_);
            if (!wanted_.wait(lock, stop, [&] { return version_ != painted; }))
                return;
            view = view_;
            painted = version_;
        }
        try {
            refine(view, painted, stop);
        } catch (...) {
            const std::lock_guard lock(mutex_);
            failure_ = std::current_exception();
            state_.busy = false;
        }
    }
}

void ProgressivePainter::refine(const View &view, std::uint64_t version, const std::stop_token &stop) {
    bool first = true;
    for (int stride = first_stride(view); stride >= 1; stride /= 2, first = false)
        if (!paint_level(view, stride, first, version, stop))
            return;
}

int ProgressivePainter::first_stride(const View &view) const {
    if (seconds_per_pixel_ == 0)
        return coarsest_stride;
    const double all = seconds_per_pixel_ * view.width * view.height;
    int stride = 1;
    while (stride < coarsest_stride && all / (stride * stride) > blink)
        stride *= 2;
    return stride;
}

// Returns false when it was given up.
bool ProgressivePainter::paint_level(const View &view, int stride, bool first, std::uint64_t version,
                                     const std::stop_token &stop) {
    const int width = divided_up(view.width, stride), height = divided_up(view.height, stride);
    const auto start = std::chrono::steady_clock::now();
    const TileFunction fill = renderer_(view.viewpoint, width, height);
    Picture picture(width, height);
    const auto tiles = tiles_of(width, height, tile_side);
    std::atomic<std::uint64_t> rays{0};
    const auto given_up = [&] { return stop.stop_requested() || (!first && version_ != version); };
    parallel_for(tiles.size(), [&](std::size_t i) {
        if (given_up())
            return;
        const std::uint64_t before = rays_of_this_thread;
        fill(tiles[i], picture);
        rays += rays_of_this_thread - before;
        if (!first)
            show(view, picture, tiles[i], stride);
    });
    if (given_up())
        return false;
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    seconds_per_pixel_ = seconds / (static_cast<double>(width) * height);

    // The first level of a view replaces the view before it in one go: no mixture of the two is ever seen.
    if (first)
        show(view, picture, {0, 0, width, height}, stride);
    const std::lock_guard lock(mutex_);
    const bool last = stride == 1, current = version_ == version;
    state_ = {view.width, view.height, stride, seconds, rays, !(last && current)};
    if (last && current)
        finished_ = std::move(picture);
    return true;
}

// Puts a tile of a level on the screen, each pixel as a square of stride x stride.
void ProgressivePainter::show(const View &view, const Picture &level, const Tile &tile, int stride) {
    Screen encoded(tile.x1 - tile.x0, tile.y1 - tile.y0);
    for (int y = tile.y0; y < tile.y1; ++y)
        for (int x = tile.x0; x < tile.x1; ++x) {
            const Colour &colour = level(x, y);
            encoded(x - tile.x0, y - tile.y0) = {srgb_byte(colour.r), srgb_byte(colour.g), srgb_byte(colour.b), 255};
        }
    const std::lock_guard lock(mutex_);
    if (screen_.width != view.width || screen_.height != view.height)
        screen_ = Screen(view.width, view.height);
    const int x1 = std::min(tile.x1 * stride, screen_.width), y1 = std::min(tile.y1 * stride, screen_.height);
    for (int y = tile.y0 * stride; y < y1; ++y)
        for (int x = tile.x0 * stride; x < x1; ++x)
            screen_(x, y) = encoded(x / stride - tile.x0, y / stride - tile.y0);
    changed_ = true;
}

} // namespace course
