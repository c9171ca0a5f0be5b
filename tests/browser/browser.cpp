#include "tests/browser/browser.hpp"

#include <array>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <fstream>
#include <poll.h>
#include <sstream>
#include <stdexcept>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace course {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::seconds patience{60};

std::string from_base64(const std::string &text) {
    const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    unsigned bits = 0;
    int held = 0;
    for (const char c : text) {
        const auto value = letters.find(c);
        if (value == std::string::npos)
            break;
        bits = (bits << 6 | static_cast<unsigned>(value)) & 0xFFFFFF;
        if ((held += 6) >= 8)
            bytes += static_cast<char>(bits >> (held -= 8) & 0xFF);
    }
    return bytes;
}

// In the child process: puts the pipes where Chromium looks for them, and becomes Chromium.
[[noreturn]] void become(const std::string &program, const fs::path &profile, int commands, int answers) {
    dup2(fcntl(commands, F_DUPFD, 10), 3);
    dup2(fcntl(answers, F_DUPFD, 10), 4);
    const int nothing = ::open("/dev/null", O_RDWR);
    dup2(nothing, 1);
    dup2(nothing, 2);
    setenv("HOME", profile.c_str(), 1);
    const std::string data = "--user-data-dir=" + profile.string();
    std::vector<std::string> words{program,
                                   "--headless",
                                   "--no-sandbox",
                                   "--disable-gpu",
                                   "--disable-quic",
                                   "--no-first-run",
                                   "--disable-background-networking",
                                   "--disable-component-update",
                                   "--disable-sync",
                                   "--disable-dev-shm-usage",
                                   "--hide-scrollbars",
                                   "--force-color-profile=srgb",
                                   data,
                                   "--remote-debugging-pipe",
                                   "about:blank"};
    std::vector<char *> arguments;
    for (std::string &word : words)
        arguments.push_back(word.data());
    arguments.push_back(nullptr);
    execv(program.c_str(), arguments.data());
    _exit(127);
}

} // namespace

std::optional<std::string> Browser::find() {
    std::istringstream folders(std::getenv("PATH") ? std::getenv("PATH") : "");
    for (std::string folder; std::getline(folders, folder, ':');)
        for (const char *name : {"chromium", "chromium-browser", "google-chrome"})
            if (const fs::path program = fs::path(folder) / name; access(program.c_str(), X_OK) == 0)
                return program.string();
    return {};
}

Browser::Browser(const std::string &program) {
    std::signal(SIGPIPE, SIG_IGN);
    std::string pattern = (fs::temp_directory_path() / "course_browser_XXXXXX").string();
    if (!mkdtemp(pattern.data()))
        throw std::runtime_error("no temporary folder for the browser's profile");
    profile_ = pattern;
    std::array<int, 2> commands{}, answers{};
    if (pipe2(commands.data(), O_CLOEXEC) != 0 || pipe2(answers.data(), O_CLOEXEC) != 0)
        throw std::runtime_error("no pipes to the browser");
    process_ = fork();
    if (process_ == 0)
        become(program, profile_, commands[0], answers[1]);
    close(commands[0]);
    close(answers[1]);
    to_ = commands[1];
    from_ = answers[0];

    const Json target = call("Target.createTarget", {{"url", "about:blank"}});
    session_ = call("Target.attachToTarget", {{"targetId", target["targetId"]}, {"flatten", true}})["sessionId"];
    for (const char *domain : {"Page.enable", "Runtime.enable", "Log.enable", "Network.enable", "DOM.enable"})
        call(domain);
}

Browser::~Browser() {
    session_.clear();
    try {
        call("Browser.close");
    } catch (const std::exception &) {
    }
    close(to_);
    close(from_);
    for (int tenths = 0; waitpid(process_, nullptr, WNOHANG) == 0; ++tenths) {
        if (tenths == 100)
            kill(process_, SIGKILL);
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    std::error_code error;
    for (int attempt = 0; attempt < 20 && fs::exists(profile_); ++attempt) { // its helpers may still be writing
        fs::remove_all(profile_, error);
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
}

void Browser::send(const Json &message) {
    std::string text = message.dump();
    text += '\0';
    for (std::size_t sent = 0; sent < text.size();) {
        const ssize_t count = write(to_, text.data() + sent, text.size() - sent);
        if (count <= 0)
            throw std::runtime_error("the browser is gone");
        sent += static_cast<std::size_t>(count);
    }
}

Json Browser::receive(std::chrono::seconds wait) {
    for (;;) {
        if (const auto end = unread_.find('\0'); end != std::string::npos) {
            const Json message = Json::parse(unread_.substr(0, end));
            unread_.erase(0, end + 1);
            return message;
        }
        pollfd waiting{from_, POLLIN, 0};
        if (poll(&waiting, 1, static_cast<int>(std::chrono::milliseconds(wait).count())) <= 0)
            throw std::runtime_error("the browser does not answer");
        std::array<char, 65536> buffer;
        const ssize_t count = read(from_, buffer.data(), buffer.size());
        if (count <= 0)
            throw std::runtime_error("the browser is gone");
        unread_.append(buffer.data(), static_cast<std::size_t>(count));
    }
}

void Browser::notice(const Json &event) {
    const std::string method = event.value("method", "");
    const Json &parameters = event.contains("params") ? event["params"] : event;
    if (method == "Page.loadEventFired")
        loaded_ = true;
    else if (method == "Runtime.exceptionThrown")
        complaints.push_back("exception: " + parameters["exceptionDetails"].dump());
    else if (method == "Runtime.consoleAPICalled" && (parameters["type"] == "error" || parameters["type"] == "warning"))
        complaints.push_back("console: " + parameters["args"].dump());
    else if (method == "Log.entryAdded" && parameters["entry"]["level"] != "verbose" &&
             parameters["entry"]["level"] != "info")
        complaints.push_back("log: " + parameters["entry"]["text"].dump());
    else if (method == "Network.loadingFailed")
        complaints.push_back("not loaded: " + parameters["errorText"].dump());
    else if (method == "Network.requestWillBeSent") {
        const std::string address = parameters["request"]["url"];
        if (!address.starts_with("file:") && !address.starts_with("data:"))
            addresses_elsewhere.push_back(address);
    }
}

Json Browser::call(const std::string &method, const Json &parameters) {
    Json command{{"id", ++last_id_}, {"method", method}, {"params", parameters}};
    if (!session_.empty())
        command["sessionId"] = session_;
    send(command);
    for (;;) {
        const Json message = receive(patience);
        if (message.value("id", 0) != last_id_) {
            notice(message);
            continue;
        }
        if (message.contains("error"))
            throw std::runtime_error(method + ": " + message["error"].dump());
        return message["result"];
    }
}

void Browser::resize(int width, int height) {
    call("Emulation.setDeviceMetricsOverride",
         {{"width", width}, {"height", height}, {"deviceScaleFactor", 1}, {"mobile", false}});
}

void Browser::prefer(const std::string &feature, const std::string &value) {
    call("Emulation.setEmulatedMedia", {{"features", {{{"name", feature}, {"value", value}}}}});
}

void Browser::open(const fs::path &page, int width, int height) {
    complaints.clear();
    addresses_elsewhere.clear();
    loaded_ = false;
    resize(width, height);
    call("Page.navigate", {{"url", "file://" + fs::absolute(page).string()}});
    while (!loaded_)
        notice(receive(patience));
    // Pictures further down are loaded when they come near: go there, and wait until each is there or has failed.
    evaluate("(async () => { for (const image of document.images) { image.loading = 'eager';"
             " await image.decode().catch(() => {}); } })()");
}

Json Browser::evaluate(const std::string &expression) {
    const Json answer =
        call("Runtime.evaluate", {{"expression", expression}, {"returnByValue", true}, {"awaitPromise", true}});
    if (answer.contains("exceptionDetails"))
        throw std::runtime_error(expression + ": " + answer["exceptionDetails"].dump());
    return answer["result"].value("value", Json());
}

void Browser::mouse(const std::string &type, double x, double y) {
    const bool down = type != "mouseReleased";
    call("Input.dispatchMouseEvent",
         {{"type", type}, {"x", x}, {"y", y}, {"button", "left"}, {"buttons", down ? 1 : 0}, {"clickCount", 1}});
}

void Browser::touch(const std::string &type, double x, double y) {
    Json points = Json::array();
    if (type != "touchEnd")
        points.push_back({{"x", x}, {"y", y}});
    call("Input.dispatchTouchEvent", {{"type", type}, {"touchPoints", points}});
}

void Browser::key(const std::string &name, int code) {
    for (const char *type : {"rawKeyDown", "keyUp"})
        call("Input.dispatchKeyEvent",
             {{"type", type}, {"key", name}, {"code", name}, {"windowsVirtualKeyCode", code}});
}

void Browser::screenshot(const fs::path &file, bool whole_page) {
    Json parameters{{"format", "png"}, {"captureBeyondViewport", whole_page}};
    if (whole_page) {
        const Json size = call("Page.getLayoutMetrics")["cssContentSize"];
        parameters["clip"] = {{"x", 0}, {"y", 0}, {"width", size["width"]}, {"height", size["height"]}, {"scale", 1}};
    }
    std::ofstream(file, std::ios::binary) << from_base64(call("Page.captureScreenshot", parameters)["data"]);
}

} // namespace course
