#include "tests/claims/cases.hpp"

#include <cstdarg>
#include <cstdio>

namespace course {
namespace {

void append(std::string &words, const std::string &separator, const std::string &more) {
    if (!more.empty())
        words += (words.empty() ? "" : separator) + more;
}

std::string joined(const std::vector<std::string> &names) {
    std::string list;
    for (const std::string &name : names)
        append(list, ", ", name);
    return list;
}

} // namespace

std::string said(const char *format, ...) {
    char text[600];
    va_list values;
    va_start(values, format);
    std::vsnprintf(text, sizeof text, format, values);
    va_end(values);
    return text;
}

void Cases::add(const std::string &name, bool holds, const std::string &found) {
    (holds ? held_ : not_held_).push_back(name);
    append(words_, "; ", found.empty() ? "" : name + ": " + found);
}

std::string Cases::where() const {
    const bool mostly_not = held() <= not_held_.size();
    const auto &fewer = mostly_not ? held_ : not_held_;
    if (fewer.size() > 10)
        return said("it holds in %zu cases of %zu", held(), asked());
    return (mostly_not ? "it holds only for: " : "it does not hold for: ") + joined(fewer);
}

Finding Cases::finding(const Plot &figure, const std::string &also) const {
    Finding finding{words_, Holds::depends, {}, figure};
    append(finding.measured, "; ", also);
    if (not_held_.empty())
        finding.verdict = Holds::yes;
    else if (held_.empty())
        finding.verdict = Holds::no;
    else
        finding.depends_on = on_ + "; " + where();
    return finding;
}

} // namespace course
