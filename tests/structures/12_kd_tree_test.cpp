#include "chapters/12_kd_tree/kd_tree.hpp"
#include "tests/structures/structure_test.hpp"

COURSE_STRUCTURE_TEST(KdTreeMedian)
COURSE_STRUCTURE_TEST(KdTreeMiddle)
COURSE_STRUCTURE_TEST(KdTreeSah)
