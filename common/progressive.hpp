// A picture that appears coarse at once and is refined while nobody moves: what a live window shows of a renderer.
#pragma once
#include "common/rendering.hpp"

#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>

namespace course {

using ScreenPixel = glm::vec<4, std::uint8_t, glm::defaultp>; // sRGB-encoded, and 255
using Screen = Image<ScreenPixel>;

// Renders on a thread of its own, with parallel_for, one level after the other: a pixel of a level with stride 8 covers
// 8 x 8 pixels of the screen. The first level is the finest that should take no longer than a blink, judged by how fast
// the levels before it were; each next one halves the stride, down to 1, the picture itself.
class ProgressivePainter {
  public:
    explicit ProgressivePainter(const Renderer &renderer);

    // Paints this view from now on. What is under way is given up after the tiles at work, but for the first level of
    // a view: it is always finished and shown, so that a viewer who never stops moving sees pictures all the same.
    void start(const Viewpoint &, int width, int height);

    struct State {
        int width = 0, height = 0;
        int stride = 0;         // of the finest level that is finished; 0 before the first
        double seconds = 0;     // that this level took
        std::uint64_t rays = 0; // of this level
        bool busy = false;      // finer levels will come
    };
    State state() const;

    // Copies the screen as it is now, unless it is unchanged since the last call (then false). An exception of the
    // renderer, though not of the tiles that it renders, comes out here.
    bool take_screen(Screen &);

    // The picture in full resolution, in linear RGB, once it is finished.
    std::optional<Picture> finished() const;

  private:
    struct View {
        Viewpoint viewpoint;
        int width, height;
    };

    void run(std::stop_token);
    void refine(const View &, std::uint64_t version, const std::stop_token &);
    bool paint_level(const View &, int stride, bool first, std::uint64_t version, const std::stop_token &);
    void show(const View &, const Picture &level, const Tile &, int stride);
    int first_stride(const View &) const;

    const Renderer &renderer_;
    double seconds_per_pixel_ = 0; // of the last finished level; 0 while unknown. The painting thread's own.

    mutable std::mutex mutex_; // guards all that follows
    std::condition_variable_any wanted_;
    View view_{};
    std::atomic<std::uint64_t> version_{0}; // counts start(); read without the lock to notice a restart
    State state_;
    Screen screen_;
    Picture finished_;
    bool changed_ = false;
    std::exception_ptr failure_;

    std::jthread thread_; // last, so that it ends before the rest goes
};

} // namespace course
