#include "common/gallery_parts.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace course {
namespace {

using namespace gallery_parts;
using html::Attributes;
using html::element;
using html::escaped;
using html::link;

// ---- figures in words -----------------------------------------------------------------------------------------------

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

std::string in_millions(double number) {
    return number < 1e5 ? grouped(static_cast<std::uint64_t>(number)) : formatted("%.2f million", number / 1e6);
}

std::string rays_in_words(const PictureRecord &record) {
    const std::string rays = in_millions(static_cast<double>(record.rays));
    return record.seconds > 0
               ? rays + ", " + in_millions(static_cast<double>(record.rays) / record.seconds) + " a second"
               : rays;
}

std::string said_of(const GalleryChapter &chapter) { return "chapter " + chapter.number + ", " + chapter.title; }

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

std::string facts(const GalleryChapter &chapter) {
    std::string all = chapter.minutes.empty() ? "" : fact("Minutes", chapter.minutes);
    if (const auto &record = chapter.record)
        all += fact("Rendered in", duration(record->seconds) + ", " +
                                       counted(static_cast<std::size_t>(record->threads), "thread", "threads")) +
               fact("Rays", rays_in_words(*record)) +
               fact("Pixels", std::to_string(record->width) + " × " + std::to_string(record->height));
    return all.empty() ? "" : element("dl", {{"class", "facts"}}, all);
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
    for (const GalleryLink &each : chapter.links)
        links += element("li", link(each.address, each.text));
    links += element("li", link(chapter.source, "Source"));
    if (chapter.record)
        links += element("li", link(chapter.picture, "Full size"));
    return element("ul", {{"class", "links"}, {"aria-label", "Chapter " + chapter.number}}, links);
}

std::string chapter_article(const GalleryChapter &chapter, const GalleryChapter *before) {
    const std::string id = "chapter-" + chapter.number;
    const std::string number = element("span", {{"class", "chapter-number"}}, escaped(chapter.number));
    std::string about = element("h3", {{"id", id + "-title"}}, number + " " + escaped(chapter.title));
    if (!chapter.question.empty())
        about += element("p", {{"class", "summary"}}, prose(chapter.question));
    else if (!chapter.summary.empty())
        about += element("p", {{"class", "summary"}}, escaped(chapter.summary + "."));

    std::string content = element("div", {{"class", "about"}}, about) + "\n";
    content += (chapter.record ? picture_figure(chapter, before) : not_rendered(chapter)) + "\n";
    content += element("div", {{"class", "details"}}, chapter_links(chapter) + facts(chapter)) + "\n";
    if (!chapter.findings.empty())
        content += element("div", {{"class", "measured"}},
                           element("h4", "Measured in this chapter") + findings_html(chapter.findings));
    return element("article", {{"class", "chapter"}, {"id", id}, {"aria-labelledby", id + "-title"}}, content) + "\n";
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
    const std::string cover = gallery.cover.address.empty() ? ""
                                                            : element("img", {{"class", "cover"},
                                                                              {"src", gallery.cover.address},
                                                                              {"alt", gallery.cover.description},
                                                                              {"decoding", "async"}});
    return element("header", {{"class", "head"}},
                   element("div", element("p", {{"class", "kicker"}}, "A course in C++20") +
                                      element("h1", "Ray tracing, one idea at a time") +
                                      element("p", {{"class", "lede"}},
                                              "From one ray per pixel to a tracer that runs on the GPU. Each chapter "
                                              "adds one idea and renders a picture with it; every step is measured, "
                                              "speed against error, and the intersection tests are judged by exact "
                                              "arithmetic.") +
                                      totals(gallery)) +
                       cover) +
           "\n";
}

// Stays in sight on wide windows, so that every part is one step away.
std::string parts(const Gallery &gallery) {
    std::string entries = element("li", link("#chapters", "Chapters"));
    for (const GallerySection &section : gallery.sections)
        entries += element("li", link("#" + section.id, section.short_heading));
    return element("nav", {{"class", "parts"}, {"aria-label", "Parts of this page"}}, element("ul", entries)) + "\n";
}

std::string door(const std::string &name, const std::string &words, const std::string &command,
                 const std::string &way) {
    return element("li", element("h3", name) + element("p", words) + command_html(command) +
                             element("p", {{"class", "way"}}, way));
}

// Four ways in, for the four kinds of people who come.
std::string doors(const Gallery &gallery) {
    const std::string lesson = gallery.chapters.empty() ? "" : gallery.chapters.front().lesson;
    return element(
               "section", {{"id", "start"}, {"aria-labelledby", "start-title"}},
               element("h2", {{"id", "start-title"}}, "Where to begin") +
                   element("ul", {{"class", "doors"}},
                           door("To learn", "Read the lessons in order, and do the exercise at the end of each.",
                                "./course exercise list",
                                lesson.empty() ? link("#chapters", "The chapters") : link(lesson, "The first lesson")) +
                               door("To teach", "A deck for each chapter, and a whole class graded by one command.",
                                    "./course exercise grade FOLDER", link("#slides", "The slides")) +
                               door("To compare", "Acceleration structures on your own mesh, beside Embree and CGAL.",
                                    "./course compare --mesh FILE", link("#compare", "The comparison")) +
                               door("To check",
                                    "Your own intersection code on hard cases that exact arithmetic decides.",
                                    "./course accuracy --kernel FILE", link("#accuracy", "Speed against error")))) +
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
        sections += section_html(section, gallery);
    const std::string head =
        element("meta", {{"charset", "utf-8"}}) + "\n" +
        element("meta", {{"name", "viewport"}, {"content", "width=device-width, initial-scale=1"}}) + "\n" +
        element("meta", {{"name", "color-scheme"}, {"content", "light dark"}}) + "\n" +
        element("title", "Ray tracing, one idea at a time") + "\n" +
        element("link", {{"rel", "icon"}, {"href", "data:,"}}) + "\n" + element("style", "\n" + style) + "\n";
    const std::string body =
        element("a", {{"class", "skip"}, {"href", "#content"}}, "Skip to the content") + "\n" + header(gallery) +
        parts(gallery) +
        element("main", {{"id", "content"}, {"tabindex", "-1"}},
                doors(gallery) + chapters_section(gallery) + sections) +
        "\n" +
        element("footer", element("p", "Written by the course's own programs from what they rendered and measured. " +
                                           link("#top", "Back to the top"))) +
        "\n" + element("script", "\n" + script) + "\n";
    return "<!doctype html>\n" +
           element("html", {{"lang", "en"}, {"id", "top"}},
                   "\n" + element("head", "\n" + head) + "\n" + element("body", "\n" + body) + "\n") +
           "\n";
}

} // namespace course
