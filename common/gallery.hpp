// The gallery, out/index.html: what was rendered and measured so far, read from the files that the programs left
// (gallery_files.cpp, gallery_texts.cpp) and written as one page that needs no network (gallery_page.cpp,
// gallery_sections.cpp).
#pragma once
#include "common/report.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace course {

// What run_program() writes beside a picture.
struct PictureRecord {
    std::string chapter, summary, machine; // machine may be empty
    int width = 0, height = 0, threads = 0;
    double seconds = 0;
    std::uint64_t rays = 0;
};

// Throws InputError, one line with the file's name, unless the file is such a record, with numbers that make sense.
PictureRecord read_record(const std::filesystem::path &file);

// Every address below is relative to the page and encoded as a URL; empty where there is no such file.
struct GalleryLink {
    std::string address, text;
};
struct GalleryFigure {
    std::string address, caption, description; // the description is for those who cannot see it
};
struct GalleryTable {
    std::string caption, machine;
    std::vector<Row> rows;
};

// What a measurement left: plots, tables, and its files to open.
struct Findings {
    std::vector<GalleryFigure> figures;
    std::vector<GalleryTable> tables;
    std::vector<GalleryLink> files;
    bool empty() const { return figures.empty() && tables.empty() && files.empty(); }
};

// What a list shows in one line: a deck of slides, an exercise.
struct GalleryEntry {
    std::string number = {}, address = {}, title = {}, about = {};
    std::string command = {};           // what makes it or works on it; may be empty
    std::vector<GalleryLink> also = {}; // other forms of the same
};

struct GalleryChapter {
    std::string name, number, title, summary; // 01_ray_casting, 01, Ray casting, one ray per pixel
    std::string question, minutes;            // the lesson's own: "Which colour ...?", "35 to read, 60 to do"
    std::optional<PictureRecord> record;      // none: not rendered yet
    std::string picture, description;         // description: the lesson's own words for its picture
    std::string lesson, source;
    std::vector<GalleryLink> links; // its slides, its exercises
    Findings findings;
};

struct GallerySection {
    std::string id = {}, short_heading = {}, heading = {}, about = {}; // short_heading: for the bar of parts
    std::string making = {};                                           // how it is made, where `made` is false
    bool made = false;
    Findings findings = {};
    std::vector<GalleryEntry> list = {};
};

struct Gallery {
    GalleryFigure cover; // the first picture of the course's README
    std::vector<GalleryChapter> chapters;
    std::vector<GallerySection> sections; // always all of them, in the order of the page
};

// Chapters are the folders NN_name of course_folder/chapters with a main.cpp; what they and the reports left is looked
// for under out_folder. Throws InputError on a file that is there and makes no sense.
Gallery read_gallery(const std::filesystem::path &course_folder, const std::filesystem::path &out_folder);

// The page, complete with the given style sheet and script.
std::string gallery_page(const Gallery &, const std::string &style, const std::string &script);

// Reads, writes out_folder/index.html with the style and script of course_folder/common/gallery, and returns it.
Gallery write_gallery(const std::filesystem::path &course_folder, const std::filesystem::path &out_folder);

} // namespace course
