// The gallery without a browser: well-formed, complete, escaped, and not taken in by nonsense.
#include "common/errors.hpp"
#include "common/gallery.hpp"
#include "common/html.hpp"
#include "common/plot.hpp"
#include "tests/browser/gallery_fixture.hpp"

#include <algorithm>
#include <fstream>
#include <gtest/gtest.h>
#include <regex>
#include <set>
#include <sstream>

using namespace course;
namespace fs = std::filesystem;

namespace {

std::string text_of(const fs::path &file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

// What is wrong with a page's tags: the first one that does not match, an attribute without quotes, a bare & or <.
// Empty when all is well. The contents of style and script are no HTML.
std::string complaint(const std::string &page) {
    static const std::regex tag(R"(<(/?)([a-z][a-z0-9]*)((?: [a-z-]+="[^"<>]*")*)>)");
    static const std::regex good_text(R"((?:[^<>&]|&(?:amp|lt|gt|quot|#39);)*)");
    static const std::set<std::string> empty{"img", "input", "meta", "link", "br"};
    std::vector<std::string> open;
    const std::string doctype = "<!doctype html>\n";
    if (!page.starts_with(doctype))
        return "no doctype";
    std::size_t at = doctype.size();
    while (at < page.size()) {
        const std::size_t next = std::min(page.find('<', at), page.size());
        if (!std::regex_match(page.substr(at, next - at), good_text))
            return "text: " + page.substr(at, next - at);
        if (next == page.size())
            break;
        std::smatch found;
        const std::string rest = page.substr(next, page.find('>', next) + 1 - next);
        if (!std::regex_match(rest, found, tag))
            return "tag: " + rest;
        const std::string name = found[2];
        at = next + rest.size();
        if (found[1].length()) {
            if (open.empty() || open.back() != name)
                return "</" + name + "> closes " + (open.empty() ? "nothing" : open.back());
            open.pop_back();
        } else if (!empty.contains(name)) {
            open.push_back(name);
            if (name == "style" || name == "script")
                at = page.find("</" + name + ">", at);
        }
    }
    return open.empty() ? "" : open.back() + " stays open";
}

std::vector<std::string> values_of(const std::string &page, const std::string &attribute) {
    const std::regex pattern(" " + attribute + "=\"([^\"]*)\"");
    std::vector<std::string> values;
    for (std::sregex_iterator i(page.begin(), page.end(), pattern), end; i != end; ++i)
        values.push_back((*i)[1]);
    return values;
}

std::string decoded(const std::string &address) {
    std::string path;
    for (std::size_t i = 0; i < address.size(); ++i)
        if (address[i] == '%') {
            path += static_cast<char>(std::stoi(address.substr(i + 1, 2), nullptr, 16));
            i += 2;
        } else
            path += address[i];
    return path;
}

class GalleryTest : public testing::Test {
  protected:
    GalleryFixture fixture;

    Gallery write() const { return write_gallery(fixture.course, fixture.out); }
    std::string page() const {
        write();
        return text_of(fixture.out / "index.html");
    }
    void expect_refused(const fs::path &file) const {
        try {
            write();
            ADD_FAILURE() << "taken: " << text_of(file);
        } catch (const InputError &error) {
            const std::string line = error.what();
            EXPECT_NE(line.find(file.filename().string()), std::string::npos) << line;
            EXPECT_EQ(line.find('\n'), std::string::npos) << line;
        }
        EXPECT_FALSE(fs::exists(fixture.out / "index.html"));
    }
};

TEST(Complaint, KnowsGoodFromBad) {
    const auto of = [](const std::string &body) { return complaint("<!doctype html>\n" + body); };
    EXPECT_EQ(of("<p class=\"a\">1 &lt; 2<br></p><script>if (1 < 2) {}</script>"), "");
    for (const char *bad :
         {"<p>", "</p>", "<p><b></p></b>", "1 < 2", "a & b", "<p class=a></p>", "<p a=\"\"\"></p>", "&nosuch;"})
        EXPECT_NE(of(bad), "") << bad;
}

TEST(Html, EscapesTextsAndAddresses) {
    EXPECT_EQ(html::escaped("<a href=\"x\">'&'</a>"), "&lt;a href=&quot;x&quot;&gt;&#39;&amp;&#39;&lt;/a&gt;");
    EXPECT_EQ(html::escaped(std::string("a\0b", 3)), "a\uFFFDb");
    EXPECT_EQ(html::address("../a b/c#1?.svg"), "../a%20b/c%231%3F.svg");
    EXPECT_EQ(html::address("é"), "%C3%A9");
    EXPECT_EQ(html::element("img", {{"alt", "a\"b"}}), "<img alt=\"a&quot;b\">");
    EXPECT_EQ(html::element("p", ""), "<p></p>");
}

TEST_F(GalleryTest, IsWellFormed) {
    EXPECT_EQ(complaint(page()), "");
    std::vector<std::string> ids = values_of(page(), "id");
    std::ranges::sort(ids);
    EXPECT_EQ(std::ranges::adjacent_find(ids), ids.end());
}

TEST_F(GalleryTest, EveryLinkAndPictureIsThere) {
    const std::string html = page();
    const auto ids = values_of(html, "id");
    std::vector<std::string> addresses = values_of(html, "href");
    std::ranges::copy(values_of(html, "src"), std::back_inserter(addresses));
    EXPECT_GT(addresses.size(), 30u);
    for (const std::string &address : addresses) {
        const bool there = address.starts_with("#") ? std::ranges::count(ids, address.substr(1)) == 1
                                                    : fs::exists(fixture.out / decoded(address));
        EXPECT_TRUE(there || address == "data:,") << address;
    }
    EXPECT_EQ(html.find("http:"), std::string::npos);
    EXPECT_EQ(html.find("https:"), std::string::npos);
}

TEST_F(GalleryTest, ShowsTextsAsTheyAreWritten) {
    const std::string html = page();
    EXPECT_NE(html.find("Casting &lt;rays&gt; &amp; &quot;hits&quot;"), std::string::npos); // the lesson's heading
    EXPECT_NE(html.find("&lt;b&gt;one ray&lt;/b&gt; &amp; 1 &lt; 2"), std::string::npos);   // the record's summary
    EXPECT_NE(html.find("It’s &quot;one of each&quot;"), std::string::npos);                // with JSON's own escapes
    EXPECT_NE(html.find("&lt;sphere&gt;"), std::string::npos);                              // a row of a report
    EXPECT_NE(html.find("Cost &amp; error"), std::string::npos);                            // a plot's title
    EXPECT_NE(html.find("cost%20%231%20%26%20more.svg"), std::string::npos);
    EXPECT_EQ(html.find("<b>"), std::string::npos);
}

TEST_F(GalleryTest, APlotSaysWhatItShows) {
    const Plot plot{
        "Cost < error & more", "ns", "ulp", false, false, {{"sphere", {{1, 2}, {2, 3}}}, {"disk", {{1, 1}}}}};
    if (!write_plot(fixture.out / "accuracy_a.svg", plot))
        GTEST_SKIP() << "gnuplot is not installed";
    const GalleryFigure figure = write().sections.at(0).findings.figures.at(0);
    EXPECT_EQ(figure.caption, plot.title);
    EXPECT_EQ(figure.description, "ulp against ns: sphere, disk");
}

TEST_F(GalleryTest, TakesTitlesFromLessonsThenRecordsThenFolders) {
    const Gallery gallery = write();
    ASSERT_EQ(gallery.chapters.size(), 4u);
    EXPECT_EQ(gallery.chapters[0].title, "Casting <rays> & \"hits\"");
    EXPECT_EQ(gallery.chapters[0].description, "Many spheres");
    EXPECT_EQ(gallery.chapters[1].title, "Primitives");
    EXPECT_EQ(gallery.chapters[2].title, "Light");
    EXPECT_EQ(gallery.chapters[3].summary, "Depth seen from the light");
    fs::remove(fixture.course / "chapters/03_light/README.md");
    EXPECT_EQ(write().chapters[2].title, "Light");
}

TEST_F(GalleryTest, AMissingRecordOrPictureIsNotRenderedYet) {
    EXPECT_FALSE(write().chapters[2].record);
    EXPECT_NE(page().find("./course run 3"), std::string::npos);
    fs::remove(fixture.out / "chapters/04_shadow_map.png");
    EXPECT_FALSE(write().chapters[3].record);
    fs::remove_all(fixture.out / "chapters");
    EXPECT_EQ(complaint(page()), "");
    EXPECT_NE(page().find("Nothing is rendered yet"), std::string::npos);
}

TEST_F(GalleryTest, ComparesWithTheLastChapterThatHasAPicture) {
    const std::string html = page();
    EXPECT_EQ(values_of(html, "data-before"),
              (std::vector<std::string>{"chapter 01, Casting &lt;rays&gt; &amp; &quot;hits&quot;",
                                        "chapter 02, Primitives"}));
}

TEST_F(GalleryTest, HasASectionForWhatIsThereAndNoneForWhatIsNot) {
    const auto sections = [&] {
        std::vector<std::string> ids;
        for (const GallerySection &section : write().sections)
            ids.push_back(section.id);
        return ids;
    };
    EXPECT_EQ(sections(), (std::vector<std::string>{"accuracy", "claims", "slides", "exercises"}));
    write_text(fixture.out / "gpu.json", R"({"results": []})");
    fs::remove_all(fixture.out / "slides");
    fs::remove(fixture.out / "accuracy.json");
    fs::remove(fixture.out / "accuracy_speed.svg");
    EXPECT_EQ(sections(), (std::vector<std::string>{"claims", "gpu", "exercises"}));
}

TEST_F(GalleryTest, RefusesNonsenseRecords) {
    const fs::path file = fixture.out / "chapters/02_primitives.json";
    const std::string good =
        R"({"chapter": "02_primitives", "summary": "s", "width": 60, "height": 60, "seconds": 1, "rays": 1, "threads": 1})";
    const auto with = [&](const std::string &old, const std::string &other) {
        std::string text = good;
        return text.replace(text.find(old), old.size(), other);
    };
    for (const std::string &nonsense :
         {std::string(), std::string("{"), std::string("[]"), std::string("{}"), std::string("nonsense"), good + "x",
          with("60", "-60"), with("60", "0"), with("60", "\"60\""), with("\"rays\": 1", "\"rays\": null"),
          with("\"threads\"", "\"x\""), with("\"s\"", "7"), with("\"seconds\": 1", "\"seconds\": -1"),
          with("02_primitives", "03_light"), std::string("\xff\xfe")}) {
        write_text(file, nonsense);
        expect_refused(file);
    }
    write_text(file, good);
    EXPECT_NO_THROW(write());
}

TEST_F(GalleryTest, RefusesNonsenseReports) {
    const fs::path file = fixture.out / "claims.json";
    for (const char *nonsense : {"", "{}", "[]", "{\"results\": 3}", "{\"results\": [3]}", "no"}) {
        write_text(file, nonsense);
        expect_refused(file);
    }
}

TEST_F(GalleryTest, RefusesFoldersThatAreNotThere) {
    EXPECT_THROW(write_gallery(fixture.course, fixture.path / "no"), InputError);
    EXPECT_THROW(write_gallery(fixture.path / "no", fixture.out), InputError);
    EXPECT_THROW(write_gallery(fixture.out, fixture.out), InputError);
}

// A picture's record under another name, as --out makes one, is no report of the chapter.
TEST_F(GalleryTest, LeavesOtherPicturesRecordsAlone) {
    fixture.picture("02_primitives_small", 6, 6, GalleryFixture::red, "Small");
    const Gallery gallery = write();
    EXPECT_TRUE(gallery.chapters[1].findings.tables.empty());
    EXPECT_EQ(gallery.chapters[1].findings.figures.size(), 2u);
}

} // namespace
