// Lesson 17, step 12: passes that add up, and the same samples on the CPU in double to compare with.
#pragma once
#include "chapters/17_gpu/scenes.hpp"
#include "chapters/17_gpu/tracer.hpp"
#include "common/image_difference.hpp"
#include "common/progress.hpp"

#include <chrono>
#include <cstdio>

namespace course {

// The passes of one picture. The GPU works while the CPU waits; after Ctrl-C what is done is kept.
inline RenderedPicture gpu_picture(const GlContext &context, GpuTracer &tracer, const Viewpoint &view, int width,
                                   int height, int samples) {
    tracer.start(view, width, height);
    tracer.warm_up();
    const auto start = std::chrono::steady_clock::now();
    Progress progress("17_gpu", static_cast<std::size_t>(samples));
    int done = 0;
    do {
        tracer.pass(done);
        context.gl().Finish();
        progress.advance();
    } while (++done < samples && !interrupted());
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const PassCounts counts = tracer.counts();
    if (counts.cut_short > 0)
        throw InputError("--scene",
                         "the loops of " + std::to_string(counts.cut_short) +
                             " pixels were cut short; fewer bounces, a smaller mesh or --walk stack need fewer steps");
    if (counts.rays_not_kept > 0)
        std::fprintf(stderr,
                     "17_gpu: warning: the ray stack was full %.0f times, and the picture lacks those rays' light\n",
                     counts.rays_not_kept);
    return {tracer.picture(), seconds, static_cast<std::uint64_t>(counts.rays), static_cast<double>(done) / samples};
}

// The same on every core of the CPU, pass for pass.
inline RenderedPicture cpu_picture(const Exhibit &exhibit, int width, int height, int samples, std::uint64_t seed) {
    const Camera camera(exhibit.view, width, height);
    RenderedPicture sum{Picture(width, height), 0, 0, 1};
    for (int pass = 0; pass < samples; ++pass) {
        *exhibit.pass = pass;
        const glm::dvec2 place = sample_place(pass);
        const RenderedPicture one =
            render_picture("on the CPU", width, height, each_pixel([&](int x, int y) {
                               Random random = random_of(seed, x, y, pass);
                               return exhibit.colour(camera.ray(x + place.x, y + place.y), random);
                           }));
        std::ranges::transform(sum.picture.pixels, one.picture.pixels, sum.picture.pixels.begin(), std::plus());
        sum.seconds += one.seconds;
        sum.rays += one.rays;
    }
    for (Colour &pixel : sum.picture.pixels)
        pixel /= static_cast<float>(samples);
    return sum;
}

} // namespace course
