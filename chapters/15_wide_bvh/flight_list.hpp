// Lesson 15, step 7b: the flights that have the same kind of step before them.
#pragma once
#include <array>
#include <cstddef>
#include <utility>

namespace course {

// At most `Most` flights; each is in one list at most.
template <class Flight, std::size_t Most> class FlightList {
  public:
    // Without a branch: what is not wanted is written as well, and then written over.
    void add(Flight &flight, bool wanted = true) {
        flights_[size_] = &flight;
        size_ += wanted;
    }
    // Empties the list and visits each that was in it; the visit may put that one back.
    template <class Visit> void for_each_anew(const Visit &visit) {
        const std::size_t size = std::exchange(size_, 0);
        for (std::size_t i = 0; i < size; ++i)
            visit(*flights_[i]);
    }
    std::size_t size() const { return size_; }

  private:
    std::size_t size_ = 0;
    std::array<Flight *, Most + 1> flights_;
};

} // namespace course
