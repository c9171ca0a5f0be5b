#include "common/errors.hpp"
#include "common/gallery.hpp"
#include "common/gallery_texts.hpp"
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
using namespace gallery_texts;
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
        chapter.question = paragraph_of(lesson, "**The question.**");
        chapter.minutes = minutes_of(lesson);
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

GallerySection report_section(GallerySection section, const fs::path &out_folder) {
    for (const fs::path &file : files_of(out_folder)) {
        const std::string stem = file.stem().string();
        if (stem == section.id)
            add_finding(section.findings, file, section.heading, out_folder);
        else if (stem.starts_with(section.id + "_"))
            add_finding(section.findings, file, stem.substr(section.id.size() + 1), out_folder);
    }
    section.made = !section.findings.empty();
    return section;
}

// Every deck: the page that was built from it, or else its source, which can be read as it is.
GallerySection slides_section(const fs::path &course_folder, const fs::path &out_folder) {
    GallerySection section{.id = "slides",
                           .short_heading = "Slides",
                           .heading = "Slides",
                           .about = "A deck for each chapter, made of the pictures, plots and tables that the programs "
                                    "made, with notes for the speaker.",
                           .making = "These are the sources. `./course slides` makes the decks of them, as pages for a "
                                     "browser and as PDF."};
    const fs::path built = out_folder / "slides";
    for (const fs::path &source : files_of(course_folder / "slides")) {
        if (source.extension() != ".md")
            continue;
        const std::string text = read_text(source), name = source.stem().string();
        GalleryEntry deck;
        deck.number = name.substr(0, 2);
        deck.title = heading_of("# " + front_matter_of(text, "title"));
        if (deck.title.empty())
            deck.title = in_words(name);
        deck.about = front_matter_of(text, "description");
        const bool is_built = fs::exists(built / (name + ".html"));
        deck.address = address_from(out_folder, is_built ? built / (name + ".html") : source);
        if (is_built && fs::exists(built / (name + ".pdf")))
            deck.also.push_back({address_from(out_folder, built / (name + ".pdf")), "PDF"});
        section.made |= is_built;
        section.list.push_back(std::move(deck));
    }
    if (section.made && fs::exists(built / "index.html"))
        section.findings.files.push_back(
            {address_from(out_folder, built / "index.html"), "All decks with their covers"});
    return section;
}

GallerySection exercises_section(const fs::path &course_folder, const fs::path &out_folder) {
    GallerySection section{.id = "exercises",
                           .short_heading = "Exercises",
                           .heading = "Exercises",
                           .about =
                               "You write the heart of a lesson; one command grades it and says what is wrong, and "
                               "why. `./course exercise list` shows how far you are.",
                           .made = true};
    std::vector<fs::path> tasks;
    std::error_code error;
    for (const auto &entry : fs::directory_iterator(course_folder / "exercises", error))
        if (is_chapter_name(entry.path().filename().string()) && fs::exists(entry.path() / "README.md"))
            tasks.push_back(entry.path() / "README.md");
    std::ranges::sort(tasks);
    for (const fs::path &task : tasks) {
        const std::string name = task.parent_path().filename().string(), text = read_text(task),
                          heading = heading_of(text);
        section.list.push_back({.number = name.substr(0, 2),
                                .address = address_from(out_folder, task),
                                .title = heading.empty() ? in_words(name.substr(3)) : heading,
                                .about = paragraph_of(text),
                                .command = "./course exercise " + name});
    }
    return section;
}

// The first picture of the README: it shows what the course comes to.
GalleryFigure cover_of(const fs::path &course_folder, const fs::path &out_folder) {
    if (!fs::exists(course_folder / "README.md"))
        return {};
    const std::string readme = read_text(course_folder / "README.md"), words = between(readme, "![", "](");
    const fs::path picture = course_folder / between(readme, "![" + words + "](", ")");
    return fs::is_regular_file(picture) ? GalleryFigure{address_from(out_folder, picture), words, words}
                                        : GalleryFigure{};
}

// The chapter's slides and exercises, so that each is one step away from it.
void link_to(GalleryChapter &chapter, const GallerySection &section, const std::string &word) {
    for (const GalleryEntry &entry : section.list)
        if (entry.number == chapter.number)
            chapter.links.push_back({entry.address, word.empty() ? "Exercise: " + entry.title : word});
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
    gallery.sections = {
        report_section({.id = "accuracy",
                        .short_heading = "Accuracy",
                        .heading = "Speed against error",
                        .about =
                            "The intersection tests on hard cases, each judged by exact arithmetic: how often it is "
                            "wrong, and what a test costs. The further left and down a point, the better.",
                        .making = "`./course accuracy --quick` makes this part, in a minute or two."},
                       out_folder),
        report_section({.id = "compare",
                        .short_heading = "Comparison",
                        .heading = "Acceleration structures side by side",
                        .about = "Every structure on every scene with the same rays. A figure counts only after each "
                                 "ray's hit was found to be the same as without any structure.",
                        .making = "`./course compare --quick` makes this part, in two or three minutes."},
                       out_folder),
        report_section(
            {.id = "claims",
             .short_heading = "Claims",
             .heading = "Claims, measured",
             .about = "What three lecture notes say about ray tracing, and what came out when it was measured.",
             .making = "`./course claims --quick` makes this part, in about a minute."},
            out_folder),
        report_section({.id = "gpu",
                        .short_heading = "GPU",
                        .heading = "On the GPU",
                        .about = "The tracer as a fragment shader, beside the other ways to the same picture. Whoever "
                                 "drew is named in the table: the processor's own cores can speak OpenGL, too.",
                        .making = "`./course run 17 --measure` makes this part, in less than a minute."},
                       out_folder),
        slides_section(course_folder, out_folder),
        exercises_section(course_folder, out_folder)};
    gallery.cover = cover_of(course_folder, out_folder);
    for (GalleryChapter &chapter : gallery.chapters) {
        link_to(chapter, gallery.sections[4], "Slides");
        link_to(chapter, gallery.sections[5], "");
    }
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
