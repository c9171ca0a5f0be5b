// Where the viewer stands, as plain data: what a window moves and what chapter 01 turns into rays.
#pragma once
#include "common/vectors.hpp"

namespace course {

struct Viewpoint {
    Vec<double> eye{0, 0, 5};
    Vec<double> target{0, 0, 0};
    Vec<double> up{0, 1, 0};
    double field_of_view = 45; // vertical, in degrees, below 180

    bool operator==(const Viewpoint &) const = default;
};

} // namespace course
