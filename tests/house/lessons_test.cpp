// The lessons quote the code as it is: every listing stands in a source file, every picture and link leads somewhere.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using Lines = std::vector<std::string>;

Lines lines_of(const fs::path &file) {
    Lines lines;
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);)
        lines.push_back(line);
    return lines;
}

std::string trimmed(const std::string &line) {
    const auto first = line.find_first_not_of(" \t"), last = line.find_last_not_of(" \t\r");
    return first == std::string::npos ? "" : line.substr(first, last - first + 1);
}

// Every text of the course that a reader follows.
std::vector<fs::path> lessons() {
    std::vector<fs::path> found{"README.md"};
    for (const char *folder : {"chapters", "tests", "exercises", "common", "shaders", "slides"})
        if (fs::exists(folder))
            for (const auto &entry : fs::recursive_directory_iterator(folder))
                if (entry.path().extension() == ".md" &&
                    entry.path().string().find("node_modules") == std::string::npos)
                    found.push_back(entry.path());
    return found;
}

struct Listing {
    std::size_t line;
    std::string source; // what <!-- from ... --> names, empty when nothing does
    Lines code;
};

std::vector<Listing> listings_of(const Lines &text) {
    std::vector<Listing> listings;
    const std::regex from("<!-- from ([^ ]+) -->");
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != "```cpp" && text[i] != "```glsl")
            continue;
        Listing listing{i + 1, "", {}};
        std::smatch match;
        if (i > 0 && std::regex_match(text[i - 1], match, from))
            listing.source = match[1];
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

TEST(Lessons, EveryListingStandsInTheSource) {
    std::size_t count = 0;
    for (const fs::path &lesson : lessons())
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

TEST(Lessons, EveryLinkAndPictureLeadsSomewhere) {
    const std::regex link(R"(\]\(([^)#\s]+)(#[^)]*)?\))");
    for (const fs::path &lesson : lessons()) {
        bool in_code = false;
        for (const std::string &line : lines_of(lesson)) {
            if (line.starts_with("```"))
                in_code = !in_code;
            if (in_code)
                continue;
            for (std::sregex_iterator match(line.begin(), line.end(), link), end; match != end; ++match) {
                const std::string target = (*match)[1];
                if (target.starts_with("http") || target.find("out/") != std::string::npos)
                    continue; // other people's pages, and what the programs will write
                EXPECT_TRUE(fs::exists(lesson.parent_path() / target)) << lesson.string() << ": " << target;
            }
        }
    }
}

TEST(Lessons, EveryChapterHasALessonAndAPicture) {
    for (const auto &entry : fs::directory_iterator("chapters")) {
        if (!fs::exists(entry.path() / "main.cpp"))
            continue;
        EXPECT_TRUE(fs::exists(entry.path() / "README.md")) << entry.path() << " has no lesson";
        EXPECT_TRUE(fs::exists(entry.path() / "picture.png")) << entry.path() << " has no picture";
    }
}

TEST(Lessons, TheReadmeLeadsToEveryChapter) {
    std::ostringstream readme;
    readme << std::ifstream("README.md").rdbuf();
    for (const auto &entry : fs::directory_iterator("chapters"))
        if (fs::exists(entry.path() / "main.cpp")) {
            EXPECT_NE(readme.str().find("(" + entry.path().string() + "/README.md)"), std::string::npos)
                << "README.md does not lead to " << entry.path();
        }
}

} // namespace
