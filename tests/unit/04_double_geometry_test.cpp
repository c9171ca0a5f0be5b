// The sundial of lessons 03 and 04 against the same scene stored in double, and the printed figures.
#include "chapters/04_shadow_map/comparison.hpp"
#include "common/image_difference.hpp"
#include "tests/unit/widened.hpp"

#include <cstdio>
#include <gtest/gtest.h>

using namespace course;

namespace {

constexpr int width = 240, height = 135;

// The pictures of a scene by its map and by shadow rays.
template <class AnyScene> std::pair<Picture, Picture> render(const AnyScene &scene) {
    const ShadowMap map(scene, LightView(lamp_view), 256);
    const Camera camera(panel_view, width, height);
    std::pair pictures{Picture(width, height), Picture(width, height)};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const Compared both = compare(camera.ray(x + 0.5, y + 0.5), scene, map, {.filter = 1});
            pictures.first(x, y) = both.by_map;
            pictures.second(x, y) = both.by_rays;
        }
    return pictures;
}

TEST(Sundial, LooksAsItDoesInDouble) {
    const auto scene = sundial_scene();
    const auto stored_in_float = render(scene), stored_in_double = render(widened(scene));
    const double by_map = difference(stored_in_float.first, stored_in_double.first).rmse;
    const double by_rays = difference(stored_in_float.second, stored_in_double.second).rmse;
    std::printf("04_shadow_map: RMSE %.2g by the map, %.2g by shadow rays to the same scene in double (1/255 = %.2g "
                "allowed)\n",
                by_map, by_rays, 1.0 / 255);
    EXPECT_LT(by_map, 1.0 / 255);
    EXPECT_LT(by_rays, 1.0 / 255);
}

} // namespace
