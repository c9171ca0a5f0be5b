// Grades what a maintainer wrote: the starter must be not done, the solution pass, and every mistake be caught.
#pragma once
#include "exercises/grading/grading.hpp"

namespace course {

struct Candidate {
    std::string file; // from the top of the tree; .../starter/..., .../solution/... or .../mistakes/...
    const void *task;
};

// 0 if all is as it should be; says what is not. The last line counts the mistakes caught: NAME: 5 of 5 mistakes caught
int check_answers(const std::string &exercise, const std::vector<Candidate> &answers, const Grade &grade);

} // namespace course
