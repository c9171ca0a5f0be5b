// Chromium without a window, told what to do over the DevTools protocol: JSON messages, each ended by a zero byte, on
// its file descriptors 3 (to the browser) and 4 (from it). No driver and no package manager stands in between.
#pragma once
#include <chrono>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace course {

using Json = nlohmann::json;

class Browser {
  public:
    // The path of an installed Chromium or Chrome, if there is one.
    static std::optional<std::string> find();

    // Starts it with a profile of its own, which goes with it. Throws std::runtime_error when it does not answer.
    explicit Browser(const std::string &program);
    ~Browser();
    Browser(const Browser &) = delete;

    // One command of the protocol and its answer. Throws std::runtime_error when the answer is an error.
    Json call(const std::string &method, const Json &parameters = Json::object());

    // Opens a file at a size of the window, and returns when it and its pictures have been loaded.
    void open(const std::filesystem::path &page, int width, int height);
    void resize(int width, int height);
    void prefer(const std::string &feature, const std::string &value); // such as prefers-color-scheme, dark

    // The value of a JavaScript expression; a promise is waited for.
    Json evaluate(const std::string &expression);

    void mouse(const std::string &type, double x, double y); // mousePressed, mouseMoved, mouseReleased
    void touch(const std::string &type, double x, double y); // touchStart, touchMove; touchEnd takes no place
    void key(const std::string &name, int code);             // pressed and let go: "ArrowRight", 39

    // What is seen (of the whole page, or of the window's view), as a PNG.
    void screenshot(const std::filesystem::path &file, bool whole_page);

    // Console messages of level warning and above, exceptions, failed loads; and addresses that are no local file.
    std::vector<std::string> complaints, addresses_elsewhere;

  private:
    void send(const Json &);
    Json receive(std::chrono::seconds patience);
    void notice(const Json &event);

    int process_ = -1, to_ = -1, from_ = -1, last_id_ = 0;
    bool loaded_ = false;
    std::string session_, unread_;
    std::filesystem::path profile_;
};

} // namespace course
