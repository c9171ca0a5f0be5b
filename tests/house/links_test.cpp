// Nothing in the texts leads nowhere: links, pictures, places within a page; and both READMEs say the same.
#include "tests/house/pattern.hpp"
#include "tests/house/texts.hpp"

#include <gtest/gtest.h>

#include <cctype>
#include <set>

namespace {

using namespace texts;

struct Link {
    std::string target, place; // place: what follows #, or nothing
    bool operator==(const Link &) const = default;
};

// The links and pictures outside of code, in order.
std::vector<Link> links_of(const fs::path &file) {
    static const Pattern link(R"(\]\(([^)#\s]*)(#[^)]*)?\))"), in_html(R"re((?:src|href)="([^"#]+)")re");
    std::vector<Link> links;
    for (const std::string &line : prose_of(file))
        for (const Pattern &pattern : {link, in_html})
            for (const Found &found : pattern.all_in(line))
                links.push_back({found[1], found.size() > 2 && !found[2].empty() ? found[2].substr(1) : ""});
    return links;
}

// The name by which code hosts let one link to a heading.
std::string anchor(const std::string &heading) {
    std::string name;
    for (const char c : heading) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte >= 0x80 || std::isalnum(byte) || c == '-' || c == '_')
            name += static_cast<char>(byte < 0x80 ? std::tolower(byte) : byte);
        else if (c == ' ')
            name += '-';
    }
    return name;
}

std::set<std::string> anchors_of(const fs::path &file) {
    std::set<std::string> anchors;
    bool in_code = false;
    for (const std::string &line : lines_of(file)) {
        if (line.starts_with("```"))
            in_code = !in_code;
        if (!in_code && line.starts_with("#"))
            anchors.insert(anchor(line.substr(line.find_first_not_of('#') + 1)));
    }
    return anchors;
}

TEST(Links, LeadSomewhere) {
    std::size_t count = 0;
    for (const fs::path &file : all_texts())
        for (const Link &link : links_of(file)) {
            if (link.target.starts_with("http") || link.target.starts_with("mailto:") ||
                link.target.find("out/") != std::string::npos)
                continue; // other people's pages, and what the programs will write
            ++count;
            const fs::path target = link.target.empty() ? file : file.parent_path() / link.target;
            EXPECT_TRUE(fs::exists(target)) << file.string() << ": " << link.target;
            if (!link.place.empty() && target.extension() == ".md") {
                EXPECT_TRUE(anchors_of(target).contains(link.place))
                    << file.string() << ": no heading '" << link.place << "' in " << target.string();
            }
        }
    EXPECT_GT(count, 100u);
}

// What is the same in every language: the code blocks without their comments, the rows of tables, the links.
struct Skeleton {
    Lines commands;
    std::vector<Link> links;
    std::size_t rows = 0, headings = 0;
};

Skeleton skeleton_of(const fs::path &file) {
    Skeleton skeleton{{}, links_of(file), 0, 0};
    bool in_code = false;
    for (const std::string &line : lines_of(file)) {
        if (line.starts_with("```"))
            in_code = !in_code;
        else if (in_code)
            skeleton.commands.push_back(trimmed(line.substr(0, line.find('#'))));
        skeleton.rows += line.starts_with("|");
        skeleton.headings += !in_code && line.starts_with("#");
    }
    return skeleton;
}

TEST(Readmes, SayTheSameInBothLanguages) {
    Skeleton english = skeleton_of("README.md"), chinese = skeleton_of("README.zh.md");
    ASSERT_FALSE(english.links.empty() || chinese.links.empty());
    EXPECT_EQ(english.links.front().target, "README.zh.md");
    EXPECT_EQ(chinese.links.front().target, "README.md");
    english.links.erase(english.links.begin());
    chinese.links.erase(chinese.links.begin());
    EXPECT_EQ(english.commands, chinese.commands);
    EXPECT_EQ(english.rows, chinese.rows);
    EXPECT_EQ(english.headings, chinese.headings);
    ASSERT_EQ(english.links.size(), chinese.links.size());
    for (std::size_t i = 0; i < english.links.size(); ++i)
        EXPECT_EQ(english.links[i], chinese.links[i]) << english.links[i].target << ", " << chinese.links[i].target;
}

} // namespace
