// Chapter 17 alive: the window shows what the program writes into a file, keys change the shader and the view, and the
// screenshot is the picture itself.
//   gpu_window_test CHAPTER-PROGRAM SCRATCH-FOLDER
#include "common/image_difference.hpp"
#include "tests/window/virtual_display.hpp"

#include <filesystem>
#include <gtest/gtest.h>
#include <memory>

using namespace course;
namespace fs = std::filesystem;

namespace {

fs::path chapter, scratch;
constexpr int width = 160, height = 100;

std::vector<std::string> command(const std::vector<std::string> &more) {
    std::vector<std::string> words{chapter.string(),      "--scene",  "mirrors",
                                   "--samples",           "2",        "--width",
                                   std::to_string(width), "--height", std::to_string(height)};
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

bool near(const Picture &a, const Picture &b, double steps) {
    return a.width == b.width && a.height == b.height && difference(a, b).largest_steps <= steps;
}

class LiveWindow : public testing::Test {
  protected:
    void SetUp() override {
        if (!installed("Xvfb") || !installed("xdotool"))
            GTEST_SKIP() << "Xvfb or xdotool is not installed";
        display.emplace(scratch / "display");
        ASSERT_NE(display->name(), "") << text_of(scratch / "display/stderr.txt");
        fs::remove_all(folder);
        const fs::path file = scratch / "offscreen.png";
        ASSERT_EQ(Process(command({"--out", file.string()}), scratch).wait(), 0) << text_of(scratch / "stderr.txt");
        home = read_image(file);
        window = std::make_unique<Process>(
            command({"--window"}), folder,
            std::vector<Process::Setting>{{"DISPLAY", display->name()}, {"WAYLAND_DISPLAY", std::nullopt}});
        ASSERT_TRUE(shows_home()) << text_of(folder / "stderr.txt");
        xdotool({"search", "--name", "17_gpu", "windowfocus"});
    }

    std::string xdotool(std::vector<std::string> words) {
        words.insert(words.begin(), "xdotool");
        Process tool(words, scratch / "xdotool", {{"DISPLAY", display->name()}});
        EXPECT_EQ(tool.wait(), 0) << words[1] << ": " << text_of(scratch / "xdotool/stderr.txt");
        return text_of(scratch / "xdotool/stdout.txt");
    }
    bool title_says(const std::string &text) {
        return comes_true([&] { return title().find(text) != std::string::npos; });
    }
    std::string title() { return xdotool({"search", "--name", "17_gpu", "getwindowname"}); }
    // The screen is rounded to eight bits by another hand than the file: a step of 255 apart at most.
    bool shows_home() {
        return comes_true([&] { return near(display->corner(width, height), home, 1.01); });
    }

    const fs::path folder = scratch / "live";
    std::optional<VirtualDisplay> display;
    Picture home;
    std::unique_ptr<Process> window;
};

TEST_F(LiveWindow, ScreenshotIsWhatIsDrawnOffScreen) {
    ASSERT_TRUE(title_says("2 samples")) << title();
    xdotool({"key", "p"});
    const fs::path file = folder / "out/screenshot_1.png";
    ASSERT_TRUE(comes_true([&] { return text_of(folder / "stdout.txt").find("saved") != std::string::npos; }));
    EXPECT_TRUE(near(read_image(file), home, 0.01));
}

TEST_F(LiveWindow, KeysMoveTheCameraAndBack) {
    xdotool({"key", "w"});
    EXPECT_TRUE(comes_true([&] { return !near(display->corner(width, height), home, 8); }));
    xdotool({"key", "r"});
    EXPECT_TRUE(shows_home());
}

TEST_F(LiveWindow, KeysSwitchTheShader) {
    EXPECT_TRUE(title_says("fragment shader for this scene, walk: stack")) << title();
    xdotool({"key", "f"});
    EXPECT_TRUE(title_says("compute shader")) << title();
    EXPECT_TRUE(shows_home());
    xdotool({"key", "t"});
    EXPECT_TRUE(title_says("walk: skip")) << title();
    xdotool({"key", "g"});
    EXPECT_TRUE(title_says("any scene")) << title();
    EXPECT_TRUE(shows_home());
    for (int i = 0; i < 6; ++i) // 32, 16, 8, 4, 2, 1, 0: no mirror mirrors any more
        xdotool({"key", "b"});
    EXPECT_TRUE(title_says(" 0 bounces")) << title();
    EXPECT_TRUE(comes_true([&] { return !near(display->corner(width, height), home, 8); }));
}

TEST_F(LiveWindow, ResizesAndCloses) {
    xdotool({"search", "--name", "17_gpu", "windowsize", "240", "150"});
    EXPECT_TRUE(title_says("240 x 150")) << title();
    xdotool({"key", "q"});
    EXPECT_EQ(window->wait(), 0);
}

} // namespace

int main(int argc, char **argv) {
    testing::InitGoogleTest(&argc, argv);
    if (argc != 3)
        return 2;
    chapter = fs::absolute(argv[1]);
    scratch = fs::absolute(argv[2]);
    fs::create_directories(scratch);
    const int status = RUN_ALL_TESTS();
    // What could not be tried is no success: ctest shows it as skipped, with the reasons printed above.
    return status == 0 && testing::UnitTest::GetInstance()->skipped_test_count() > 0 ? 77 : status;
}
