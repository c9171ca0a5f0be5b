#include "common/gallery_parts.hpp"
#include "common/gallery_texts.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <sstream>

namespace course::gallery_parts {
namespace {

using gallery_texts::capitalised;
using html::Attributes;
using html::element;
using html::escaped;
using html::link;

// Beyond this, a table on the page would be slower than the file that it comes from.
constexpr std::size_t most_rows = 600;

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

// ---- plots and tables -----------------------------------------------------------------------------------------------

std::string figure(const GalleryFigure &shown_figure) {
    Attributes attributes{
        {"src", shown_figure.address}, {"alt", shown_figure.description}, {"loading", "lazy"}, {"decoding", "async"}};
    if (shown_figure.address.ends_with(
            ".svg")) // drawn on white: the style turns it over for those who read in the dark
        attributes.emplace_back("class", "drawn");
    const std::string picture = element("img", attributes);
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

} // namespace

std::string formatted(const char *format, double number) {
    char text[64];
    std::snprintf(text, sizeof text, format, number);
    return text;
}

std::string counted(std::size_t count, const std::string &one, const std::string &many) {
    return std::to_string(count) + " " + (count == 1 ? one : many);
}

std::string prose(const std::string &text) {
    static constexpr std::pair<char, const char *> marks[]{{'`', "code"}, {'$', "var"}, {'*', "em"}};
    std::string result;
    std::size_t at = 0;
    while (at < text.size()) {
        const std::size_t from = std::min(text.find_first_of("`$*", at), text.size());
        result += escaped(text.substr(at, from - at));
        const std::size_t to = from < text.size() ? text.find(text[from], from + 1) : std::string::npos;
        if (to == std::string::npos || to == from + 1) { // a mark that stands alone
            result += escaped(text.substr(from, to == std::string::npos ? 1 : 2));
            at = std::min(from + (to == std::string::npos ? 1 : 2), text.size());
            continue;
        }
        const auto mark = std::ranges::find(marks, text[from], &std::pair<char, const char *>::first);
        result += element(mark->second, escaped(text.substr(from + 1, to - from - 1)));
        at = to + 1;
    }
    return result;
}

std::string command_html(const std::string &command) {
    std::string words, word;
    std::istringstream each(command);
    while (each >> word)
        words += (words.empty() ? "" : " ") + element("span", escaped(word));
    return element("code", {{"class", "command"}}, words);
}

std::string findings_html(const Findings &findings) {
    std::string figures, result;
    for (const GalleryFigure &each : findings.figures)
        figures += figure(each) + "\n";
    if (!figures.empty())
        result += element("div", {{"class", "plots"}}, figures);
    for (const GalleryTable &each : findings.tables)
        result += table(each);
    std::string files;
    for (const GalleryLink &each : findings.files)
        files += " " + link(each.address, each.text);
    if (!files.empty())
        result += element("p", {{"class", "files"}}, "Files:" + files);
    return result;
}

// ---- claims ---------------------------------------------------------------------------------------------------------

namespace {

// What a claim of the report says; the sign beside the word means that no verdict is told by its colour alone.
struct Verdict {
    const char *kind, *sign, *words;
};
constexpr Verdict verdicts[]{{"holds", "✓", "hold"}, {"fails", "✗", "fail"}, {"depends", "◐", "depend"}};

const Verdict &verdict_of(const Row &row) {
    const std::string said = text_of(row, "verdict");
    return *std::ranges::find_if(verdicts,
                                 [&](const Verdict &each) { return said == each.kind || &each == &verdicts[2]; });
}

std::string verdict_html(const Verdict &verdict, const std::string &words) {
    return element("p", {{"class", std::string("verdict ") + verdict.kind}},
                   element("span", {{"aria-hidden", "true"}}, verdict.sign) + " " + escaped(words));
}

std::string paragraph(const std::string &kind, const std::string &title, const std::string &text) {
    return text.empty() ? ""
                        : element("p", {{"class", kind}},
                                  (title.empty() ? "" : element("strong", escaped(title)) + " ") + prose(text));
}

std::string how_html(const Row &row, const std::string &figure_html) {
    const std::string how = text_of(row, "how"), rule = text_of(row, "holds if");
    if (how.empty() && rule.empty() && figure_html.empty())
        return {};
    return element("details", element("summary", "How " + escaped(text_of(row, "id")) + " was measured") +
                                  paragraph("how", "", capitalised(how) + (how.empty() ? "" : ".")) +
                                  paragraph("how", "It holds if", rule.empty() ? "" : rule + ".") + figure_html);
}

std::string chapter_of_claim(const Row &row, const Gallery &gallery) {
    const std::string name = text_of(row, "chapter");
    const auto chapter = std::ranges::find(gallery.chapters, name, &GalleryChapter::name);
    return name.empty() || chapter == gallery.chapters.end()
               ? std::string()
               : element("p", {{"class", "where"}}, link("#chapter-" + chapter->number, "Chapter " + chapter->number));
}

// Takes the figures that belong to a claim out of the findings: they stand beside it.
std::string claims_list(Findings &findings, const Gallery &gallery) {
    std::string items;
    std::array<std::size_t, std::size(verdicts)> counts{};
    for (const GalleryTable &each : findings.tables)
        for (const Row &row : each.rows) {
            const Verdict &verdict = verdict_of(row);
            ++counts[static_cast<std::size_t>(&verdict - verdicts)];
            const auto own =
                std::ranges::find(findings.figures, html::address(text_of(row, "figure")), &GalleryFigure::address);
            std::string figure_html;
            if (own != findings.figures.end()) {
                figure_html = figure(*own);
                findings.figures.erase(own);
            }
            const std::string id = text_of(row, "id");
            items += element("li", {{"id", "claim-" + id}},
                             element("p", {{"class", "claim-id"}}, escaped(id)) +
                                 element("div", {{"class", "said"}},
                                         paragraph("claim", "", capitalised(text_of(row, "claim"))) +
                                             paragraph("finding", "", capitalised(text_of(row, "measured"))) +
                                             paragraph("finding", "It depends on", text_of(row, "depends on")) +
                                             how_html(row, figure_html)) +
                                 element("div", {{"class", "judged"}},
                                         verdict_html(verdict, verdict.kind) + chapter_of_claim(row, gallery))) +
                     "\n";
        }
    if (items.empty())
        return {};
    std::string total;
    for (std::size_t i = 0; i < counts.size(); ++i)
        total += verdict_html(verdicts[i], std::to_string(counts[i]) + " " + verdicts[i].words);
    return element("div", {{"class", "verdicts"}}, total) + element("ul", {{"class", "claims"}}, items);
}

// ---- slides and exercises -------------------------------------------------------------------------------------------

std::string entry_html(const GalleryEntry &entry) {
    std::string also;
    for (const GalleryLink &each : entry.also)
        also +=
            " " + element("a",
                          {{"href", each.address}, {"class", "also"}, {"aria-label", entry.title + ", " + each.text}},
                          escaped(each.text));
    return element("li", element("span", {{"class", "entry-number"}}, escaped(entry.number)) +
                             element("div",
                                     element("p", {{"class", "entry-title"}}, link(entry.address, entry.title) + also) +
                                         paragraph("entry-about", "", entry.about) +
                                         (entry.command.empty() ? "" : command_html(entry.command)))) +
           "\n";
}

} // namespace

std::string section_html(const GallerySection &section, const Gallery &gallery) {
    Findings findings = section.findings;
    std::string content;
    if (section.id == "claims") {
        content = claims_list(findings, gallery);
        if (!content.empty())
            findings.tables.clear();
    }
    std::string entries;
    for (const GalleryEntry &each : section.list)
        entries += entry_html(each);
    if (!entries.empty())
        content += element("ol", {{"class", "entries " + section.id}}, entries);
    const std::string title = section.id + "-title";
    return element("section", {{"id", section.id}, {"aria-labelledby", title}},
                   element("h2", {{"id", title}}, escaped(section.heading)) +
                       element("p", {{"class", "lede"}}, prose(section.about)) +
                       (section.made ? ""
                                     : element("p", {{"class", "missing"}},
                                               element("span", (section.list.empty() ? "Not made yet. " : "") +
                                                                   prose(section.making)))) +
                       content + findings_html(findings)) +
           "\n";
}

} // namespace course::gallery_parts
