// The decks: not too long and not too short, with notes for the teacher, and without anything that is not there.
// (That a listing stands in the source is lessons_test's business, for decks as for lessons.)
#include "tests/house/pattern.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using texts::Found;
using texts::Pattern;

std::string text_of(const fs::path &file) {
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<fs::path> decks() {
    std::vector<fs::path> found;
    for (const auto &entry : fs::directory_iterator("slides"))
        if (entry.path().extension() == ".md")
            found.push_back(entry.path());
    std::ranges::sort(found);
    return found;
}

// The slides of a deck, without the front matter: what stands between lines of three dashes outside of listings.
std::vector<std::string> slides_of(const fs::path &deck) {
    std::vector<std::string> slides(1);
    bool in_code = false;
    std::istringstream text(text_of(deck));
    for (std::string line; std::getline(text, line);) {
        in_code ^= line.starts_with("```");
        if (line == "---" && !in_code)
            slides.emplace_back();
        else
            slides.back() += line + "\n";
    }
    slides.erase(slides.begin(), slides.begin() + std::min<std::ptrdiff_t>(2, std::ssize(slides)));
    return slides;
}

// What stands between <!-- and -->: notes, and directives to Marp or to slides/marp.config.mjs.
std::vector<std::string> comments_of(const std::string &slide) {
    std::vector<std::string> found;
    for (auto at = slide.find("<!--"); at != std::string::npos; at = slide.find("<!--", at + 4))
        found.push_back(slide.substr(at + 4, slide.find("-->", at) - at - 4));
    return found;
}

bool is_directive(const std::string &comment) {
    const std::vector<std::string> beginnings{" _", " from ", " table from ", " exercises "};
    return std::ranges::any_of(beginnings,
                               [&](const std::string &beginning) { return comment.starts_with(beginning); });
}

std::string trimmed(const std::string &text) { return Pattern("[*`$]|^\\s+|\\s+$").replaced_in(text, ""); }

std::vector<std::string> split(const std::string &text, char at) {
    std::vector<std::string> parts;
    std::istringstream in(text);
    for (std::string part; std::getline(in, part, at);)
        parts.push_back(trimmed(part));
    return parts;
}

// Whether a table of the file has all the columns, and all the rows (named by their first cell).
bool has_table(const fs::path &file, const std::vector<std::string> &columns, const std::vector<std::string> &rows) {
    std::istringstream text(text_of(file));
    const auto holds = [](const auto &all) {
        return [&all](const std::string &one) { return std::ranges::count(all, one) > 0; };
    };
    for (std::string line; std::getline(text, line);) {
        const auto head = split(line, '|');
        if (!line.starts_with("|") || !std::ranges::all_of(columns, holds(head)))
            continue;
        std::vector<std::string> first_cells;
        while (std::getline(text, line) && line.starts_with("|"))
            if (const auto cells = split(line, '|'); cells.size() > 1)
                first_cells.push_back(cells[1]);
        return std::ranges::all_of(rows, holds(first_cells));
    }
    return false;
}

// Whether some program of the course holds the text.
bool a_program_says(const std::string &text) {
    static const std::vector<std::string> sources = [] {
        std::vector<std::string> found;
        for (const char *folder : {"chapters", "tests", "common"})
            for (const auto &entry : fs::recursive_directory_iterator(folder))
                if (const auto ending = entry.path().extension(); ending == ".cpp" || ending == ".hpp")
                    found.push_back(text_of(entry.path()));
        return found;
    }();
    return std::ranges::any_of(sources, [&](const auto &source) { return source.find(text) != std::string::npos; });
}

// Whether a program writes the plot: report_what.svg is made by base + "_what.svg", or by "report_" + the name "what".
bool is_written(const fs::path &plot) {
    const std::string stem = plot.stem();
    const auto cut = stem.find('_') + 1;
    const std::string report = stem.substr(0, cut);
    std::string what = stem.substr(cut);
    if (a_program_says("\"_" + what + ".svg\""))
        return true;
    std::ranges::replace(what, '_', ' ');
    return a_program_says("\"" + report + "\"") && a_program_says("\"" + what + "\"");
}

TEST(Slides, EveryChapterHasADeck) {
    EXPECT_TRUE(fs::exists("slides/00_opening.md"));
    for (const auto &entry : fs::directory_iterator("chapters")) {
        const std::string deck = "slides/" + entry.path().filename().string() + ".md";
        EXPECT_TRUE(fs::exists(deck) || !fs::exists(entry.path() / "main.cpp")) << "there is no " << deck;
    }
}

TEST(Slides, ADeckHasEightToFifteen) {
    ASSERT_FALSE(decks().empty());
    for (const fs::path &deck : decks()) {
        EXPECT_GE(slides_of(deck).size(), 8u) << deck;
        EXPECT_LE(slides_of(deck).size(), 15u) << deck;
    }
}

TEST(Slides, EverySlideHasNotesForTheTeacher) {
    for (const fs::path &deck : decks()) {
        int number = 0;
        for (const std::string &slide : slides_of(deck)) {
            ++number;
            std::ptrdiff_t words = 0;
            for (const std::string &comment : comments_of(slide))
                if (!is_directive(comment)) {
                    std::istringstream in(comment);
                    words += std::distance(std::istream_iterator<std::string>(in), {});
                }
            EXPECT_GE(words, 20) << deck << ", slide " << number << ": too little for the teacher to go by";
        }
    }
}

TEST(Slides, EveryPictureIsThereOrIsMadeByACommand) {
    const Pattern picture(R"re(!\[[^\]]*\]\(([^)\s]+)\s*("([^"]*)")?\s*\))re");
    for (const fs::path &deck : decks()) {
        const std::string text = text_of(deck);
        for (const Found &match : picture.all_in(text)) {
            const std::string path = match[1], command = match[3];
            if (!path.starts_with("../out/")) {
                EXPECT_TRUE(fs::exists(deck.parent_path() / path)) << deck << ": " << path;
                continue;
            }
            EXPECT_TRUE(command.starts_with("./course ")) << deck << ": " << path << " does not say what makes it";
            EXPECT_TRUE(is_written(path)) << deck << ": no program writes " << path;
        }
    }
}

TEST(Slides, EveryTableStandsInItsLesson) {
    const Pattern table("<!-- table from (\\S+): ([^;\n]+?)(; rows ([^\n]+?))? -->");
    for (const fs::path &deck : decks()) {
        const std::string text = text_of(deck);
        EXPECT_EQ(table.all_in(text).size(), Pattern("<!-- table").all_in(text).size()) << deck;
        for (const Found &match : table.all_in(text))
            EXPECT_TRUE(has_table(match[1], split(match[2], '|'), split(match[4], '|'))) << deck << ": " << match[0];
    }
}

TEST(Slides, NothingIsFetched) {
    for (const auto &entry : fs::directory_iterator("slides")) {
        const auto ending = entry.path().extension();
        if (ending == ".md" || ending == ".css" || ending == ".mjs") {
            EXPECT_EQ(text_of(entry.path()).find("://"), std::string::npos) << entry.path();
        }
    }
}

} // namespace
