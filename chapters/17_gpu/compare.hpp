// Lesson 17, step 12: passes that add up, and the same samples on the CPU in double to compare with.
#pragma once
#include "chapters/17_gpu/scenes.hpp"
#include "chapters/17_gpu/tracer.hpp"
#include "common/image_difference.hpp"
#include "common/progress.hpp"

#include <chrono>
#include <cstdio>

namespace course {

// Where pass number `index` samples each pixel: the first in the middle, the others spread evenly, by multiples of the
// plane's golden ratio (Roberts 2018). All pixels and both tracers take the same places.
inline glm::dvec2 sample_place(int index) {
    const double g = 1.32471795724474602596; // g^3 = g + 1
    const glm::dvec2 place = glm::dvec2(0.5) + static_cast<double>(index) * glm::dvec2(1 / g, 1 / (g * g));
    return place - floor(place);
}

// The passes of one picture. The GPU works while the CPU waits; after Ctrl-C what is done is kept.
inline RenderedPicture gpu_picture(const GlContext &context, GpuTracer &tracer, const Viewpoint &view, int width,
                                   int height, int samples) {
    tracer.start(view, width, height);
    tracer.warm_up();
    const auto start = std::chrono::steady_clock::now();
    Progress progress("17_gpu", static_cast<std::size_t>(samples));
    int done = 0;
    do {
        tracer.pass(sample_place(done));
        context.gl().Finish();
        progress.advance();
    } while (++done < samples && !interrupted());
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const GpuTracer::Counts counts = tracer.counts();
    if (counts.cut_short > 0)
        throw InputError("--bounces", "the loops of " + std::to_string(counts.cut_short) +
                                          " pixels were cut short; fewer bounces need fewer steps");
    if (counts.rays_not_kept > 0)
        std::fprintf(stderr,
                     "17_gpu: warning: the ray stack was full %.0f times, and the picture lacks those rays' light\n",
                     counts.rays_not_kept);
    return {tracer.picture(), seconds, static_cast<std::uint64_t>(counts.rays), static_cast<double>(done) / samples};
}

// The same on every core of the CPU.
inline RenderedPicture cpu_picture(const Exhibit &exhibit, int width, int height, int samples, std::uint64_t seed) {
    const Camera camera(exhibit.view, width, height);
    return render_picture("on the CPU", width, height, each_pixel([&](int x, int y) {
                              Random random(seed, static_cast<std::uint64_t>(y) << 32 | static_cast<std::uint32_t>(x));
                              Vec<double> sum(0);
                              for (int i = 0; i < samples; ++i) {
                                  const glm::dvec2 place = sample_place(i);
                                  sum += Vec<double>(exhibit.colour(camera.ray(x + place.x, y + place.y), random));
                              }
                              return Colour(sum / static_cast<double>(samples));
                          }));
}

} // namespace course
