// Lesson 17, step 12: the picture alive, in a window.
#pragma once
#include "chapters/17_gpu/live_picture.hpp"
#include "common/gl_window.hpp"
#include "common/screenshot.hpp"

#include <cstdio>

namespace course {

// At most `samples` passes for a view; then the window waits.
#ifdef COURSE_WITHOUT_GLFW
inline void show_live(const Exhibit &, const LiveChoice &, int, int, int) {
    throw InputError("--window", "this build has no windows");
}
#else
inline void show_live(Exhibit exhibit, const LiveChoice &choice, int width, int height, int samples) {
    const Viewpoint home = exhibit.view;
    GlWindow window("17_gpu", width, height, home, gl_major, gl_minor);
    LivePicture live(window.gl(), std::move(exhibit), choice);
    std::printf("%s\n%s\n", GlWindow::keys, LiveChoice::keys);
    std::fflush(stdout);
    bool screenshot_wanted = false;
    while (!window.closed()) {
        const bool current = live.is_of(window.viewpoint(), window.width(), window.height());
        const bool done = current && live.passes() >= samples;
        if (!done)
            live.advance(window.viewpoint(), window.width(), window.height());
        if (window.take_damage() || !done) {
            live.show();
            window.swap_buffers();
            window.set_title(live.title());
        }
        if (screenshot_wanted && live.passes() > 0) {
            save_screenshot(live.picture());
            screenshot_wanted = false;
        }
        window.await_events(done && !window.flying() && !screenshot_wanted ? 0 : 0.001);
        for (const char key : window.take_keys())
            if (key == 'P')
                screenshot_wanted = true;
            else
                live.press(key);
    }
}
#endif

} // namespace course
