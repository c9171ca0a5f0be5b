#include "common/program.hpp"

#include "common/image_files.hpp"
#include "common/output_files.hpp"
#include "common/parallel.hpp"
#include "common/progress.hpp"
#include "common/report.hpp"
#include "common/window.hpp"

#include <cstdio>
#include <exception>
#include <filesystem>
#include <new>

namespace course {
namespace {

constexpr double largest_side = 16384;

std::string render_record(const std::string &name, const std::string &summary, const RenderedPicture &done,
                          unsigned threads) {
    return json_line(Row()
                         .set("chapter", name)
                         .set("summary", summary)
                         .set("width", done.picture.width)
                         .set("height", done.picture.height)
                         .set("seconds", done.seconds)
                         .set("rays", done.rays)
                         .set("threads", static_cast<int>(threads))
                         .set("machine", machine_in_words())) +
           "\n";
}

} // namespace

Program::Program(const std::string &name, const std::string &summary, int argc, const char *const *argv)
    : options(name, summary), name_(name), summary_(summary), out_("out/chapters/" + name + ".png"), argc_(argc),
      argv_(argv) {}

void Program::parse() {
    options.option("--out", out_, "The picture to write: .png or .jpg (sRGB), .exr or .hdr (linear)");
    options.option("--width", width, {1, largest_side}, "Width of the picture in pixels");
    options.option("--height", height, {1, largest_side}, "Height of the picture in pixels");
    options.option("--threads", threads_, {0, 1024}, "Threads to render with; 0 means every core");
    options.option("--seed", seed, "Seed of every random choice");
    options.flag("--window", window_, "Show the picture in a window as it is made");
    options.parse(argc_, argv_);
    if (!window_)
        require_writable_image(out_); // before any work is done that could not be kept
    threads_ = static_cast<int>(use_threads(static_cast<unsigned>(threads_)));
}

std::string Program::beside_picture(const std::string &suffix) const {
    const std::filesystem::path out(out_);
    return (out.parent_path() / (out.stem().string() + "_" + suffix)).string();
}

void Program::render(const Viewpoint &viewpoint, const Renderer &renderer) {
    if (window_) {
        show_in_window(summary_, viewpoint, width, height, renderer);
        return;
    }
    keep_work_on_interrupt();
    keep(render_picture(name_, width, height, renderer(viewpoint, width, height)));
}

void Program::keep(const RenderedPicture &done) {
    write_image(out_, done.picture);
    const std::filesystem::path record = std::filesystem::path(out_).replace_extension(".json");
    if (done.finished < 1) {
        std::filesystem::remove(record); // of an earlier picture, which this one replaced
        std::fprintf(stderr, "%s: interrupted; kept the finished %.0f %% in %s\n", name_.c_str(), 100 * done.finished,
                     out_.c_str());
        exit_status_ = 130;
        return;
    }
    write_text(record, render_record(name_, summary_, done, static_cast<unsigned>(threads_)));
    std::printf("%s: %d x %d in %.2f s, %.2f million rays a second, %s\n", name_.c_str(), width, height, done.seconds,
                static_cast<double>(done.rays) / done.seconds / 1e6, out_.c_str());
}

int run_guarded(const std::string &name, const std::function<int()> &body) {
    try {
        return body();
    } catch (const HelpShown &) {
        return 0;
    } catch (const InputError &error) {
        std::fprintf(stderr, "%s: %s\n", name.c_str(), error.what());
    } catch (const std::bad_alloc &) {
        std::fprintf(stderr, "%s: not enough memory\n", name.c_str());
    } catch (const std::exception &error) { // of a library: a folder that vanishes, a name that nobody can read
        std::fprintf(stderr, "%s: %s\n", name.c_str(), error.what());
    }
    return 2;
}

int run_program(const std::string &name, const std::string &summary, int argc, const char *const *argv,
                const std::function<void(Program &)> &body) {
    return run_guarded(name, [&] {
        Program program(name, summary, argc, argv);
        body(program);
        return program.exit_status();
    });
}

} // namespace course
