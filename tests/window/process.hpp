// Programs started by a test, which never outlive it.
#pragma once
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <utility>
#include <vector>
#ifdef __linux__
#include <sys/prctl.h>
#endif

namespace course {

// Asks again and again whether the condition holds. The limit is far beyond what anything here needs, so that a busy
// machine fails no test; nothing waits for longer than it must.
template <class Condition> bool comes_true(Condition condition, std::chrono::seconds limit = std::chrono::seconds(90)) {
    const auto end = std::chrono::steady_clock::now() + limit;
    while (!condition()) {
        if (std::chrono::steady_clock::now() > end)
            return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    return true;
}

inline std::string text_of(const std::filesystem::path &file) {
    std::ifstream stream(file);
    return (std::ostringstream() << stream.rdbuf()).str();
}

class Process {
  public:
    using Setting = std::pair<std::string, std::optional<std::string>>; // of the environment; nullopt takes it away

    // Starts the program in `folder`, where its output goes to stdout.txt and stderr.txt.
    Process(const std::vector<std::string> &command, const std::filesystem::path &folder,
            const std::vector<Setting> &environment = {}) {
        std::vector<char *> arguments;
        for (const std::string &word : command)
            arguments.push_back(const_cast<char *>(word.c_str()));
        arguments.push_back(nullptr);
        std::filesystem::create_directories(folder);
        for (const char *file : {"stdout.txt", "stderr.txt"}) // what an earlier program said is not read by mistake
            std::filesystem::remove(folder / file);
        id_ = fork();
        if (id_ != 0)
            return;
#ifdef __linux__
        prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
        for (const auto &[name, value] : environment)
            value ? setenv(name.c_str(), value->c_str(), 1) : unsetenv(name.c_str());
        if (chdir(folder.c_str()) != 0 || !send(STDOUT_FILENO, "stdout.txt") || !send(STDERR_FILENO, "stderr.txt"))
            _exit(126);
        execvp(arguments[0], arguments.data());
        _exit(127);
    }
    ~Process() {
        if (ended())
            return;
        kill(id_, SIGKILL);
        waitpid(id_, nullptr, 0);
    }
    Process(const Process &) = delete;
    Process &operator=(const Process &) = delete;

    bool ended() {
        int status;
        if (!status_ && waitpid(id_, &status, WNOHANG) == id_)
            status_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
        return status_.has_value();
    }

    // The exit status, as a shell tells it; -1 when the program does not end.
    int wait() {
        return comes_true([this] { return ended(); }) ? *status_ : -1;
    }

  private:
    static bool send(int stream, const char *file) {
        return dup2(open(file, O_WRONLY | O_CREAT | O_TRUNC, 0644), stream) == stream;
    }

    pid_t id_;
    std::optional<int> status_;
};

} // namespace course
