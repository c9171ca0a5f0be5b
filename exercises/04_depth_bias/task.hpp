// Exercise 04: what an answer hands over.
#pragma once
#include "common/vectors.hpp"
#include "exercises/grading/not_done.hpp"

namespace course {

// A square picture from the lamp: forward, right and up have length one and are perpendicular. At depth one (along
// forward) the picture reaches half_width to each side; it has so many texels across and as many down.
struct MapView {
    Vec<double> eye, forward, right, up;
    double half_width;
    int texels;
};

struct Task {
    double (*depth_bias)(const MapView &, const Vec<double> &, const Vec<double> &);
};

} // namespace course
