// What every chapter's main shares: the options, the way from a renderer to a file or a window, the exit status.
#pragma once
#include "common/command_line.hpp"
#include "common/rendering.hpp"

#include <functional>
#include <string>

namespace course {

class Program {
  public:
    // `name` is the chapter's folder, such as "01_ray_casting"; the picture goes to out/chapters/<name>.png.
    Program(const std::string &name, const std::string &summary, int argc, const char *const *argv);

    CommandLine options; // a chapter adds its own switches before parse()
    int width = 960, height = 540;
    std::uint64_t seed = 1;

    void parse();

    // Renders into --out (beside it, NAME.json with time and rays for the gallery) or, with --window, into a window.
    // After Ctrl-C the finished tiles are written and the exit status is 130.
    void render(const Viewpoint &, const Renderer &);

    // What render() does with a picture that is done: for those who make it in another way than pixel by pixel.
    void keep(const RenderedPicture &);

    // The folder of --out joined with NAME_<suffix>: where a chapter's reports and plots go.
    std::string beside_picture(const std::string &suffix) const;

    int exit_status() const { return exit_status_; }
    bool in_window() const { return window_; }

  private:
    std::string name_, summary_, out_;
    int argc_, threads_ = 0, exit_status_ = 0;
    const char *const *argv_;
    bool window_ = false;
};

// Runs a chapter's body. Bad input (InputError) prints one line and returns 2.
int run_program(const std::string &name, const std::string &summary, int argc, const char *const *argv,
                const std::function<void(Program &)> &body);

// The same for programs that render nothing and have no options in common.
int run_guarded(const std::string &name, const std::function<int()> &body);

} // namespace course
