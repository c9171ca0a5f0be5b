// image_difference A B: how far two pictures are apart. Exit status 0 within the tolerance, 1 beyond, 2 on bad input.
#include "common/image_difference.hpp"
#include "common/command_line.hpp"
#include "common/image_files.hpp"
#include "common/program.hpp"

#include <cstdio>

using namespace course;

int main(int argc, char **argv) {
    return run_guarded("image_difference", [&] {
        std::string expected, picture, out;
        double tolerance = 0, steps = 1, differing = 1e6;
        CommandLine options("image_difference", "How far two pictures of one size are apart");
        options.option("expected", expected, "The one picture");
        options.option("picture", picture, "The other");
        options.option("--tolerance", tolerance, {0, 255}, "Largest RMSE that passes, in 8-bit steps");
        options.option("--steps", steps, {0, 255}, "A pixel differs when a channel is more than this many steps apart");
        options.option("--differing", differing, {0, 1e6}, "Most differing pixels that pass, per million");
        options.option("--out", out, "Write a picture of the differences, eight times as large as they are");
        options.parse(argc, argv);
        if (picture.empty())
            throw InputError("pictures", "give two, the one and the other");
        if (!out.empty())
            require_writable_image(out);

        const Picture a = read_image(expected), b = read_image(picture);
        const ImageDifference apart = difference(a, b, steps);
        std::printf("RMSE %.4g linear, %.4g steps; largest %.4g linear, %.4g steps; differing by more than %g steps: "
                    "%.4g of a million pixels\n",
                    apart.rmse, apart.rmse_steps, apart.largest, apart.largest_steps, steps,
                    apart.differing_per_million);
        if (!out.empty())
            write_image(out, difference_picture(a, b));
        const bool within = apart.rmse_steps <= tolerance && apart.differing_per_million <= differing;
        if (!within)
            std::fprintf(stderr,
                         "image_difference: %s and %s are further apart than RMSE %g steps or %g of a million\n",
                         expected.c_str(), picture.c_str(), tolerance, differing);
        return within ? 0 : 1;
    });
}
