// Speeds that can be compared: variants take turns in one process, and each one's median round is reported.
#pragma once
#include <functional>
#include <vector>

namespace course {

// The median seconds of each variant over `rounds` rounds (at least 1); in a round every variant runs once, one after
// the other, so that a slow spell of the machine falls on all alike. One unmeasured round goes before.
std::vector<double> median_seconds(const std::vector<std::function<void()>> &variants, int rounds);

// The same rounds one by one: the seconds of each variant in each round.
std::vector<std::vector<double>> seconds_of_rounds(const std::vector<std::function<void()>> &variants, int rounds);

// The value that this share of the list is not above: 0.5 is the median. The list must not be empty.
double quantile(std::vector<double> list, double share);

// Makes the compiler believe that `value` is looked at, so that the work behind it is not optimised away.
template <class Value> void keep(const Value &value) { asm volatile("" : : "g"(&value) : "memory"); }

} // namespace course
