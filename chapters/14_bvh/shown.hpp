// The exhibit as programs show it, in any structure taught so far: compiled once (shown.cpp) for this chapter's
// program, for its test, and for the chapters that follow.
#pragma once
#include "chapters/08_mesh/studio.hpp"
#include "common/rendering.hpp"

#include <cstdint>
#include <functional>
#include <string>

namespace course {

struct Shown {
    Renderer lit;                                  // in the studio's light
    std::function<Renderer(double legend_at)> map; // the steps behind each pixel
};

// Calls f(shown) with the exhibit in the structure of that name, one of structures_of_14; it lives until f returns.
void with_shown(const std::string &structure, const Studio &studio, std::uint64_t seed,
                const std::function<void(const Shown &)> &f);

} // namespace course
