#include "chapters/13_bsp_tree/bsp.hpp"
#include "tests/structures/structure_test.hpp"

namespace course {
template <class Shape> struct AutoPartition : Bsp<Shape> {
    explicit AutoPartition(std::span<const Shape> given) : Bsp<Shape>(given, {.planes = Planes::supporting}) {}
};
} // namespace course

COURSE_STRUCTURE_TEST(Bsp)
COURSE_STRUCTURE_TEST(AutoPartition)
