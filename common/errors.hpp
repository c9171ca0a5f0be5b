// What a program throws when its input is at fault: the one line that the reader of the terminal sees.
#pragma once
#include <stdexcept>
#include <string>

namespace course {

// Names the file or option and what is wrong with it. run_program() prints it and exits with status 2.
struct InputError : std::runtime_error {
    explicit InputError(const std::string &message) : std::runtime_error(message) {}
    InputError(const std::string &what, const std::string &why) : std::runtime_error(what + ": " + why) {}
};

} // namespace course
