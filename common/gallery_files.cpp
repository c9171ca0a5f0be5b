#include "common/errors.hpp"
#include "common/gallery.hpp"
#include "common/html.hpp"
#include "common/output_files.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

namespace course {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::string read_text(const fs::path &file) {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    if (!in)
        throw InputError(file.string(), "cannot be read");
    return text.str();
}

Json read_json(const fs::path &file) {
    try {
        Json json = Json::parse(read_text(file));
        if (!json.is_object())
            throw InputError(file.string(), "is JSON, but not an object");
        return json;
    } catch (const Json::exception &) {
        throw InputError(file.string(), "is not JSON");
    }
}

// The regular files of a folder in the order of their names; none where there is no such folder.
std::vector<fs::path> files_of(const fs::path &folder) {
    std::vector<fs::path> files;
    std::error_code error;
    for (const auto &entry : fs::directory_iterator(folder, error))
        if (entry.is_regular_file() && !entry.path().filename().string().starts_with('.'))
            files.push_back(entry.path());
    std::ranges::sort(files);
    return files;
}

std::string address_from(const fs::path &out_folder, const fs::path &target) {
    const fs::path page_folder = fs::weakly_canonical(fs::absolute(out_folder));
    return html::address(fs::weakly_canonical(fs::absolute(target)).lexically_relative(page_folder).generic_string());
}

std::string capitalised(std::string text) {
    if (!text.empty())
        text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
    return text;
}

std::string in_words(std::string name) {
    std::ranges::replace(name, '_', ' ');
    return capitalised(name);
}

std::string between(const std::string &text, const std::string &before, const std::string &after) {
    const auto start = text.find(before);
    if (start == std::string::npos)
        return {};
    const auto from = start + before.size(), to = text.find(after, from);
    return to == std::string::npos ? std::string() : text.substr(from, to - from);
}

// ---- lessons --------------------------------------------------------------------------------------------------------

// The lesson's first heading without the words that only number it: "# Chapter 03: Light" is "Light".
std::string heading_of(const std::string &markdown) {
    std::istringstream lines(markdown);
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with("# ")) {
            std::string heading = line.substr(2);
            if (heading.starts_with("Chapter "))
                heading.erase(0, 8);
            std::size_t start = 0;
            while (start < heading.size() && std::isdigit(static_cast<unsigned char>(heading[start])))
                ++start;
            if (start > 0)
                for (const std::string_view mark : {" ", ".", ":", "·", "–", "—", "-", " "})
                    while (std::string_view(heading).substr(start).starts_with(mark))
                        start += mark.size();
            while (!heading.empty() && std::isspace(static_cast<unsigned char>(heading.back())))
                heading.pop_back();
            return capitalised(heading.substr(std::min(start, heading.size())));
        }
    return {};
}

// What the lesson says of its picture: the words in ![...](picture.png).
std::string picture_words(const std::string &markdown) {
    const auto end = markdown.find("](picture.png)");
    const auto start = end == std::string::npos ? end : markdown.rfind("![", end);
    if (start == std::string::npos)
        return {};
    std::string words = markdown.substr(start + 2, end - start - 2);
    std::ranges::replace(words, '\n', ' ');
    return words;
}

// ---- reports --------------------------------------------------------------------------------------------------------

Value as_value(const Json &json) {
    if (json.is_boolean())
        return json.get<bool>();
    if (json.is_number_integer())
        return json.get<std::int64_t>();
    if (json.is_number())
        return json.get<double>();
    if (json.is_string())
        return json.get<std::string>();
    return json.is_null() ? std::string("not finite") : json.dump();
}

std::string machine_of(const Json &json) {
    if (!json.contains("machine"))
        return {};
    const Json &machine = json["machine"];
    if (machine.is_string())
        return machine.get<std::string>();
    std::string words;
    for (const auto &[name, value] : machine.items())
        words += (words.empty() ? "" : ", ") + (name == "cores"     ? value.dump() + " cores"
                                                : value.is_string() ? value.get<std::string>()
                                                                    : name + " " + value.dump());
    return words;
}

// A report's rows; nothing for a picture's record.
std::optional<GalleryTable> read_table(const fs::path &file, const std::string &caption) {
    const Json json = read_json(file);
    if (json.contains("chapter") && !json.contains("results"))
        return {};
    if (!json.contains("results") || !json["results"].is_array())
        throw InputError(file.string(), "is not a report: it has no list of results");
    GalleryTable table{caption, machine_of(json), {}};
    for (const Json &result : json["results"]) {
        if (!result.is_object())
            throw InputError(file.string(), "is not a report: a result is not an object");
        Row &row = table.rows.emplace_back();
        for (const auto &[name, value] : result.items())
            row.set(name, as_value(value));
    }
    return table;
}

// A plot says in its own title and description what it shows; a plain file has only its name.
GalleryFigure figure_of(const fs::path &file, const std::string &name, const fs::path &out_folder) {
    GalleryFigure figure{address_from(out_folder, file), in_words(name), {}};
    if (file.extension() == ".svg") {
        const std::string svg = read_text(file).substr(0, 4000);
        const auto plain = [](std::string text) {
            for (const auto &[entity, letter] :
                 {std::pair{"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&amp;", "&"}})
                for (auto at = text.find(entity); at != std::string::npos; at = text.find(entity, at + 1))
                    text.replace(at, std::string_view(entity).size(), letter);
            return text;
        };
        if (const auto title = between(svg, "<title>", "</title>"); !title.empty() && title != "Gnuplot") {
            figure.caption = plain(title);
            figure.description = plain(between(svg, "<desc>", "</desc>"));
        }
    }
    if (figure.description.empty())
        figure.description = figure.caption;
    return figure;
}

// Adds the file if its ending is one that the page shows or links; `name` is what it is called without its ending.
void add_finding(Findings &findings, const fs::path &file, const std::string &name, const fs::path &out_folder) {
    const std::string ending = file.extension().string();
    if (ending == ".svg" || ending == ".png")
        return findings.figures.push_back(figure_of(file, name, out_folder));
    if (ending == ".json") {
        auto table = read_table(file, in_words(name));
        if (!table)
            return;
        findings.tables.push_back(std::move(*table));
    }
    if (ending == ".json" || ending == ".md" || ending == ".csv")
        findings.files.push_back({address_from(out_folder, file), file.filename().string()});
}

// ---- chapters -------------------------------------------------------------------------------------------------------

bool is_chapter_name(const std::string &name) {
    return name.size() > 3 && std::isdigit(static_cast<unsigned char>(name[0])) &&
           std::isdigit(static_cast<unsigned char>(name[1])) && name[2] == '_';
}

GalleryChapter read_chapter(const fs::path &folder, const fs::path &out_folder) {
    GalleryChapter chapter;
    chapter.name = folder.filename().string();
    chapter.number = chapter.name.substr(0, 2);
    chapter.source = address_from(out_folder, folder) + "/";
    if (fs::exists(folder / "README.md")) {
        const std::string lesson = read_text(folder / "README.md");
        chapter.lesson = address_from(out_folder, folder / "README.md");
        chapter.title = heading_of(lesson);
        chapter.description = picture_words(lesson);
    }

    const fs::path pictures = out_folder / "chapters";
    const fs::path record = pictures / (chapter.name + ".json"), picture = pictures / (chapter.name + ".png");
    if (fs::exists(record)) {
        chapter.record = read_record(record);
        if (chapter.record->chapter != chapter.name)
            throw InputError(record.string(), "is the record of another chapter, " + chapter.record->chapter);
        // "Ray casting: one ray per pixel" is a title and what it is about.
        const std::string &summary = chapter.record->summary;
        const auto colon = summary.find(": ");
        const bool divided = colon != std::string::npos;
        chapter.summary = capitalised(divided ? summary.substr(colon + 2) : summary);
        if (chapter.title.empty())
            chapter.title = divided ? summary.substr(0, colon) : summary;
        if (fs::exists(picture))
            chapter.picture = address_from(out_folder, picture);
        else
            chapter.record.reset();
    }
    if (chapter.title.empty())
        chapter.title = in_words(chapter.name.substr(3));
    if (chapter.description.empty())
        chapter.description = chapter.summary;

    const std::string prefix = chapter.name + "_";
    for (const fs::path &file : files_of(pictures))
        if (const std::string stem = file.stem().string(); stem.starts_with(prefix))
            add_finding(chapter.findings, file, stem.substr(prefix.size()), out_folder);
    return chapter;
}

// ---- sections -------------------------------------------------------------------------------------------------------

GallerySection report_section(const std::string &id, const std::string &heading, const std::string &about,
                              const fs::path &out_folder) {
    GallerySection section{id, heading, about, {}, {}};
    for (const fs::path &file : files_of(out_folder)) {
        const std::string stem = file.stem().string();
        if (stem == id)
            add_finding(section.findings, file, heading, out_folder);
        else if (stem.starts_with(id + "_"))
            add_finding(section.findings, file, stem.substr(id.size() + 1), out_folder);
    }
    return section;
}

GallerySection slides_section(const fs::path &out_folder) {
    GallerySection section{
        "slides", "Slides", "One deck for each chapter, with the pictures and plots made here.", {}, {}};
    for (const fs::path &file : files_of(out_folder / "slides"))
        if (file.extension() == ".html" && file.stem() != "index") {
            const std::string title = between(read_text(file), "<title>", "</title>");
            section.list.push_back(
                {address_from(out_folder, file), title.empty() ? in_words(file.stem().string()) : title});
        }
    return section;
}

GallerySection exercises_section(const fs::path &course_folder, const fs::path &out_folder) {
    GallerySection section{
        "exercises",
        "Exercises",
        "Each comes with a starter, hints and a test. `./course exercise list` shows how far you are.",
        {},
        {}};
    std::vector<fs::path> lessons;
    std::error_code error;
    for (const auto &entry : fs::directory_iterator(course_folder / "exercises", error))
        if (is_chapter_name(entry.path().filename().string()) && fs::exists(entry.path() / "README.md"))
            lessons.push_back(entry.path() / "README.md");
    std::ranges::sort(lessons);
    for (const fs::path &lesson : lessons) {
        const std::string name = lesson.parent_path().filename().string(), heading = heading_of(read_text(lesson));
        section.list.push_back({address_from(out_folder, lesson),
                                name.substr(0, 2) + " " + (heading.empty() ? in_words(name.substr(3)) : heading)});
    }
    return section;
}

} // namespace

PictureRecord read_record(const fs::path &file) {
    const Json json = read_json(file);
    PictureRecord record;
    try {
        json.at("chapter").get_to(record.chapter);
        json.at("summary").get_to(record.summary);
        const auto number = [&](const char *name, double lowest, double highest) {
            const Json &value = json.at(name);
            const double n = value.is_number() ? value.get<double>() : std::nan("");
            if (!(n >= lowest && n <= highest))
                throw InputError(file.string(), std::string("\"") + name + "\" makes no sense: " + value.dump());
            return n;
        };
        record.width = static_cast<int>(number("width", 1, 1e6));
        record.height = static_cast<int>(number("height", 1, 1e6));
        record.threads = static_cast<int>(number("threads", 1, 1e6));
        record.seconds = number("seconds", 0, 1e12);
        record.rays = static_cast<std::uint64_t>(number("rays", 0, 1e18));
        record.machine = json.value("machine", std::string());
    } catch (const Json::exception &) {
        throw InputError(file.string(), "is not the record of a picture");
    }
    return record;
}

Gallery read_gallery(const fs::path &course_folder, const fs::path &out_folder) {
    if (!fs::is_directory(course_folder / "chapters"))
        throw InputError(course_folder.string(), "holds no chapters: is it the course's folder?");
    if (!fs::is_directory(out_folder))
        throw InputError(out_folder.string(), "is not a folder");

    std::vector<fs::path> folders;
    for (const auto &entry : fs::directory_iterator(course_folder / "chapters"))
        if (is_chapter_name(entry.path().filename().string()) && fs::exists(entry.path() / "main.cpp"))
            folders.push_back(entry.path());
    std::ranges::sort(folders);

    Gallery gallery;
    for (const fs::path &folder : folders)
        gallery.chapters.push_back(read_chapter(folder, out_folder));
    const std::array sections{
        report_section("accuracy", "Speed against error",
                       "The intersection tests on hard cases, each judged against exact arithmetic: how often it is "
                       "wrong, and what a test costs.",
                       out_folder),
        report_section("compare", "Acceleration structures side by side",
                       "Every structure on every scene with the same rays. A figure counts only after each ray's hit "
                       "was found to be the same as without any structure.",
                       out_folder),
        report_section("claims", "Claims, measured",
                       "What lecture notes say about ray tracing, and what came out when it was measured.", out_folder),
        report_section("gpu", "On the GPU", "The fragment-shader tracer against the other ways to the same picture.",
                       out_folder),
        slides_section(out_folder),
        exercises_section(course_folder, out_folder)};
    for (const GallerySection &section : sections)
        if (!section.findings.empty() || !section.list.empty())
            gallery.sections.push_back(section);
    return gallery;
}

Gallery write_gallery(const fs::path &course_folder, const fs::path &out_folder) {
    const Gallery gallery = read_gallery(course_folder, out_folder);
    const fs::path parts = course_folder / "common" / "gallery";
    write_text(out_folder / "index.html",
               gallery_page(gallery, read_text(parts / "style.css"), read_text(parts / "page.js")));
    return gallery;
}

} // namespace course
