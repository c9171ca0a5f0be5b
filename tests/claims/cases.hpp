// From figures to a verdict, the same way for every claim.
#pragma once
#include "tests/claims/claim.hpp"

#include <string>
#include <utility>
#include <vector>

namespace course {

// printf into a string of at most 600 characters.
[[gnu::format(printf, 1, 2)]] std::string said(const char *format, ...);

// A claim is asked in several cases, such as scenes. If it holds in all of them it holds, if in none it fails;
// otherwise it depends, and the cases in which it holds or does not (whichever are fewer, if they are not too many) say
// on what.
class Cases {
  public:
    // `on`: in what the cases differ, such as "the scene".
    explicit Cases(std::string on) : on_(std::move(on)) {}

    // `found`: the figures in words, or nothing.
    void add(const std::string &name, bool holds, const std::string &found = "");

    // `also` is added to the words of the cases.
    Finding finding(const Plot &figure, const std::string &also = "") const;

    std::size_t held() const { return held_.size(); }
    std::size_t asked() const { return held_.size() + not_held_.size(); }

  private:
    std::string where() const;

    std::string on_, words_;
    std::vector<std::string> held_, not_held_;
};

} // namespace course
