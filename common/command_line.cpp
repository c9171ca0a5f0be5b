#include "common/command_line.hpp"

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>

namespace course {

struct CommandLine::Parser {
    CLI::App app;
};

CommandLine::CommandLine(const std::string &program, const std::string &summary) : parser_(std::make_unique<Parser>()) {
    parser_->app.name(program);
    parser_->app.description(summary);
    parser_->app.set_help_flag("-h,--help", "Show this text");
}

CommandLine::~CommandLine() = default;

namespace {

// CLI11's own Range accepts NaN; this one does not.
CLI::Validator inside(Range range) {
    return CLI::Validator(
        [range](std::string &text) -> std::string {
            double value = 0;
            if (!CLI::detail::lexical_cast(text, value))
                return text + " is not a number";
            if (!(value >= range.lowest && value <= range.highest)) {
                char bounds[96];
                std::snprintf(bounds, sizeof bounds, " is not from %.15g to %.15g", range.lowest, range.highest);
                return text + bounds;
            }
            return {};
        },
        "");
}

} // namespace

void CommandLine::option(const std::string &name, int &value, Range range, const std::string &help) {
    parser_->app.add_option(name, value, help)->check(inside(range))->capture_default_str();
}

void CommandLine::option(const std::string &name, std::uint64_t &value, const std::string &help) {
    parser_->app.add_option(name, value, help)->check(inside({0, 18446744073709551615.0}))->capture_default_str();
}

void CommandLine::option(const std::string &name, double &value, Range range, const std::string &help) {
    parser_->app.add_option(name, value, help)->check(inside(range))->capture_default_str();
}

void CommandLine::option(const std::string &name, std::string &value, const std::string &help) {
    parser_->app.add_option(name, value, help)->capture_default_str();
}

void CommandLine::option(const std::string &name, std::vector<std::string> &values, const std::string &help) {
    parser_->app.add_option(name, values, help)->allow_extra_args(false);
}

void CommandLine::choice(const std::string &name, std::string &value, const std::vector<std::string> &choices,
                         const std::string &help) {
    parser_->app.add_option(name, value, help)->check(CLI::IsMember(choices))->capture_default_str();
}

void CommandLine::flag(const std::string &name, bool &value, const std::string &help) {
    parser_->app.add_flag(name, value, help);
}

void CommandLine::parse(int argc, const char *const *argv) {
    try {
        parser_->app.parse(argc, argv);
    } catch (const CLI::CallForHelp &) {
        std::fputs(parser_->app.help().c_str(), stdout);
        throw HelpShown{};
    } catch (const CLI::ParseError &error) {
        throw InputError(error.what());
    }
}

} // namespace course
