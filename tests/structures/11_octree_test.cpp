#include "chapters/11_octree/octree.hpp"
#include "tests/structures/structure_test.hpp"

COURSE_STRUCTURE_TEST(Octree)
