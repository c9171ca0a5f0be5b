// A small course with some of everything that a gallery shows, and the trouble that names and texts can make.
#pragma once
#include "common/image_files.hpp"
#include "common/output_files.hpp"

#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace course {

// A folder that goes when the test ends.
struct TemporaryFolder {
    std::filesystem::path path;

    TemporaryFolder() {
        std::string pattern = (std::filesystem::temp_directory_path() / "course_gallery_XXXXXX").string();
        if (!mkdtemp(pattern.data()))
            throw std::runtime_error("no temporary folder");
        path = pattern;
    }
    ~TemporaryFolder() {
        std::error_code error;
        std::filesystem::remove_all(path, error);
    }
    TemporaryFolder(const TemporaryFolder &) = delete;
};

struct GalleryFixture : TemporaryFolder {
    std::filesystem::path course = path / "course", out = course / "out";

    GalleryFixture() {
        std::filesystem::create_directories(course / "common"); // tests run in the top folder of the repository
        std::filesystem::copy("common/gallery", course / "common/gallery");
        for (const char *name : {"01_ray_casting", "02_primitives", "03_light", "04_shadow_map"})
            write_text(course / "chapters" / name / "main.cpp", "");
        write_text(course / "chapters/01_ray_casting/README.md",
                   "# Chapter 01: Casting <rays> & \"hits\"\n\n**The question.** Which colour has `a < b`,\nif $t$ is "
                   "known?\n\n**Time.** 35 minutes to read, 60 to do.\n\n![Many spheres](picture.png)\n");
        write_text(course / "README.md", "# A course\n\n![The whole of it](cover.png)\n");
        write_image(course / "cover.png", Picture(16, 9, red));
        write_text(course / "chapters/03_light/README.md", "# 03 · Light\n");
        picture("01_ray_casting", 96, 54, red, "Ray casting: one ray per pixel");
        picture("02_primitives", 60, 60, green, "Primitives: it\\u2019s \\\"one of each\\\" & <b>1</b> < 2");
        picture("04_shadow_map", 96, 54, blue, "Shadow maps: depth seen from the light");
        write_text(out / "chapters/02_primitives_cost #1 & more.svg", plot);
        write_text(out / "accuracy.json", R"({"machine": {"processor": "Some CPU", "cores": 2}, "options": {},
            "results": [{"family": "H1", "test": "<sphere>", "default": true, "ns_per_test": 3.25},
                        {"family": "H2", "test": "disk & co", "default": false, "ns_per_test": null}]})");
        write_text(out / "accuracy_speed.svg", plot);
        write_text(out / "claims.json", R"({"results": [
            {"id": "C1", "claim": "8 and 16 bounces differ little", "how": "two pictures", "measured": "RMSE 0.1",
             "holds if": "RMSE < 1", "verdict": "holds", "depends on": "", "chapter": "02_primitives", "figure": "claims_C1.svg"},
            {"id": "C14", "claim": "forward tracing wastes rays", "how": "a count", "measured": "0 of 10",
             "holds if": "few", "verdict": "depends", "depends on": "the lens", "chapter": "99_none", "figure": ""}]})");
        write_text(out / "claims_C1.svg", plot);
        write_text(course / "slides/01_ray_casting.md", deck("01 · Rays & eyes", "camera, ray"));
        write_text(course / "slides/02_primitives.md", deck("02 · Shapes", "one of each"));
        write_text(out / "slides/01_ray_casting.html", "<title>Rays</title>");
        write_text(out / "slides/01_ray_casting.pdf", "");
        write_text(out / "slides/index.html", "<title>All</title>");
        write_text(course / "exercises/01_sphere/README.md",
                   "# 01 · The sphere\n\nWhere does a *ray*\nmeet it?\n\n**Your task.** Write it.\n");
    }

    static inline const Colour red{0.5f, 0.02f, 0.02f}, green{0.02f, 0.4f, 0.02f}, blue{0.02f, 0.02f, 0.5f};
    static constexpr const char *plot =
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"82\" height=\"50\"><title>Cost &amp; "
        "error</title><desc>ns against ulp</desc><rect width=\"82\" height=\"50\" "
        "fill=\"white\"/></svg>";

    static std::string deck(const std::string &title, const std::string &description) {
        return "---\nmarp: true\ntitle: " + title + "\ndescription: " + description + "\n---\n\n# Title\n";
    }

    void picture(const std::string &name, int width, int height, Colour colour, const std::string &summary) const {
        write_image(out / "chapters" / (name + ".png"), Picture(width, height, colour));
        write_text(out / "chapters" / (name + ".json"), "{\"chapter\": \"" + name + "\", \"summary\": \"" + summary +
                                                            "\", \"width\": " + std::to_string(width) +
                                                            ", \"height\": " + std::to_string(height) +
                                                            ", \"seconds\": 0.5, \"rays\": 1234567, \"threads\": 2}");
    }
};

} // namespace course
