#include "tests/hard_cases/reader.hpp"

#include "common/errors.hpp"
#include "common/output_files.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace course::hard {
namespace {

// Text in single quotes for the shell.
std::string quoted(const std::string &text) {
    std::string safe = "'";
    for (const char c : text)
        safe += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return safe + "'";
}

std::string first_complaint(const std::filesystem::path &log) {
    std::ifstream in(log);
    std::string first;
    for (std::string line; std::getline(in, line);) {
        if (line.find("error") != std::string::npos)
            return line;
        if (first.empty())
            first = line;
    }
    return first;
}

// Ends with the shell's status: 124 after the time is over, 128 and more for a signal.
int run_command(const std::string &command) {
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

} // namespace

Reader::Reader(const std::string &file, int seconds_allowed) : file_(file), seconds_allowed_(seconds_allowed) {
    if (!std::filesystem::is_regular_file(file))
        throw InputError("--kernel " + file, "there is no such file");
    std::string pattern = (std::filesystem::temp_directory_path() / "course-kernel-XXXXXX").string();
    if (!mkdtemp(pattern.data()))
        throw InputError("--kernel " + file, "no folder for temporary files can be made");
    folder_ = pattern;

    const auto log = folder_ / "log", known = folder_ / "known";
    const std::string include = "-DREADER_FILE=" + quoted("\"" + std::filesystem::absolute(file).string() + "\"");
    const std::string program = (folder_ / "kernels").string();
    if (run_command("timeout 120 " COURSE_COMPILER " -std=c++20 -O3 " COURSE_KERNEL_FLAGS " -I" +
                    quoted(COURSE_SOURCE_FOLDER) + " " + include + " " +
                    quoted(COURSE_SOURCE_FOLDER "/tests/hard_cases/reader_program.cpp") + " -o " + quoted(program) +
                    " 2>" + quoted(log.string())) != 0) {
        const std::string why = first_complaint(log);
        std::filesystem::remove_all(folder_);
        throw InputError("--kernel " + file, "does not compile: " + why);
    }
    run_command("timeout 10 " + quoted(program) + " list >" + quoted(known.string()));
    std::ifstream in(known);
    for (std::string line; std::getline(in, line);)
        known_.push_back(line);
    if (known_.empty()) {
        std::filesystem::remove_all(folder_);
        throw InputError("--kernel " + file, "defines no function that is asked for here, such as sphere(...)");
    }
}

Reader::~Reader() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
}

bool Reader::has(const std::string &test, const std::string &scalar) const {
    return std::ranges::find(known_, test + " " + scalar) != known_.end();
}

void Reader::fail(const std::string &test, const std::string &scalar, const std::string &how) {
    const std::string text = test + ", " + scalar + ": " + how;
    const std::lock_guard lock(guard_);
    if (std::ranges::find(failures_, text) == failures_.end())
        failures_.push_back(text);
}

std::vector<std::string> Reader::failures() const {
    const std::lock_guard lock(guard_);
    return failures_;
}

double Reader::run(const std::string &test, const std::string &scalar, const void *rays, std::size_t ray_bytes,
                   const void *shapes, std::size_t shape_bytes, std::span<double> t, int rounds) {
    static std::atomic<unsigned> number{0};
    const std::string name = std::to_string(++number);
    const auto in = folder_ / (name + ".in"), out = folder_ / (name + ".out");
    {
        std::ofstream file(in, std::ios::binary);
        file.write(static_cast<const char *>(rays), static_cast<std::streamsize>(ray_bytes));
        file.write(static_cast<const char *>(shapes), static_cast<std::streamsize>(shape_bytes));
    }
    std::ranges::fill(t, no_hit);
    std::ostringstream command;
    command << "timeout " << seconds_allowed_ << " " << quoted((folder_ / "kernels").string()) << " " << test << " "
            << scalar << " " << t.size() << " " << rounds << " <" << quoted(in.string()) << " >" << quoted(out.string())
            << " 2>/dev/null";
    const int status = run_command(command.str());
    double seconds = 0;
    if (status == 124)
        fail(test, scalar,
             "did not finish " + std::to_string(t.size()) + " tests in " + std::to_string(seconds_allowed_) + " s");
    else if (status != 0)
        fail(test, scalar, status > 128 ? "crashed (signal " + std::to_string(status - 128) + ")" : "ended by itself");
    else {
        std::ifstream file(out, std::ios::binary);
        file.read(reinterpret_cast<char *>(&seconds), sizeof seconds);
        file.read(reinterpret_cast<char *>(t.data()), static_cast<std::streamsize>(t.size_bytes()));
    }
    std::filesystem::remove(in);
    std::filesystem::remove(out);
    return seconds;
}

} // namespace course::hard
