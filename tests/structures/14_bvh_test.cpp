#include "chapters/14_bvh/bvh.hpp"
#include "tests/structures/structure_test.hpp"

COURSE_STRUCTURE_TEST(Bvh)
COURSE_STRUCTURE_TEST(MedianBvh)
