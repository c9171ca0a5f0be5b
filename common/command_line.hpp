// Command lines (CLI11, in command_line.cpp alone).
#pragma once
#include "common/errors.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace course {

// Thrown by parse() after --help was printed: the program ends with status 0.
struct HelpShown {};

// A number option's smallest and largest legal value.
struct Range {
    double lowest, highest;
};

// Options are bound to variables, which keep their value when the option is not given.
class CommandLine {
  public:
    CommandLine(const std::string &program, const std::string &summary);
    ~CommandLine();

    void option(const std::string &name, int &value, Range, const std::string &help);
    void option(const std::string &name, std::uint64_t &value, const std::string &help);
    void option(const std::string &name, double &value, Range, const std::string &help);
    void option(const std::string &name, std::string &value, const std::string &help);
    void option(const std::string &name, std::vector<std::string> &values, const std::string &help); // may repeat
    // A text out of a list, which --help shows.
    void choice(const std::string &name, std::string &value, const std::vector<std::string> &choices,
                const std::string &help);
    void flag(const std::string &name, bool &value, const std::string &help);

    // Throws InputError naming the option, or HelpShown.
    void parse(int argc, const char *const *argv);

  private:
    struct Parser;
    std::unique_ptr<Parser> parser_;
};

} // namespace course
