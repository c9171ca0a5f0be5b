// Lesson 17, step 11: the same picture drawn in several ways, in turns; how long each takes and how far off it is.
#pragma once
#include "chapters/08_mesh/ball.hpp"
#include "chapters/17_gpu/compare.hpp"
#include "chapters/17_gpu/rasteriser.hpp"
#include "common/plot.hpp"
#include "common/report.hpp"
#include "common/timing.hpp"

#include <memory>

namespace course {

// A context and the name by which it was asked for; with "auto" that of the first that works.
struct NamedContext {
    std::string name;
    std::unique_ptr<GlContext> context;
};
inline NamedContext named_context(const std::string &name) {
    if (name == "auto")
        for (const std::string &one : context_names())
            try {
                return {one, open_context(one)};
            } catch (const InputError &) {
            }
    return {name, open_context(name)};
}

// One way to draw a picture. Stages: fragment, compute, cpu, raster.
struct Way {
    std::string stage, walk = "stack";
    bool specialised = true;
};

struct Measured {
    Way way;
    double compile_seconds = 0;      // from the shader's text to the first pixel
    std::vector<double> rounds = {}; // the seconds of a picture, one sample a pixel, in each round
    double seconds = 0;              // their median
    double rays = 0;                 // of a picture
    ImageDifference apart = {};      // from the CPU's picture in double
};

// What is drawn: by ray tracing, and, where it is a mesh on its table, by rasterisation.
struct Sitter {
    std::string name;
    std::size_t triangles;
    Exhibit exhibit;
    std::shared_ptr<const Studio> studio = nullptr;
};

// Each way by itself: the picture it makes, for its error, and how to draw it once more, for its time.
class Draughtsman {
  public:
    Draughtsman(const GlContext &context, const Sitter &sitter, const Way &way, int width, int height)
        : measured_{.way = way} {
        const Gl &gl = context.gl();
        const auto start = std::chrono::steady_clock::now();
        const auto passed = [&] {
            return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        };
        if (way.stage == "raster") {
            rasteriser_ = std::make_unique<Rasteriser>(gl, *sitter.studio);
            draw_ = [this, &gl, &sitter, width, height] {
                rasteriser_->draw(sitter.exhibit.view, width, height);
                gl.Finish();
            };
            draw_();
            measured_.compile_seconds = passed();
            picture_ = rasteriser_->picture(sitter.exhibit.view);
            return;
        }
        const PackedScene scene = way.specialised ? sitter.exhibit.scene : with_everything(sitter.exhibit.scene);
        Defines defines = shader_defines(scene, way.walk);
        if (way.stage == "compute")
            need(defines, "COMPUTE");
        tracer_ = std::make_unique<GpuTracer>(gl, scene, defines);
        tracer_->start(sitter.exhibit.view, width, height);
        tracer_->warm_up();
        measured_.compile_seconds = passed();
        draw_ = [this, &gl] {
            tracer_->pass(0);
            gl.Finish();
        };
        draw_();
        if (tracer_->counts().cut_short > 0)
            throw InputError(sitter.name, "the loops of some pixels were cut short on this driver");
        measured_.rays = tracer_->counts().rays;
        picture_ = tracer_->picture();
    }

    const std::function<void()> &draw() const { return draw_; }
    const Picture &picture() const { return picture_; }
    const Measured &measured() const { return measured_; }

  private:
    std::unique_ptr<GpuTracer> tracer_;
    std::unique_ptr<Rasteriser> rasteriser_;
    std::function<void()> draw_;
    Picture picture_;
    Measured measured_;
};

// The ways in turns, in one process.
inline std::vector<Measured> measure_ways(const GlContext &context, const Sitter &sitter, const std::vector<Way> &ways,
                                          int width, int height, int rounds) {
    const auto on_cpu = [&] { return cpu_picture(sitter.exhibit, width, height, 1, 1); };
    const RenderedPicture exact = on_cpu();
    std::vector<std::unique_ptr<Draughtsman>> hands;
    std::vector<std::function<void()>> variants;
    std::vector<Measured> found;
    for (const Way &way : ways) {
        if (way.stage == "cpu") {
            found.push_back({.way = way, .rays = static_cast<double>(exact.rays)});
            variants.emplace_back([&] { keep(on_cpu().rays); });
            continue;
        }
        hands.push_back(std::make_unique<Draughtsman>(context, sitter, way, width, height));
        found.push_back(hands.back()->measured());
        found.back().apart = difference(exact.picture, hands.back()->picture());
        variants.push_back(hands.back()->draw());
    }
    const auto seconds = seconds_of_rounds(variants, rounds);
    for (std::size_t i = 0; i < found.size(); ++i) {
        found[i].rounds = seconds[i];
        found[i].seconds = quantile(seconds[i], 0.5);
    }
    return found;
}

inline Sitter ball_sitter(int level) {
    const Studio on_table = studio(ball(level));
    return {"ball", size(on_table.mesh()), first_hits_exhibit(on_table)};
}
inline Sitter mesh_sitter(const std::string &name, Studio on_table) {
    const auto shared = std::make_shared<const Studio>(on_table);
    return {name, size(shared->mesh()), mesh_exhibit(std::move(on_table)), shared};
}

} // namespace course
