// A claim of the lecture notes, and how it is measured. Each claim is one function and one entry in a table.
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
    std::string depends_on = {}; // where it depends: on what, and where it holds and where not
    std::optional<Plot> figure = {};
};

struct ClaimOptions {
    bool quick = false;
    std::uint64_t seed = 1;
};

struct Claim {
    std::string id; // as in the lecture notes' list: C1 ...
    std::string claim;
    std::string chapter; // the folder of the chapter that takes it up
    std::string how;     // what is measured
    std::string rule;    // what the figures must say for the claim to hold
    bool timed;          // with a clock: then one core works, and nothing else
    std::function<Finding(const ClaimOptions &)> measure;
};

// One table for each NAME_claims.cpp.
std::vector<Claim> picture_claims();
std::vector<Claim> kernel_claims();
std::vector<Claim> space_claims();
std::vector<Claim> tree_claims();
std::vector<Claim> gpu_claims(); // where this build has OpenGL

// All of them, in the order of the numbers.
std::vector<Claim> all_claims();

} // namespace course
