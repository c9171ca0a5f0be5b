// The live picture without a window: coarse first, complete in the end, prompt when the view changes.
#include "common/image_files.hpp"
#include "common/progressive.hpp"

#include <gtest/gtest.h>

using namespace course;
using namespace std::chrono_literals;

namespace {

// Waits until the condition holds; a minute is far beyond what any of them needs.
template <class Condition> bool comes_true(Condition condition) {
    for (const auto end = std::chrono::steady_clock::now() + 60s; std::chrono::steady_clock::now() < end;
         std::this_thread::sleep_for(1ms))
        if (condition())
            return true;
    return false;
}

Viewpoint looking_from(double x) { return {.eye = {x, 0, 5}}; }

// A picture that tells where it was seen from (red), and what its size is.
TileFunction gradient(const Viewpoint &view, int width, int height) {
    return each_pixel([red = static_cast<float>(view.eye.x), width, height](int x, int y) {
        count_ray();
        return Colour(red, static_cast<float>(x) / static_cast<float>(width),
                      static_cast<float>(y) / static_cast<float>(height));
    });
}

TEST(ProgressivePainter, TheLastLevelIsThePictureItself) {
    const Renderer renderer = gradient;
    ProgressivePainter painter(renderer);
    painter.start(looking_from(0.5), 101, 67); // no multiple of any stride
    ASSERT_TRUE(comes_true([&] { return !painter.state().busy; }));
    const auto state = painter.state();
    EXPECT_EQ(state.stride, 1);
    EXPECT_EQ(state.rays, 101u * 67u);

    const Picture expected = render_picture("", 101, 67, gradient(looking_from(0.5), 101, 67)).picture;
    const auto finished = painter.finished();
    ASSERT_TRUE(finished);
    EXPECT_EQ(finished->pixels, expected.pixels);
    Screen screen;
    ASSERT_TRUE(painter.take_screen(screen));
    ASSERT_EQ(screen.width, 101);
    ASSERT_EQ(screen.height, 67);
    for (std::size_t i = 0; i < screen.pixels.size(); ++i)
        for (int channel = 0; channel < 3; ++channel)
            ASSERT_EQ(screen.pixels[i][channel], srgb_byte(expected.pixels[i][channel]));
    EXPECT_FALSE(painter.take_screen(screen)); // nothing new since
}

TEST(ProgressivePainter, TheFirstLevelIsCoarseAndEachNextHalvesTheStride) {
    std::mutex mutex;
    std::vector<int> widths;
    const Renderer renderer = [&](const Viewpoint &view, int width, int height) {
        const std::lock_guard lock(mutex);
        widths.push_back(width);
        return gradient(view, width, height);
    };
    ProgressivePainter painter(renderer);
    painter.start(looking_from(0), 320, 200);
    ASSERT_TRUE(comes_true([&] { return !painter.state().busy; }));
    EXPECT_EQ(widths, (std::vector{10, 20, 40, 80, 160, 320}));
}

TEST(ProgressivePainter, ACoarseLevelShowsSquares) {
    std::atomic<bool> hold{true};
    const Renderer renderer = [&](const Viewpoint &view, int width, int height) {
        while (hold && width > 2) // the second level waits
            std::this_thread::sleep_for(1ms);
        return gradient(view, width, height);
    };
    ProgressivePainter painter(renderer);
    painter.start(looking_from(0), 64, 32);
    Screen screen;
    EXPECT_TRUE(comes_true([&] { return painter.take_screen(screen); }));
    EXPECT_EQ(painter.state().stride, 32);
    EXPECT_TRUE(painter.state().busy);
    EXPECT_FALSE(painter.finished());
    hold = false;
    ASSERT_EQ(screen.width, 64);
    for (int x = 0; x < 64; ++x)
        EXPECT_EQ(screen(x, 31).g, srgb_byte(x < 32 ? 0.0f : 0.5f));
}

// The fine levels of the first view never end; a new view must be painted all the same.
TEST(ProgressivePainter, ANewViewInterruptsTheOldOne) {
    std::atomic<bool> first_view{true};
    std::atomic<int> tiles{0};
    const Renderer renderer = [&](const Viewpoint &view, int width, int height) -> TileFunction {
        return [&, fill = gradient(view, width, height), endless = view.eye.x < 0.5 && width == 640](const Tile &tile,
                                                                                                     Picture &picture) {
            if (endless && ++tiles > 8)
                while (first_view)
                    std::this_thread::sleep_for(1ms);
            fill(tile, picture);
        };
    };
    ProgressivePainter painter(renderer);
    painter.start(looking_from(0.25), 640, 400);
    ASSERT_TRUE(comes_true([&] { return tiles > 8; }));
    painter.start(looking_from(0.75), 640, 400);
    first_view = false; // lets only the tiles at work go on
    ASSERT_TRUE(comes_true([&] { return !painter.state().busy; }));
    EXPECT_LT(tiles, 200) << "of the 1000 tiles of the old view";
    Screen screen;
    ASSERT_TRUE(painter.take_screen(screen));
    for (const ScreenPixel &pixel : screen.pixels)
        ASSERT_EQ(pixel.r, srgb_byte(0.75f));
}

TEST(ProgressivePainter, ANewSizeIsPainted) {
    const Renderer renderer = gradient;
    ProgressivePainter painter(renderer);
    painter.start(looking_from(0), 100, 50);
    painter.start(looking_from(0), 33, 77);
    ASSERT_TRUE(comes_true([&] { return !painter.state().busy; }));
    Screen screen;
    ASSERT_TRUE(painter.take_screen(screen));
    EXPECT_EQ(screen.width, 33);
    EXPECT_EQ(screen.height, 77);
}

TEST(ProgressivePainter, ARendererThatThrowsIsHeard) {
    const Renderer renderer = [](const Viewpoint &, int, int) -> TileFunction { throw std::runtime_error("no scene"); };
    ProgressivePainter painter(renderer);
    painter.start(looking_from(0), 10, 10);
    ASSERT_TRUE(comes_true([&] { return !painter.state().busy; }));
    Screen screen;
    EXPECT_THROW(painter.take_screen(screen), std::runtime_error);
}

TEST(ProgressivePainter, EndsWhileItPaints) {
    const Renderer renderer = [](const Viewpoint &view, int width, int height) -> TileFunction {
        return [fill = gradient(view, width, height)](const Tile &tile, Picture &picture) {
            std::this_thread::sleep_for(2ms);
            fill(tile, picture);
        };
    };
    ProgressivePainter painter(renderer);
    painter.start(looking_from(0), 4096, 4096);
}

} // namespace
