// Lesson 09, step 4: what a ray costs, in numbers that no clock blurs.
#pragma once
#include "chapters/01_ray_casting/ray.hpp"

#include <cstdint>

namespace course {

struct Counts {
    std::uint64_t nodes = 0; // boxes, cells or nodes of a structure that were looked at
    std::uint64_t tests = 0; // primitives that were tested

    void node() { ++nodes; }
    void test() { ++tests; }
};

// A ray that adds to a tally of its owner wherever it goes. Every search takes it like the plain ray, whose counters
// are empty functions and leave no trace in the machine code.
template <class R> struct Counted : R {
    Counts *tally;

    Counts &counts() const { return *tally; }
};

template <class T = double> using CountedRay = Counted<Ray<T>>;

} // namespace course
