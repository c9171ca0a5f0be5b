#include "common/progress.hpp"

#include <atomic>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <unistd.h>

namespace course {
namespace {

std::atomic<bool> interrupt_seen = false; // by whichever thread the signal comes to
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler must not wait");

void note_interrupt(int) {
    if (interrupt_seen.exchange(true))
        _exit(130);
}

} // namespace

void keep_work_on_interrupt() { std::signal(SIGINT, note_interrupt); }

bool interrupted() { return interrupt_seen; }

std::string spoken_seconds(double seconds) {
    const long whole = std::lround(seconds);
    char text[48];
    if (whole < 60)
        std::snprintf(text, sizeof text, "%ld s", whole);
    else
        std::snprintf(text, sizeof text, "%ld min %02ld s", whole / 60, whole % 60);
    return text;
}

Progress::Progress(std::string label, std::size_t total)
    : label_(std::move(label)), total_(total), shown_(isatty(STDERR_FILENO) != 0),
      start_(std::chrono::steady_clock::now()), last_drawn_(start_) {
    if (shown_)
        draw(0);
}

Progress::~Progress() {
    if (shown_)
        std::fputs("\r\033[K", stderr);
}

void Progress::advance() {
    const std::size_t done = ++done_;
    if (!shown_)
        return;
    const std::unique_lock lock(drawing_, std::try_to_lock);
    const auto now = std::chrono::steady_clock::now();
    if (lock && (now - last_drawn_ > std::chrono::milliseconds(80) || done == total_)) {
        last_drawn_ = now;
        draw(done);
    }
}

void Progress::draw(std::size_t done) {
    constexpr std::size_t cells = 28;
    const double share = total_ ? static_cast<double>(done) / static_cast<double>(total_) : 1.0;
    const double passed = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    std::string bar;
    for (std::size_t i = 0; i < cells; ++i)
        bar += static_cast<double>(i) < share * cells ? "█" : "░";
    const std::string left = done ? spoken_seconds(passed / share - passed) + " left" : "";
    std::fprintf(stderr, "\r\033[K%s %s %3.0f %%  %s", label_.c_str(), bar.c_str(), 100 * share, left.c_str());
    std::fflush(stderr);
}

} // namespace course
