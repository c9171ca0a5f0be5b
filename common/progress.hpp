// A progress bar with the time left, and Ctrl-C that lets a job keep what is done.
#pragma once
#include <atomic>
#include <chrono>
#include <cstddef>
#include <mutex>
#include <string>

namespace course {

// Draws on stderr while it is a terminal, and is silent elsewhere. advance() may be called from any thread.
class Progress {
  public:
    Progress(std::string label, std::size_t total);
    ~Progress(); // clears the bar
    void advance();

  private:
    void draw(std::size_t done);

    std::string label_;
    std::size_t total_;
    std::atomic<std::size_t> done_{0};
    bool shown_;
    std::mutex drawing_;
    std::chrono::steady_clock::time_point start_, last_drawn_;
};

// From now on Ctrl-C only sets a flag, which long loops ask for; a second Ctrl-C ends the program at once.
void keep_work_on_interrupt();
bool interrupted();

// "8 s", "2 min 05 s": how a duration is said to a reader.
std::string spoken_seconds(double seconds);

} // namespace course
