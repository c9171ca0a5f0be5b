// gallery: writes out/index.html from the pictures, records and reports that the course's programs left in out/.
#include "common/gallery.hpp"
#include "common/command_line.hpp"
#include "common/program.hpp"

#include <algorithm>
#include <cstdio>

using namespace course;

int main(int argc, char **argv) {
    return run_guarded("gallery", [&] {
        std::string out_folder = "out", course_folder = ".";
        CommandLine options("gallery", "Writes one page with every chapter's picture and every report");
        options.option("--out-folder", out_folder, "Where pictures and reports lie, and where index.html goes");
        options.option("--course-folder", course_folder, "The folder with chapters/, for titles, lessons and sources");
        options.parse(argc, argv);

        const Gallery gallery = write_gallery(course_folder, out_folder);
        const auto rendered =
            std::ranges::count_if(gallery.chapters, [](const GalleryChapter &c) { return c.record.has_value(); });
        std::printf("gallery: %lld of %zu chapters and %zu sections, %s/index.html\n", static_cast<long long>(rendered),
                    gallery.chapters.size(), gallery.sections.size(), out_folder.c_str());
        return 0;
    });
}
