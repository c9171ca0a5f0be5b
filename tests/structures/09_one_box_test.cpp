#include "tests/structures/structure_test.hpp"

COURSE_STRUCTURE_TEST(OneBox)
COURSE_STRUCTURE_TEST(PlainList)
