// The program of chapter 01 in a window: what is shown is what the file holds, keys and mouse move the camera, and
// where no window can be had it says so in one line.
//   window_test CHAPTER-PROGRAM SCRATCH-FOLDER
#include "tests/window/virtual_display.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <iostream>
#include <memory>

using namespace course;
namespace fs = std::filesystem;

namespace {

fs::path chapter, scratch;

std::vector<std::string> command(int width, int height, const std::vector<std::string> &more) {
    std::vector<std::string> words{chapter.string(), "--width", std::to_string(width), "--height",
                                   std::to_string(height)};
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

// What the program writes into a file at this size.
Picture offscreen(int width, int height) {
    const fs::path file = scratch / "offscreen.png";
    EXPECT_EQ(Process(command(width, height, {"--out", file.string()}), scratch).wait(), 0);
    return read_image(file);
}

// Byte for byte: two bytes that differ are 3e-4 apart in linear light, or more.
bool same(const Picture &a, const Picture &b) {
    return a.width == b.width && std::ranges::equal(a.pixels, b.pixels, [](const Colour &p, const Colour &q) {
               return glm::all(glm::lessThan(abs(p - q), Colour(1e-5f)));
           });
}

// Each test has a display and a folder of its own.
class OnDisplay : public testing::Test {
  protected:
    static constexpr int width = 320, height = 200;

    void SetUp() override {
        if (!installed("Xvfb"))
            GTEST_SKIP() << "Xvfb is not installed";
        display.emplace(scratch / "display");
        ASSERT_NE(display->name(), "") << text_of(scratch / "display/stderr.txt");
    }

    std::unique_ptr<Process> open_window(int across = width, int down = height) {
        return std::make_unique<Process>(
            command(across, down, {"--window"}), folder,
            std::vector<Process::Setting>{{"DISPLAY", display->name()}, {"WAYLAND_DISPLAY", std::nullopt}});
    }

    bool shows(const Picture &expected) const {
        return comes_true([&] { return same(display->corner(expected.width, expected.height), expected); });
    }

    const fs::path folder = scratch / "viewer";
    std::optional<VirtualDisplay> display;
};

class WindowPicture : public OnDisplay {};

class WindowInput : public OnDisplay {
  protected:
    void SetUp() override {
        if (!installed("xdotool"))
            GTEST_SKIP() << "xdotool is not installed";
        OnDisplay::SetUp();
        if (!display)
            return;
        fs::remove_all(folder);
        window = open_window();
        ASSERT_TRUE(shows(home)) << text_of(folder / "stderr.txt");
        xdotool({"search", "--name", "Ray casting", "windowfocus"}); // no window manager does it
    }

    // Returns what xdotool prints.
    std::string xdotool(std::vector<std::string> words) {
        words.insert(words.begin(), "xdotool");
        Process tool(words, scratch / "xdotool", {{"DISPLAY", display->name()}});
        EXPECT_EQ(tool.wait(), 0) << words[1] << ": " << text_of(scratch / "xdotool/stderr.txt");
        return text_of(scratch / "xdotool/stdout.txt");
    }

    std::string title() { return xdotool({"search", "--name", "Ray casting", "getwindowname"}); }

    // Saves a screenshot and returns it once the window shows the very same.
    Picture settled(int number) {
        xdotool({"key", "p"});
        const fs::path file = folder / ("out/screenshot_" + std::to_string(number) + ".png");
        EXPECT_TRUE(comes_true([&] { return fs::exists(file); })) << file;
        const Picture picture = read_image(file);
        EXPECT_TRUE(shows(picture)) << "the window shows something else than " << file;
        return picture;
    }

    // The view is no longer the one from home; R brings it back.
    void expect_moved_and_reset() {
        EXPECT_TRUE(comes_true([&] { return !same(display->corner(width, height), home); }));
        EXPECT_FALSE(same(settled(1), home));
        xdotool({"key", "r"});
        EXPECT_TRUE(shows(home));
    }

    const Picture &home = view_from_home();
    std::unique_ptr<Process> window;

  private:
    static const Picture &view_from_home() {
        static const Picture picture = offscreen(width, height); // the same for all tests
        return picture;
    }
};

void expect_refusal(int status, const fs::path &folder) {
    EXPECT_EQ(status, 2);
    const std::string said = text_of(folder / "stderr.txt");
    EXPECT_TRUE(said.starts_with("01_ray_casting: --window: ")) << said;
    EXPECT_EQ(std::ranges::count(said, '\n'), 1) << said;
    EXPECT_EQ(text_of(folder / "stdout.txt"), "");
}

TEST(WindowRefusal, WithoutADisplay) {
    Process program(command(64, 64, {"--window"}), scratch,
                    {{"DISPLAY", std::nullopt}, {"WAYLAND_DISPLAY", std::nullopt}});
    expect_refusal(program.wait(), scratch);
}

TEST(WindowRefusal, WithADisplayThatIsNotThere) {
    Process program(command(64, 64, {"--window"}), scratch, {{"DISPLAY", ":64999"}, {"WAYLAND_DISPLAY", std::nullopt}});
    expect_refusal(program.wait(), scratch);
}

TEST(WindowRefusal, WithoutOpenGL) {
    if (!installed("Xvfb"))
        GTEST_SKIP() << "Xvfb is not installed";
    const VirtualDisplay display(scratch / "display", {"-extension", "GLX"});
    ASSERT_NE(display.name(), "");
    Process program(command(64, 64, {"--window"}), scratch,
                    {{"DISPLAY", display.name()}, {"WAYLAND_DISPLAY", std::nullopt}});
    expect_refusal(program.wait(), scratch);
}

TEST_F(WindowPicture, IsWhatTheFileHolds) {
    const auto window = open_window();
    EXPECT_TRUE(shows(offscreen(width, height))) << text_of(folder / "stderr.txt");
    EXPECT_FALSE(window->ended());
}

TEST_F(WindowPicture, AWindowFitsOnTheScreen) {
    const auto window = open_window(2000, 1000);
    EXPECT_TRUE(shows(offscreen(800, 400))) << text_of(folder / "stderr.txt");
}

TEST_F(WindowInput, AKeyFlies) {
    xdotool({"key", "w"});
    expect_moved_and_reset();
}

TEST_F(WindowInput, ADragOrbits) {
    xdotool({"mousemove", "100", "100", "mousedown", "1", "mousemove", "150", "80", "mouseup", "1"});
    expect_moved_and_reset();
}

TEST_F(WindowInput, ARightDragLooksAround) {
    xdotool({"mousemove", "100", "100", "mousedown", "3", "mousemove", "150", "80", "mouseup", "3"});
    expect_moved_and_reset();
}

TEST_F(WindowInput, TheWheelZooms) {
    xdotool({"mousemove", "100", "100", "click", "4"});
    expect_moved_and_reset();
}

TEST_F(WindowInput, AMouseThatOnlyMovesChangesNothing) {
    xdotool({"mousemove", "100", "100", "mousemove", "150", "80"});
    EXPECT_TRUE(same(settled(1), home));
}

TEST_F(WindowInput, AScreenshotIsTheFileAndNeverOverwritesOne) {
    EXPECT_TRUE(same(settled(1), home));
    EXPECT_TRUE(same(settled(2), home));
    EXPECT_TRUE(text_of(folder / "stdout.txt").ends_with("saved out/screenshot_1.png\nsaved out/screenshot_2.png\n"));
}

TEST_F(WindowInput, AResizedWindowIsPaintedAnew) {
    xdotool({"search", "--name", "Ray casting", "windowsize", "500", "140"});
    EXPECT_TRUE(shows(offscreen(500, 140)));
}

TEST_F(WindowInput, TheTitleTellsTheState) {
    EXPECT_TRUE(comes_true([&] { return title().find(" | 320 x 200 | ") != std::string::npos; })) << title();
    for (const char *part : {"Ray casting: one ray per pixel", " s, ", "million rays a second", "Q closes"})
        EXPECT_NE(title().find(part), std::string::npos) << part << " in " << title();
}

TEST_F(WindowInput, QCloses) {
    xdotool({"key", "q"});
    EXPECT_EQ(window->wait(), 0) << text_of(folder / "stderr.txt");
}

TEST_F(WindowInput, EscapeCloses) {
    xdotool({"key", "Escape"});
    EXPECT_EQ(window->wait(), 0) << text_of(folder / "stderr.txt");
}

} // namespace

int main(int argc, char **argv) {
    testing::InitGoogleTest(&argc, argv);
    if (argc != 3) {
        std::cerr << "window_test: wants the chapter's program and a folder for scratch files\n";
        return 2;
    }
    chapter = fs::absolute(argv[1]);
    scratch = fs::absolute(argv[2]);
    fs::create_directories(scratch);
    const int status = RUN_ALL_TESTS();
    const auto &result = *testing::UnitTest::GetInstance();
    // What could not be tried is no success: ctest shows it as skipped, with the reasons printed above.
    return status == 0 && result.skipped_test_count() > 0 ? 77 : status;
}
