// What the program `accuracy` shows of its rows: a table per family, and a plot of speed against error per primitive.
#pragma once
#include "common/plot.hpp"
#include "common/report.hpp"

namespace course::hard {

// One line per kernel of one test and family: its cells added up, the worst of them named.
std::vector<Row> summary_of_family(const std::vector<Row> &rows, const std::string &family);

// Every kernel of the test as a point, time per test across, misclassified cases up; the frontier is the line through
// the kernels that no other beats in both. No points, where the rows hold none of the test.
Plot plot_of_test(const std::vector<Row> &rows, const std::string &test);

// The values of the rows under one name, each once, in the order of first appearance.
std::vector<std::string> distinct(const std::vector<Row> &rows, const std::string &name);

} // namespace course::hard
