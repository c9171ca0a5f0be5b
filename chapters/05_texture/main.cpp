// Chapter 05: textures on every shape, under a sky that is a picture too.
#include "chapters/01_ray_casting/camera.hpp"
#include "chapters/05_texture/antialias.hpp"
#include "chapters/05_texture/filtering.hpp"
#include "chapters/05_texture/textured_scene.hpp"
#include "common/program.hpp"

using namespace course;

int main(int argc, char **argv) {
    return run_program("05_texture", "Textures on every shape, and a sky", argc, argv, [](Program &program) {
        Sampling sampling;
        std::string globe, sky;
        bool measure = false;
        program.options.option("--samples", sampling.first, {1, 64}, "Samples per pixel and side, in every pixel");
        program.options.option("--refine", sampling.refined, {1, 64}, "The same where the first samples differ");
        program.options.option("--globe", globe, "Picture to put on the sphere (longitude across, latitude up)");
        program.options.option("--sky", sky, "Picture of the sky (longitude across, latitude up)");
        program.options.flag("--measure", measure, "Instead measure the error of textures against samples");
        program.parse();
        sampling.seed = program.seed;

        Wardrobe wardrobe = paint_wardrobe(program.seed);
        if (!globe.empty())
            wardrobe.planet = read_image(globe);
        if (!sky.empty())
            wardrobe.sky = read_image(sky);
        const auto scene = textured_scene(wardrobe);
        const auto lights = evening_lights();
        // The colour at any place of a picture, in pixels from the top left corner.
        const auto colours = [&](const Viewpoint &from, int width, int height) {
            return [&, camera = Camera(from, width, height)](double x, double y, Random &random) {
                return textured_radiance(camera.ray(x, y), scene, lights, ImageSky{wardrobe.sky}, random);
            };
        };
        const Viewpoint view = textured_view();
        if (measure) {
            measure_samples(program, colours(view, 384, 216), Picture(384, 216));
            return measure_texels(program);
        }
        program.render(view, [&](const Viewpoint &from, int width, int height) {
            return antialiased(sampling, colours(from, width, height));
        });
    });
}
