// The lesson's picture against the same scene stored in double, and the printed figure.
#include "chapters/01_ray_casting/camera.hpp"
#include "chapters/05_texture/antialias.hpp"
#include "chapters/05_texture/textured_scene.hpp"
#include "common/image_difference.hpp"
#include "tests/unit/widened.hpp"

#include <cstdio>
#include <gtest/gtest.h>

using namespace course;

namespace {

TEST(TexturedScene, LooksAsItDoesInDouble) {
    const Wardrobe wardrobe = paint_wardrobe(1);
    const auto render = [&](const auto &scene) {
        const auto lights = evening_lights();
        const Camera camera(textured_view(), 192, 108);
        return render_picture("05_texture", 192, 108,
                              antialiased({2, 3},
                                          [&](double x, double y, Random &random) {
                                              return textured_radiance(camera.ray(x, y), scene, lights,
                                                                       ImageSky{wardrobe.sky}, random);
                                          }))
            .picture;
    };
    const auto scene = textured_scene(wardrobe);
    const double rmse = difference(render(scene), render(widened(scene))).rmse;
    std::printf("05_texture: RMSE %.2g to the same scene in double (1/255 = %.2g allowed)\n", rmse, 1.0 / 255);
    EXPECT_LT(rmse, 1.0 / 255);
}

} // namespace
