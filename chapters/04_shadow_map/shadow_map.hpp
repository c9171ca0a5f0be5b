// Lesson 04, step 2: the lamp writes down how far it sees; whatever lies deeper is in shadow.
#pragma once
#include "chapters/01_ray_casting/scene.hpp"
#include "chapters/03_light_and_shadow/any_hit.hpp"
#include "chapters/04_shadow_map/light_view.hpp"
#include "common/image.hpp"
#include "common/parallel.hpp"
#include "common/progress.hpp"

#include <algorithm>

namespace course {

// The depth of the nearest surface through the middle of each texel; infinite where there is none. Stored in float, as
// graphics cards do.
template <class AnyScene> Image<float> depth_image(const AnyScene &scene, const LightView &view, int resolution) {
    Image<float> depths(resolution, resolution);
    Progress progress("shadow map", static_cast<std::size_t>(resolution));
    parallel_for(static_cast<std::size_t>(resolution), [&](std::size_t row) {
        const int y = static_cast<int>(row);
        for (int x = 0; x < resolution; ++x)
            depths(x, y) =
                static_cast<float>(closest_hit(view.ray((x + 0.5) / resolution, (y + 0.5) / resolution), scene).t);
        progress.advance();
    });
    return depths;
}

// How a depth is compared.
struct MapLookup {
    double slope = 0.75; // of the bias, in texels
    int filter = 0;      // compares with all texels up to so many away from the nearest, and takes the mean
    double ulps = 2;     // of the depth in float: the bias for rounding alone
};

class ShadowMap {
  public:
    template <class AnyScene> ShadowMap(const AnyScene &scene, const LightView &view, int resolution)
        : view_(view), depths_(depth_image(scene, view, resolution)) {}

    // The share of the lamp's light that reaches the point, from 0 to 1. The normal has length one and faces the lamp.
    // Outside of its picture the lamp knows nothing: such points count as lit.
    float lit(const Vec<double> &point, const Vec<double> &normal, const MapLookup &how) const {
        const SeenPlace place = view_.place_of(point);
        if (!place.in_picture())
            return 1;
        const int n = depths_.width;
        const auto depth = static_cast<float>(place.depth - bias(point, normal, place.depth, how));
        const int x = static_cast<int>(place.x * n), y = static_cast<int>(place.y * n);
        int lit = 0, asked = 0;
        for (int j = std::max(0, y - how.filter); j <= std::min(n - 1, y + how.filter); ++j)
            for (int i = std::max(0, x - how.filter); i <= std::min(n - 1, x + how.filter); ++i, ++asked)
                lit += depth <= depths_(i, j);
        return static_cast<float>(lit) / static_cast<float>(asked);
    }

    const Image<float> &depths() const { return depths_; }
    const LightView &view() const { return view_; }

  private:
    // A texel's one depth stands for all of its width, over which the depth of an inclined surface changes. Half a
    // texel each way is what the point itself can be off; the filter's neighbours are whole texels farther.
    double bias(const Vec<double> &point, const Vec<double> &normal, double depth, const MapLookup &how) const {
        const double per_texel = view_.depth_slope(point, normal) / depths_.width;
        return how.ulps * 0x1p-23 * depth + how.slope * (1 + 2 * how.filter) * per_texel;
    }

    LightView view_;
    Image<float> depths_;
};

} // namespace course
