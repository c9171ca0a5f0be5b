#include "common/gallery.hpp"
#include "common/html.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace course {
namespace {

using html::Attributes;
using html::element;
using html::escaped;
using html::link;

// Beyond this, a table on the page would be slower than the file that it comes from.
constexpr std::size_t most_rows = 600;

// ---- figures in words -----------------------------------------------------------------------------------------------

std::string formatted(const char *format, double number) {
    char text[64];
    std::snprintf(text, sizeof text, format, number);
    return text;
}

// 1234567 as 1,234,567.
std::string grouped(std::uint64_t number) {
    std::string digits = std::to_string(number);
    for (std::size_t at = digits.size(); at > 3; at -= 3)
        digits.insert(at - 3, ",");
    return digits;
}

std::string duration(double seconds) {
    if (seconds < 1)
        return formatted("%.0f ms", 1000 * seconds);
    return seconds < 60 ? formatted("%.2f s", seconds) : formatted("%.1f min", seconds / 60);
}

std::string rays_per_second(const PictureRecord &record) {
    if (!(record.seconds > 0))
        return "not measured";
    const double rate = static_cast<double>(record.rays) / record.seconds;
    return rate < 1e5 ? grouped(static_cast<std::uint64_t>(rate)) : formatted("%.2f million", rate / 1e6);
}

std::string counted(std::size_t count, const std::string &one, const std::string &many) {
    return std::to_string(count) + " " + (count == 1 ? one : many);
}

std::string shown(const Value &value) {
    if (const auto *number = std::get_if<double>(&value))
        return formatted("%.4g", *number);
    if (const auto *whole = std::get_if<std::int64_t>(&value))
        return std::to_string(*whole);
    if (const auto *answer = std::get_if<bool>(&value))
        return *answer ? "yes" : "no";
    return std::get<std::string>(value);
}

std::string text_of(const Row &row, const std::string &name) {
    const Value *value = row.find(name);
    return value ? shown(*value) : std::string();
}

std::string spaced(std::string name) {
    std::ranges::replace(name, '_', ' ');
    return name;
}

// A sentence in which `words` between backticks are code.
std::string prose(const std::string &text) {
    std::string result;
    bool code = false;
    for (std::size_t from = 0; from <= text.size(); code = !code) {
        const std::size_t to = std::min(text.find('`', from), text.size());
        const std::string part = escaped(text.substr(from, to - from));
        result += code ? element("code", part) : part;
        from = to + 1;
    }
    return result;
}

std::string said_of(const GalleryChapter &chapter) { return "chapter " + chapter.number + ", " + chapter.title; }

// ---- plots and tables -----------------------------------------------------------------------------------------------

std::string figure(const GalleryFigure &shown_figure) {
    const std::string picture = element(
        "img",
        {{"src", shown_figure.address}, {"alt", shown_figure.description}, {"loading", "lazy"}, {"decoding", "async"}});
    return element("figure", {{"class", "plot"}},
                   element("a", {{"href", shown_figure.address}}, picture) +
                       element("figcaption", escaped(shown_figure.caption)));
}

std::string table_body(const std::vector<Row> &rows, const std::vector<std::string> &columns) {
    std::string body;
    for (std::size_t i = 0; i < std::min(rows.size(), most_rows); ++i) {
        std::string cells;
        for (const std::string &column : columns) {
            const Value *value = rows[i].find(column);
            const bool number =
                value && (std::holds_alternative<double>(*value) || std::holds_alternative<std::int64_t>(*value));
            cells += element("td", number ? Attributes{{"class", "number"}} : Attributes{},
                             value ? escaped(shown(*value)) : "");
        }
        body += element("tr", cells) + "\n";
    }
    return body;
}

std::string table(const GalleryTable &shown_table) {
    std::vector<std::string> columns;
    for (const Row &row : shown_table.rows)
        for (const auto &[name, value] : row.values())
            if (std::ranges::find(columns, name) == columns.end())
                columns.push_back(name);
    std::string heads;
    for (const std::string &column : columns)
        heads += element("th", {{"scope", "col"}}, escaped(spaced(column)));

    const std::size_t count = shown_table.rows.size();
    std::string summary = shown_table.caption + ": " + counted(count, "row", "rows");
    if (count > most_rows)
        summary += ", the first " + std::to_string(most_rows) + " of them here";
    const std::string grid = element("table", element("thead", element("tr", heads)) +
                                                  element("tbody", table_body(shown_table.rows, columns)));
    const std::string machine = shown_table.machine.empty() ? ""
                                                            : element("p", {{"class", "machine"}},
                                                                      escaped("Measured on " + shown_table.machine));
    return element("details", element("summary", escaped(summary)) + machine +
                                  element("div",
                                          {{"class", "scroll"},
                                           {"role", "region"},
                                           {"tabindex", "0"},
                                           {"aria-label", shown_table.caption}},
                                          grid)) +
           "\n";
}

std::string findings_html(const Findings &findings, bool with_tables = true) {
    std::string figures, result;
    for (const GalleryFigure &each : findings.figures)
        figures += figure(each) + "\n";
    if (!figures.empty())
        result += element("div", {{"class", "plots"}}, figures);
    if (with_tables)
        for (const GalleryTable &each : findings.tables)
            result += table(each);
    std::string files;
    for (const GalleryLink &each : findings.files)
        files += " " + link(each.address, each.text);
    if (!files.empty())
        result += element("p", {{"class", "files"}}, "Files:" + files);
    return result;
}

// ---- chapters -------------------------------------------------------------------------------------------------------

std::string tile(const GalleryChapter &chapter) {
    const std::string picture = chapter.record
                                    ? element("img", {{"src", chapter.picture}, {"alt", ""}, {"decoding", "async"}})
                                    : element("span", {{"class", "blank"}}, "not rendered yet");
    return element("li", element("a", {{"href", "#chapter-" + chapter.number}},
                                 element("span", {{"class", "thumbnail"}}, picture) +
                                     element("span", {{"class", "tile-number"}}, escaped(chapter.number)) + " " +
                                     element("span", {{"class", "tile-title"}}, escaped(chapter.title)))) +
           "\n";
}

std::string fact(const std::string &name, const std::string &value) {
    return element("div", element("dt", name) + element("dd", escaped(value)));
}

std::string facts(const PictureRecord &record) {
    return element("dl", {{"class", "facts"}},
                   fact("Rendered in", duration(record.seconds) + ", " +
                                           counted(static_cast<std::size_t>(record.threads), "thread", "threads")) +
                       fact("Rays per second", rays_per_second(record)) + fact("Rays", grouped(record.rays)) +
                       fact("Pixels", std::to_string(record.width) + " × " + std::to_string(record.height)));
}

std::string picture_element(const GalleryChapter &chapter, const std::string &kind, const std::string &description,
                            bool lazy) {
    Attributes attributes{{"class", kind},
                          {"src", chapter.picture},
                          {"alt", description},
                          {"width", std::to_string(chapter.record->width)},
                          {"height", std::to_string(chapter.record->height)},
                          {"decoding", "async"},
                          {"draggable", "false"}};
    if (lazy)
        attributes.emplace_back("loading", "lazy");
    return element("img", attributes);
}

// The picture, and where an earlier chapter has one too, that one over its left part, as far as the slider says. The
// frame has the shape of the chapter's own picture; the earlier one is fitted into it whole.
std::string picture_figure(const GalleryChapter &chapter, const GalleryChapter *before) {
    const std::string size = std::to_string(chapter.record->width) + " / " + std::to_string(chapter.record->height);
    std::string inside = picture_element(chapter, "after", chapter.description, before != nullptr);
    std::string control;
    if (before) {
        const std::string id = "split-" + chapter.number;
        inside += picture_element(*before, "before", "For comparison, the picture of " + said_of(*before), true) +
                  element("span", {{"class", "divider"}, {"aria-hidden", "true"}});
        control = element("div", {{"class", "control"}},
                          element("label", {{"for", id}}, "Before: " + escaped(said_of(*before))) +
                              element("input", {{"type", "range"},
                                                {"id", id},
                                                {"min", "0"},
                                                {"max", "100"},
                                                {"step", "1"},
                                                {"value", "0"},
                                                {"autocomplete", "off"}}));
    }
    Attributes attributes{{"class", before ? "picture compare" : "picture"}};
    if (before)
        attributes.emplace_back("data-before", said_of(*before));
    return element("figure", attributes,
                   element("div", {{"class", "frame"}, {"style", "aspect-ratio: " + size}}, inside) + control);
}

std::string not_rendered(const GalleryChapter &chapter) {
    return element("div", {{"class", "picture missing"}},
                   element("p", "Not rendered yet. " +
                                    element("code", "./course run " + std::to_string(std::stoi(chapter.number))) +
                                    " makes this picture."));
}

std::string chapter_links(const GalleryChapter &chapter) {
    std::string links;
    if (!chapter.lesson.empty())
        links += element("li", link(chapter.lesson, "Lesson"));
    links += element("li", link(chapter.source, "Source"));
    if (chapter.record)
        links += element("li", link(chapter.picture, "Full size"));
    return element("ul", {{"class", "links"}, {"aria-label", "Chapter " + chapter.number}}, links);
}

std::string chapter_article(const GalleryChapter &chapter, const GalleryChapter *before) {
    const std::string id = "chapter-" + chapter.number;
    const std::string number = element("span", {{"class", "chapter-number"}}, escaped(chapter.number));
    std::string about = element("h3", {{"id", id + "-title"}}, number + " " + escaped(chapter.title));
    if (!chapter.summary.empty())
        about += element("p", {{"class", "summary"}}, escaped(chapter.summary + "."));

    std::string content = element("div", {{"class", "about"}}, about) + "\n";
    content += (chapter.record ? picture_figure(chapter, before) : not_rendered(chapter)) + "\n";
    content +=
        element("div", {{"class", "details"}}, (chapter.record ? facts(*chapter.record) : "") + chapter_links(chapter));
    if (!chapter.findings.empty())
        content += element("div", {{"class", "measured"}},
                           element("h4", "Measured in this chapter") + findings_html(chapter.findings));
    return element("article", {{"class", "chapter"}, {"id", id}, {"aria-labelledby", id + "-title"}}, content) + "\n";
}

// ---- sections -------------------------------------------------------------------------------------------------------

// A sign beside the word, so that no verdict is told by its colour alone.
std::string verdict_sign(const std::string &verdict) {
    return verdict == "holds" ? "✓" : verdict == "fails" ? "✗" : "◐";
}

std::string claims_list(const std::vector<GalleryTable> &tables) {
    std::string items;
    for (const GalleryTable &each : tables)
        for (const Row &row : each.rows) {
            const std::string verdict = text_of(row, "verdict");
            const std::string kind = verdict == "holds" || verdict == "fails" ? verdict : "depends";
            items += element("li", element("p", {{"class", "claim"}},
                                           element("span", {{"class", "claim-id"}}, escaped(text_of(row, "id"))) + " " +
                                               escaped(text_of(row, "claim"))) +
                                       element("p", {{"class", "verdict " + kind}},
                                               element("span", {{"aria-hidden", "true"}}, verdict_sign(verdict)) + " " +
                                                   escaped(verdict)) +
                                       element("p", {{"class", "finding"}}, escaped(text_of(row, "measured")))) +
                     "\n";
        }
    return items.empty() ? "" : element("ul", {{"class", "claims"}}, items);
}

std::string section_html(const GallerySection &section) {
    std::string list;
    for (const GalleryLink &each : section.list)
        list += element("li", link(each.address, each.text)) + "\n";
    const bool claims = section.id == "claims";
    return element("section", {{"id", section.id}, {"aria-labelledby", section.id + "-title"}},
                   element("h2", {{"id", section.id + "-title"}}, escaped(section.heading)) +
                       element("p", {{"class", "lede"}}, prose(section.about)) +
                       (list.empty() ? "" : element("ul", {{"class", "list"}}, list)) +
                       (claims ? claims_list(section.findings.tables) : "") +
                       findings_html(section.findings, !claims)) +
           "\n";
}

// ---- the page -------------------------------------------------------------------------------------------------------

std::string totals(const Gallery &gallery) {
    std::size_t rendered = 0;
    double seconds = 0;
    std::uint64_t rays = 0;
    std::string machine;
    for (const GalleryChapter &chapter : gallery.chapters)
        if (chapter.record) {
            ++rendered;
            seconds += chapter.record->seconds;
            rays += chapter.record->rays;
            machine = chapter.record->machine;
        }
    if (rendered == 0)
        return element("p", {{"class", "totals"}},
                       "Nothing is rendered yet: " + element("code", "./course run") + " makes the pictures.");
    const std::string pictures =
        rendered == gallery.chapters.size()
            ? counted(rendered, "picture", "pictures")
            : std::to_string(rendered) + " of " + counted(gallery.chapters.size(), "picture", "pictures");
    return element("p", {{"class", "totals"}},
                   escaped(pictures + " · " + formatted("%.1f", static_cast<double>(rays) / 1e6) +
                           " million rays · rendered in " + duration(seconds) +
                           (machine.empty() ? "" : " · " + machine)));
}

std::string header(const Gallery &gallery) {
    std::string entries = element("li", link("#chapters", "Chapters"));
    for (const GallerySection &section : gallery.sections)
        entries += element("li", link("#" + section.id, section.heading));
    return element(
               "header",
               element("p", {{"class", "kicker"}}, "A course in C++20") +
                   element("h1", "Ray tracing, one idea at a time") +
                   element("p", {{"class", "lede"}},
                           "From one ray per pixel to a tracer that runs on the GPU. Each chapter adds one idea and "
                           "renders a picture with it; every step is measured, speed against error, and the "
                           "intersection tests are judged by exact arithmetic.") +
                   totals(gallery) +
                   (gallery.sections.empty()
                        ? ""
                        : element("nav", {{"aria-label", "Parts of this page"}}, element("ul", entries)))) +
           "\n";
}

std::string chapters_section(const Gallery &gallery) {
    std::string tiles, articles;
    const GalleryChapter *before = nullptr;
    for (const GalleryChapter &chapter : gallery.chapters) {
        tiles += tile(chapter);
        articles += chapter_article(chapter, before);
        if (chapter.record)
            before = &chapter;
    }
    return element("section", {{"id", "chapters"}, {"aria-labelledby", "chapters-title"}},
                   element("h2", {{"id", "chapters-title"}}, "Chapters") +
                       element("nav", {{"aria-label", "Chapters"}}, element("ol", {{"class", "tiles"}}, tiles)) +
                       articles) +
           "\n";
}

} // namespace

std::string gallery_page(const Gallery &gallery, const std::string &style, const std::string &script) {
    std::string sections;
    for (const GallerySection &section : gallery.sections)
        sections += section_html(section);
    const std::string head =
        element("meta", {{"charset", "utf-8"}}) + "\n" +
        element("meta", {{"name", "viewport"}, {"content", "width=device-width, initial-scale=1"}}) + "\n" +
        element("meta", {{"name", "color-scheme"}, {"content", "light dark"}}) + "\n" +
        element("title", "Ray tracing, one idea at a time") + "\n" +
        element("link", {{"rel", "icon"}, {"href", "data:,"}}) + "\n" + element("style", "\n" + style) + "\n";
    const std::string body =
        element("a", {{"class", "skip"}, {"href", "#content"}}, "Skip to the chapters") + "\n" + header(gallery) +
        element("main", {{"id", "content"}, {"tabindex", "-1"}}, chapters_section(gallery) + sections) + "\n" +
        element("footer", element("p", "Written by the course's own programs from what they rendered and measured. " +
                                           link("#top", "Back to the top"))) +
        "\n" + element("script", "\n" + script) + "\n";
    return "<!doctype html>\n" +
           element("html", {{"lang", "en"}, {"id", "top"}},
                   "\n" + element("head", "\n" + head) + "\n" + element("body", "\n" + body) + "\n") +
           "\n";
}

} // namespace course
