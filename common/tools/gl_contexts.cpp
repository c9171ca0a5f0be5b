// Which OpenGL contexts this machine gives, and who computes behind each: a part of ./course doctor.
#include "common/errors.hpp"
#include "common/gl_context.hpp"

#include <cstdio>

int main() {
    for (const std::string &name : course::context_names())
        try {
            const auto context = course::open_context(name);
            std::printf("  ok      %s: %s, OpenGL %s\n", name.c_str(), context->renderer().c_str(),
                        context->version().c_str());
        } catch (const course::InputError &error) {
            std::printf("  absent  %s\n", error.what());
        }
}
