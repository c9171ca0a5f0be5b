// The context that the tests draw with.
#pragma once
#include "common/errors.hpp"
#include "common/gl_context.hpp"

#include <gtest/gtest.h>

namespace course {

// Any context that this machine gives, or nullptr and the reason on the terminal.
inline std::unique_ptr<GlContext> any_context() {
    try {
        return open_context("auto");
    } catch (const InputError &error) {
        std::printf("skipped: %s\n", error.what());
        return nullptr;
    }
}

} // namespace course

// A macro, because only the test itself can end the test.
#define COURSE_CONTEXT_OR_SKIP(context)                                                                                \
    const auto context = course::any_context();                                                                        \
    if (!context)                                                                                                      \
    GTEST_SKIP() << "no OpenGL context here"
