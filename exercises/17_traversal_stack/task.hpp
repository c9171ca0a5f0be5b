// Exercise 17, the second: what an answer hands over: the text of its file.
#pragma once
#include "exercises/grading/grading.hpp"

namespace course {

using Task = GlslAnswer;

} // namespace course
