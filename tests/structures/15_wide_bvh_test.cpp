#include "chapters/15_wide_bvh/wide_bvh.hpp"
#include "tests/structures/structure_test.hpp"

COURSE_STRUCTURE_TEST(WideBvh)
