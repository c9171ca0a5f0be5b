#include "tests/house/pattern.hpp"

#include <regex>

namespace texts {

struct Pattern::Machine {
    std::regex regex;
};

namespace {

Found found(const std::smatch &match) { return {match.begin(), match.end()}; }

} // namespace

Pattern::Pattern(const std::string &expression) : machine_(new Machine{std::regex(expression)}) {}

Found Pattern::match(const std::string &text) const {
    std::smatch match;
    std::regex_match(text, match, machine_->regex);
    return found(match);
}

Found Pattern::first_in(const std::string &text) const {
    std::smatch match;
    std::regex_search(text, match, machine_->regex);
    return found(match);
}

std::vector<Found> Pattern::all_in(const std::string &text) const {
    std::vector<Found> all;
    for (std::sregex_iterator match(text.begin(), text.end(), machine_->regex), end; match != end; ++match)
        all.push_back(found(*match));
    return all;
}

std::string Pattern::replaced_in(const std::string &text, const std::string &by) const {
    return std::regex_replace(text, machine_->regex, by);
}

} // namespace texts
