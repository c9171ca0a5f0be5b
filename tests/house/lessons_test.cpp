// The lessons quote the code as it is, have one shape, and lead on: listings, parts in order, exercises, the table of
// chapters, the figures' one language.
#include "tests/house/pattern.hpp"
#include "tests/house/texts.hpp"

#include <gtest/gtest.h>

#include <cctype>
#include <map>
#include <optional>

namespace {

using namespace texts;

struct Listing {
    std::size_t line;
    std::string source; // what <!-- from ... --> names, empty when nothing does
    Lines code;
};

std::vector<Listing> listings_of(const Lines &text) {
    std::vector<Listing> listings;
    const Pattern from("<!-- from ([^ ]+) -->");
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != "```cpp" && text[i] != "```glsl")
            continue;
        Listing listing{i + 1, "", {}};
        if (const Found found = i > 0 ? from.match(text[i - 1]) : Found{}; !found.empty())
            listing.source = found[1];
        for (++i; i < text.size() && text[i] != "```"; ++i)
            listing.code.push_back(trimmed(text[i]));
        listings.push_back(listing);
    }
    return listings;
}

bool stands_in(const Lines &code, const fs::path &source) {
    Lines lines = lines_of(source);
    std::ranges::transform(lines, lines.begin(), trimmed);
    return !code.empty() && !std::ranges::search(lines, code).empty();
}

std::optional<fs::path> resolved(const fs::path &lesson, const std::string &name) {
    for (const fs::path &candidate : {lesson.parent_path() / name, fs::path(name)})
        if (fs::exists(candidate))
            return candidate;
    return {};
}

fs::path lesson_of(const std::string &chapter) { return fs::path("chapters") / chapter / "README.md"; }

TEST(Lessons, EveryListingStandsInTheSource) {
    std::size_t count = 0;
    for (const fs::path &lesson : all_texts())
        for (const Listing &listing : listings_of(lines_of(lesson))) {
            ++count;
            const std::string place = lesson.string() + ":" + std::to_string(listing.line);
            const auto source = resolved(lesson, listing.source);
            EXPECT_TRUE(!listing.source.empty() && source) << place << ": no <!-- from FILE --> before the listing";
            if (source) {
                EXPECT_TRUE(stands_in(listing.code, *source)) << place << ": differs from " << source->string();
            }
        }
    EXPECT_GT(count, 0u);
}

TEST(Lessons, EveryChapterHasALessonAndAPicture) {
    for (const std::string &chapter : chapters()) {
        EXPECT_TRUE(fs::exists(lesson_of(chapter))) << chapter << " has no lesson";
        EXPECT_TRUE(fs::exists(fs::path("chapters") / chapter / "picture.png")) << chapter << " has no picture";
    }
}

// CONTRIBUTING.md says what each part is for.
TEST(Lessons, HaveTheirPartsInOrder) {
    const std::vector<std::string> parts{R"(^# [0-9][0-9] · .+)",
                                         R"(^\*\*The question\.\*\* .+)",
                                         R"(^\*\*After this chapter\*\* .+)",
                                         R"(^\*\*Time\.\*\* [0-9]+ minutes to read, [0-9]+ to do\.$)",
                                         R"(^!\[.*)",
                                         R"(^```sh$)",
                                         R"(^## The idea.*)",
                                         R"(^## Hard cases.*)",
                                         R"(^## What it cost.*)",
                                         R"(^## What to try$)",
                                         R"(^## What comes next$)"};
    for (const std::string &chapter : chapters()) {
        const Lines text = lines_of(lesson_of(chapter));
        auto from = text.begin();
        for (const std::string &part : parts) {
            const Pattern pattern(part);
            const auto at =
                std::find_if(from, text.end(), [&](const std::string &line) { return pattern.matches(line); });
            EXPECT_TRUE(at != text.end()) << chapter << ": no part " << part << " where it should stand";
            if (at == text.end())
                break;
            from = at + 1;
        }
        // What begins beyond the last part is an appendix that no other lesson has.
        const auto sections = std::count_if(from, text.end(), [](const auto &line) { return line.starts_with("## "); });
        EXPECT_EQ(sections, 0) << chapter << ": a section after 'What comes next'";
    }
}

TEST(Lessons, ExplainWithAFigureAndLeadOn) {
    const auto all = chapters();
    for (std::size_t i = 0; i < all.size(); ++i) {
        const std::string text = text_of(lesson_of(all[i]));
        EXPECT_NE(text.find("](figure_"), std::string::npos) << all[i] << ": no figure";
        const bool leads_on =
            i + 1 == all.size() ||
            std::any_of(all.begin() + static_cast<long>(i) + 1, all.end(), [&](const std::string &later) {
                return text.find("](../" + later + "/README.md") != std::string::npos;
            });
        EXPECT_TRUE(leads_on) << all[i] << ": no link to a later chapter";
    }
}

// "NN_name" of an exercise must stand in the section Exercise of the lesson of chapter NN.
TEST(Lessons, NameTheirExercises) {
    for (const auto &entry : fs::directory_iterator("exercises")) {
        const std::string name = entry.path().filename().string();
        if (!fs::exists(entry.path() / "test.cpp"))
            continue;
        for (const std::string &chapter : chapters()) {
            if (chapter.substr(0, 2) != name.substr(0, 2))
                continue;
            const std::string text = text_of(lesson_of(chapter));
            const auto section = text.find("\n## Exercise"), next = text.find("\n## What comes next");
            ASSERT_NE(section, std::string::npos) << chapter << " has no section Exercise, and there is " << name;
            EXPECT_LT(section, next) << chapter << ": Exercise stands before What comes next";
            EXPECT_NE(text.substr(section, next - section).find("`./course exercise " + name + "`"), std::string::npos)
                << chapter << ": `./course exercise " << name << "` is not named";
        }
    }
}

// The rows of the table of chapters: what they link to, and their minutes.
std::map<std::string, std::string> table_of_chapters(const fs::path &readme) {
    std::map<std::string, std::string> rows;
    const Pattern row(R"(^\| \d\d \| \[.*\]\(chapters/(\w+)/README\.md\) \| .* \| (\d+, \d+) \|$)");
    for (const std::string &line : lines_of(readme))
        if (const Found found = row.match(line); !found.empty())
            rows[found[1]] = found[2];
    return rows;
}

TEST(Readme, LeadsToEveryChapterAndSaysHowLongItTakes) {
    const Pattern time(R"(\*\*Time\.\*\* ([0-9]+) minutes to read, ([0-9]+) to do\.)");
    for (const char *readme : {"README.md", "README.zh.md"}) {
        const auto rows = table_of_chapters(readme);
        for (const std::string &chapter : chapters()) {
            ASSERT_TRUE(rows.contains(chapter)) << readme << " does not lead to " << chapter;
            const std::string text = text_of(lesson_of(chapter));
            const Found found = time.first_in(text);
            ASSERT_FALSE(found.empty()) << chapter << " does not say how long it takes";
            EXPECT_EQ(rows.at(chapter), found[1] + ", " + found[2]) << readme << ", " << chapter;
        }
    }
}

// A code host reads Markdown before it reads formulas: a backslash before a comma, a brace or a backslash is gone by
// then.
TEST(Lessons, HaveFormulasThatSurviveMarkdown) {
    std::size_t count = 0;
    for (const fs::path &file : all_texts()) {
        if (file.string().starts_with("slides"))
            continue; // Marp reads these
        for (const std::string &line : prose_of(file)) {
            for (std::size_t i = 0; i < line.size(); ++i) {
                count += line[i] == '$';
                const bool lost =
                    line[i] == '\\' && i + 1 < line.size() && std::ispunct(static_cast<unsigned char>(line[i + 1]));
                EXPECT_FALSE(lost || line.substr(i).starts_with("\\operatorname")) << file.string() << ": " << line;
            }
        }
    }
    EXPECT_GT(count, 1000u);
}

// The parts of a text between its headings of the second level, without code and formulas, each with its first line.
std::vector<std::string> sections_of(const fs::path &file) {
    static const Pattern formula(R"(\$\$[^$]*\$\$|\$[^$]*\$)");
    std::vector<std::string> sections{""};
    for (const std::string &line : prose_of(file)) {
        if (line.starts_with("## "))
            sections.emplace_back();
        sections.back() += line + "\n";
    }
    for (std::string &section : sections)
        section = formula.replaced_in(section, " ");
    return sections;
}

// The first time in a text: a figure with a unit, or a column of a table with one. Nothing where there is none.
std::string time_quoted(const std::string &section) {
    static const Pattern time(R"([0-9] (ns|ms|µs|s|seconds?|million/s)\b|\|[^|\n]*\b(ns|ms|seconds)\b[^|\n]*\|)");
    const Found found = time.first_in(section);
    return found.empty() ? "" : found[0];
}

bool says_when_and_where(const std::string &section) {
    static const Pattern when("20[0-9][0-9]-[0-9][0-9]-[0-9][0-9]"), where("Xeon|llvmpipe|machine|GPU");
    return when.occurs_in(section) && where.occurs_in(section);
}

// A time without its date and machine says nothing.
TEST(Figures, OfTimeSayWhenAndOnWhichMachine) {
    std::size_t count = 0;
    std::vector<fs::path> files{"README.md", "README.zh.md"};
    for (const std::string &chapter : chapters())
        files.push_back(lesson_of(chapter));
    for (const fs::path &file : files)
        for (const std::string &section : sections_of(file))
            if (const std::string time = time_quoted(section); !time.empty()) {
                ++count;
                EXPECT_TRUE(says_when_and_where(section))
                    << file.string() << ", " << section.substr(0, section.find('\n')) << ": '" << time
                    << "' needs its date and machine in the same part";
            }
    EXPECT_GT(count, 8u);
}

// What was counted or timed under "What it cost" changes with the code, so it has a date, too.
TEST(Figures, OfCostHaveADate) {
    static const Pattern when("20[0-9][0-9]-[0-9][0-9]-[0-9][0-9]");
    for (const std::string &chapter : chapters())
        for (const std::string &section : sections_of(lesson_of(chapter)))
            if (section.starts_with("## What it cost")) {
                EXPECT_TRUE(when.occurs_in(section)) << chapter;
            }
}

TEST(Figures, TheRulesOfTimeNoticeWhatTheyShould) {
    for (const char *time : {"took 12 ms here", "1.5 seconds", "| ns a test | hits |", "0.63 million/s", "20–30 ns"})
        EXPECT_NE(time_quoted(time), "") << time;
    for (const char *other :
         {"8 samples", "2 shapes", "the 1990s", "69,666 triangles", "| nodes | tests |", "a second core"})
        EXPECT_EQ(time_quoted(other), "") << other;
    EXPECT_TRUE(says_when_and_where("(2026-11-22, one core of a Xeon)"));
    EXPECT_FALSE(says_when_and_where("(2026-11-22)") || says_when_and_where("on a Xeon"));
}

// All figures speak one visual language: one style, a card behind, text as text, nothing fetched.
TEST(Figures, ShareOneLanguage) {
    std::string style, first;
    std::size_t count = 0;
    for (const auto &entry : fs::recursive_directory_iterator("chapters")) {
        const std::string name = entry.path().filename().string();
        if (!name.starts_with("figure_") || entry.path().extension() != ".svg")
            continue;
        if (!fs::exists(entry.path().parent_path() / "README.md"))
            continue; // its lesson is yet to come
        ++count;
        const std::string text = text_of(entry.path()), path = entry.path().string();
        const auto begin = text.find("<style>"), end = text.find("</style>");
        ASSERT_TRUE(begin != std::string::npos && end != std::string::npos) << path << ": no style";
        if (style.empty()) {
            style = text.substr(begin, end - begin);
            first = path;
        }
        EXPECT_EQ(text.substr(begin, end - begin), style) << path << ": another style than " << first;
        for (const char *needed : {"width=\"640\"", "<title ", "<desc ", "class=\"card\"", "<text", "role=\"img\""})
            EXPECT_NE(text.find(needed), std::string::npos) << path << ": no " << needed;
        for (const char *forbidden : {"<image", "href", "@import", "url(", "<script", "fill=\"#", "style=\""})
            EXPECT_EQ(text.find(forbidden), std::string::npos) << path << ": " << forbidden;
        const auto lesson = text_of(entry.path().parent_path() / "README.md");
        EXPECT_NE(lesson.find("(" + name + ")"), std::string::npos) << path << " stands in no lesson";
    }
    EXPECT_GT(count, 0u);
}

} // namespace
