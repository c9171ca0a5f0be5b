#include "chapters/10_uniform_grid/grid.hpp"
#include "tests/structures/structure_test.hpp"

COURSE_STRUCTURE_TEST(Grid)
