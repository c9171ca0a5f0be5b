// The gallery without a browser: well-formed, complete, escaped, and not taken in by nonsense.
#include "common/errors.hpp"
#include "common/gallery.hpp"
#include "common/html.hpp"
#include "common/plot.hpp"
#include "tests/browser/gallery_fixture.hpp"
#include "tests/house/pattern.hpp"

#include <algorithm>
#include <fstream>
#include <gtest/gtest.h>
#include <set>
#include <sstream>

using namespace course;
using texts::Found;
using texts::Pattern;
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
    static const Pattern tag(R"(<(/?)([a-z][a-z0-9]*)((?: [a-z-]+="[^"<>]*")*)>)");
    static const Pattern good_text(R"((?:[^<>&]|&(?:amp|lt|gt|quot|#39);)*)");
    static const std::set<std::string> empty{"img", "input", "meta", "link", "br"};
    std::vector<std::string> open;
    const std::string doctype = "<!doctype html>\n";
    if (!page.starts_with(doctype))
        return "no doctype";
    std::size_t at = doctype.size();
    while (at < page.size()) {
        const std::size_t next = std::min(page.find('<', at), page.size());
        if (!good_text.matches(page.substr(at, next - at)))
            return "text: " + page.substr(at, next - at);
        if (next == page.size())
            break;
        const std::string rest = page.substr(next, page.find('>', next) + 1 - next);
        const Found found = tag.match(rest);
        if (found.empty())
            return "tag: " + rest;
        const std::string name = found[2];
        at = next + rest.size();
        if (!found[1].empty()) {
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
    const Pattern pattern(" " + attribute + "=\"([^\"]*)\"");
    std::vector<std::string> values;
    for (const Found &found : pattern.all_in(page))
        values.push_back(found[1]);
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
    EXPECT_NE(html.find("It’s &quot;one of each&quot; &amp; &lt;b&gt;1&lt;/b&gt; &lt; 2"),
              std::string::npos);                                // the record's summary, with JSON's escapes
    EXPECT_NE(html.find("&lt;sphere&gt;"), std::string::npos);   // a row of a report
    EXPECT_NE(html.find("Cost &amp; error"), std::string::npos); // a plot's title
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

// From 0 to 20,000 there is no room for the words of 10,000 and of 20,000.
TEST_F(GalleryTest, ThePlotsTicksDoNotTouch) {
    Plot plot{"Speed and error", "wrong answers", "speed", true, false, {{"test", {{0, 1}, {700, 2}, {20000, 3}}}}};
    const fs::path svg = fixture.out / "accuracy_a.svg";
    if (!write_plot(svg, plot))
        GTEST_SKIP() << "gnuplot is not installed";
    EXPECT_EQ(text_of(svg).find(">20,000<"), std::string::npos);
    EXPECT_NE(text_of(svg).find("10,000<"), std::string::npos);
    plot.series[0].points = {{5000, 1}, {20000, 2}}; // where there is room
    write_plot(svg, plot);
    EXPECT_NE(text_of(svg).find("20,000<"), std::string::npos);
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

const GallerySection &section_of(const Gallery &gallery, const std::string &id) {
    return *std::ranges::find(gallery.sections, id, &GallerySection::id);
}

// The section's part of the page.
std::string part_of(const std::string &html, const std::string &id) {
    const auto begin = html.find("<section id=\"" + id + "\"");
    return begin == std::string::npos ? std::string() : html.substr(begin, html.find("</section>", begin) - begin);
}

TEST_F(GalleryTest, HasEverySectionAndSaysHowToMakeWhatIsMissing) {
    const std::vector<std::pair<std::string, std::string>> commands{{"accuracy", "./course accuracy --quick"},
                                                                    {"compare", "./course compare --quick"},
                                                                    {"claims", "./course claims --quick"},
                                                                    {"gpu", "./course run 17 --measure"}};
    const auto says_how = [&](const std::string &html, const std::string &id) {
        const auto command = std::ranges::find(commands, id, &std::pair<std::string, std::string>::first)->second;
        const std::string part = part_of(html, id);
        return part.find("Not made yet") != std::string::npos && part.find("<code>" + command) != std::string::npos;
    };
    std::string html = page();
    for (const char *id : {"start", "chapters", "accuracy", "compare", "claims", "gpu", "slides", "exercises"}) {
        EXPECT_NE(part_of(html, id), "") << id;
    }
    EXPECT_FALSE(says_how(html, "accuracy") || says_how(html, "claims"));
    EXPECT_TRUE(says_how(html, "compare") && says_how(html, "gpu"));
    write_text(fixture.out / "gpu.json", R"({"results": []})");
    for (const char *file : {"accuracy.json", "accuracy_speed.svg"})
        fs::remove(fixture.out / file);
    html = page();
    EXPECT_TRUE(says_how(html, "accuracy"));
    EXPECT_FALSE(says_how(html, "gpu"));
}

TEST_F(GalleryTest, LeadsToDecksThatAreBuiltAndElseToTheirSources) {
    const GallerySection slides = section_of(write(), "slides");
    ASSERT_EQ(slides.list.size(), 2u);
    EXPECT_EQ(slides.list[0].address, "slides/01_ray_casting.html");
    EXPECT_EQ(slides.list[0].title, "Rays & eyes");
    EXPECT_EQ(slides.list[0].about, "camera, ray");
    ASSERT_EQ(slides.list[0].also.size(), 1u);
    EXPECT_EQ(slides.list[0].also[0].address, "slides/01_ray_casting.pdf");
    EXPECT_EQ(slides.list[1].address, "../slides/02_primitives.md");
    EXPECT_TRUE(slides.made);
    fs::remove_all(fixture.out / "slides");
    EXPECT_FALSE(section_of(write(), "slides").made);
    EXPECT_NE(part_of(page(), "slides").find("<code>./course slides</code>"), std::string::npos);
}

TEST_F(GalleryTest, SaysWhatEachExerciseAsks) {
    const std::string part = part_of(page(), "exercises");
    EXPECT_NE(part.find("Where does a <em>ray</em> meet it?"), std::string::npos);
    EXPECT_NE(part.find("<span>./course</span> <span>exercise</span> <span>01_sphere</span>"), std::string::npos);
}

TEST_F(GalleryTest, AChapterHasItsQuestionItsMinutesItsSlidesAndItsExercise) {
    const GalleryChapter first = write().chapters.at(0);
    EXPECT_EQ(first.question, "Which colour has `a < b`, if $t$ is known?");
    EXPECT_EQ(first.minutes, "35 to read, 60 to do");
    ASSERT_EQ(first.links.size(), 2u);
    EXPECT_EQ(first.links[0].text, "Slides");
    EXPECT_EQ(first.links[1].text, "Exercise: The sphere");
    EXPECT_NE(page().find("<code>a &lt; b</code>, if <var>t</var> is known?"), std::string::npos);
}

TEST_F(GalleryTest, JudgesEveryClaimBesideItsFigureAndItsChapter) {
    const std::string part = part_of(page(), "claims");
    for (const char *words : {"1 hold", "0 fail", "1 depend", "✓", "◐", "8 and 16 bounces differ little",
                              "Two pictures.", "RMSE &lt; 1", "It depends on", "the lens", "href=\"#chapter-02\""})
        EXPECT_NE(part.find(words), std::string::npos) << words;
    EXPECT_EQ(part.find("99"), std::string::npos); // a chapter that is not there is no link
    const auto figure = part.find("src=\"claims_C1.svg\"");
    EXPECT_LT(figure, part.find("C14")); // within its claim, and nowhere else
    EXPECT_EQ(part.find("src=\"claims_C1.svg\"", figure + 1), std::string::npos);
}

TEST_F(GalleryTest, HasTheCoverOfTheReadme) {
    EXPECT_EQ(write().cover.address, "../cover.png");
    EXPECT_NE(page().find("alt=\"The whole of it\""), std::string::npos);
    fs::remove(fixture.course / "README.md");
    EXPECT_EQ(write().cover.address, "");
    EXPECT_EQ(complaint(page()), "");
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
