// Chapter 04: a shadow map beside shadow rays. Above the two pictures, below what the lamp saw and where they differ.
#include "chapters/04_shadow_map/comparison.hpp"
#include "chapters/04_shadow_map/reports.hpp"

using namespace course;

namespace {

// The middle rows of what the lamp saw, as wide as the panel: from yellow, near, over red to blue, far.
class DepthPanel {
  public:
    DepthPanel(const Image<float> &depths, int width, int height) : depths_(depths), width_(width), height_(height) {
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                if (const float depth = depth_at(x, y); std::isfinite(depth)) {
                    nearest_ = std::min(nearest_, depth);
                    farthest_ = std::max(farthest_, depth);
                }
    }

    Colour operator()(int x, int y) const {
        const float depth = depth_at(x, y);
        if (!std::isfinite(depth))
            return Colour(0);
        const float far = (depth - nearest_) / std::max(farthest_ - nearest_, 1e-6f);
        const Colour yellow(0.95f, 0.80f, 0.30f), red(0.55f, 0.06f, 0.10f), blue(0.02f, 0.02f, 0.12f);
        return far < 0.5f ? mix(yellow, red, 2 * far) : mix(red, blue, 2 * far - 1);
    }

  private:
    float depth_at(int x, int y) const {
        const auto n = static_cast<double>(depths_.width);
        const double texels = n / width_, row = n / 2 + (y + 0.5 - height_ / 2.0) * texels;
        return depths_(static_cast<int>((x + 0.5) * texels), std::clamp(static_cast<int>(row), 0, depths_.width - 1));
    }

    const Image<float> &depths_;
    int width_, height_;
    float nearest_ = infinity<float>, farthest_ = 0;
};

} // namespace

int main(int argc, char **argv) {
    return run_program("04_shadow_map", "Shadow map: the lamp's view, looked up", argc, argv, [](Program &program) {
        int resolution = 256;
        MapLookup how{.filter = 1};
        bool measure = false;
        program.options.option("--resolution", resolution, {1, 8192}, "The shadow map's width and height in texels");
        program.options.option("--bias", how.slope, {0, 1e6}, "Slope-scaled bias in texels; 0 for none");
        program.options.option("--filter", how.filter, {0, 64}, "Radius of percentage-closer filtering in texels");
        program.options.flag("--measure", measure, "Instead measure error and time: tables and plots");
        program.parse();
        if (measure)
            return measure_shadow_maps(program);

        const SundialScene scene = sundial_scene();
        const ShadowMap map(scene, LightView(lamp_view), resolution);
        program.render(panel_view, [&](const Viewpoint &from, int width, int height) {
            const int w = (width + 1) / 2, h = (height + 1) / 2;
            return each_pixel(
                [&, w, h, camera = Camera(from, w, h), panel = DepthPanel(map.depths(), w, h)](int x, int y) {
                    if (y >= h && x < w)
                        return panel(x, y - h);
                    const Compared both = compare(camera.ray(x % w + 0.5, y % h + 0.5), scene, map, how);
                    return y >= h ? difference_colour(both) : x < w ? both.by_map : both.by_rays;
                });
        });
    });
}
