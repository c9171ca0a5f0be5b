// Compiled behind an answer (-include FILE), into a library that the grader of its exercise loads: hands the answer
// over.
extern "C" const void *course_task() { return &course::exercise::task; }
