// Exercise 05: what an answer hands over.
#pragma once
#include "common/vectors.hpp"
#include "exercises/grading/not_done.hpp"

namespace course {

// Texture coordinates: u runs to the right and v upwards, from 0 to 1.
struct MapPlace {
    double u, v;
};

struct Task {
    MapPlace (*on_globe)(const Vec<double> &);
};

} // namespace course
