// What exact answers cost: the default kernels' time over that of the textbook's forms in float, on the same rays.
#pragma once
#include "common/report.hpp"

#include <cstdint>

namespace course::hard {

// A row for each primitive, kernel and place: in a loop over random rays and shapes, and in chapter 14's tree.
std::vector<Row> frontier_rows(std::uint64_t seed);

// The same, one line per primitive.
std::vector<Row> frontier_table(const std::vector<Row> &rows);

} // namespace course::hard
