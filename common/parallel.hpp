// Work on all cores (std::execution::par over oneTBB, in parallel.cpp alone).
#pragma once
#include "common/image.hpp"

#include <cstddef>
#include <functional>

namespace course {

// Calls work(i) for every i < count, on the threads that use_threads() allows; returns when all are done. Of exceptions
// only std::bad_alloc comes out: any other ends the program (the rule of std::execution).
void parallel_for(std::size_t count, const std::function<void(std::size_t)> &work);

// The number of threads that parallel_for may use from now on; 0, or more than there are cores, means every core.
// Returns the number that holds.
unsigned use_threads(unsigned threads);

// The square tiles (`side` pixels a side, fewer at the rim) that cover a picture, in rows from the top.
std::vector<Tile> tiles_of(int width, int height, int side = 32);

} // namespace course
