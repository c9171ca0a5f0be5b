// A claim of the lecture notes, and how it is measured. Each claim is one function and one line in a table.
#pragma once
#include "common/plot.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace course {

enum class Holds { yes, no, depends };

// What came out: in words with figures, and a plot that shows it.
struct Finding {
    std::string measured;
    Holds verdict;
    std::optional<Plot> figure = {};
};

struct ClaimOptions {
    bool quick = false;
    std::uint64_t seed = 1;
};

struct Claim {
    std::string id; // as in LECTURE_NOTES.md: C1 ...
    std::string claim;
    std::function<Finding(const ClaimOptions &)> measure;
};

// One table for each NAME_claims.cpp.
std::vector<Claim> structure_claims();

} // namespace course
