// Regular expressions for the tests of texts and pages. std::regex costs every source that uses it three seconds of
// compiling; here it is compiled once.
#pragma once
#include <memory>
#include <string>
#include <vector>

namespace texts {

// What an expression found: the whole, and then each group, empty where it took no part.
using Found = std::vector<std::string>;

class Pattern {
  public:
    explicit Pattern(const std::string &expression); // as ECMAScript writes them

    bool matches(const std::string &text) const { return !match(text).empty(); } // all of it
    bool occurs_in(const std::string &text) const { return !first_in(text).empty(); }

    Found match(const std::string &text) const;    // of the text as a whole; empty if it does not match
    Found first_in(const std::string &text) const; // empty if there is none
    std::vector<Found> all_in(const std::string &text) const;
    std::string replaced_in(const std::string &text, const std::string &by) const;

  private:
    struct Machine;
    std::shared_ptr<const Machine> machine_;
};

} // namespace texts
