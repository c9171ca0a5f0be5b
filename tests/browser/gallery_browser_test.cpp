// The gallery as a reader meets it: in a browser, by mouse, finger and keys, wide and narrow, light and dark.
//   gallery_browser_test --screenshots PAGE FOLDER   shows a page in those four ways instead of testing one
#include "common/gallery.hpp"
#include "common/image_files.hpp"
#include "tests/browser/browser.hpp"
#include "tests/browser/gallery_fixture.hpp"

#include <algorithm>
#include <cstdio>
#include <gtest/gtest.h>

using namespace course;

namespace {

std::unique_ptr<Browser> browser;

struct Place {
    double left, top, width, height;
};

class GalleryPage : public testing::Test {
  protected:
    GalleryFixture fixture;

    void SetUp() override { write_gallery(fixture.course, fixture.out); }
    void open(int width = 1280, int height = 900) { browser->open(fixture.out / "index.html", width, height); }

    // Where the first element that matches is in the window, after it was brought there.
    static Place place(const std::string &selector) {
        const Json box =
            browser->evaluate("(() => { const e = document.querySelector('" + selector +
                              "'); e.scrollIntoView({block: 'center', behavior: 'instant'}); const b = "
                              "e.getBoundingClientRect(); return [b.left, b.top, b.width, b.height]; })()");
        return {box[0], box[1], box[2], box[3]};
    }

    // The colour that is seen at a share of an element's width, at a share of its height: above the slider's grip.
    Colour seen(const std::string &selector, double across, double down = 0.2) const {
        const Place at = place(selector);
        browser->screenshot(fixture.path / "seen.png", false);
        const Picture window = read_image(fixture.path / "seen.png");
        return window(static_cast<int>(at.left + across * at.width), static_cast<int>(at.top + down * at.height));
    }

    static bool alike(const Colour &a, const Colour &b) { return glm::length(a - b) < 0.02f; }
};

const std::string second = "#chapter-02 .frame", fourth = "#chapter-04 .frame";

TEST_F(GalleryPage, LoadsWithoutComplaintAndFromNowhereElse) {
    open();
    EXPECT_EQ(browser->complaints, std::vector<std::string>{});
    EXPECT_EQ(browser->addresses_elsewhere, std::vector<std::string>{});
}

constexpr const char *broken_pictures =
    "[...document.images].filter(i => !i.complete || i.naturalWidth === 0).map(i => i.src.split('/').pop())";

TEST_F(GalleryPage, NoPictureIsBroken) {
    open();
    EXPECT_GE(browser->evaluate("document.images.length"), 7);
    EXPECT_EQ(browser->evaluate(broken_pictures), Json::array());
}

TEST_F(GalleryPage, ThisTestWouldNoticeABrokenPicture) {
    std::filesystem::remove(fixture.out / "accuracy_speed.svg");
    open();
    EXPECT_EQ(browser->evaluate(broken_pictures), Json::array({"accuracy_speed.svg"}));
    EXPECT_FALSE(browser->complaints.empty());
}

TEST_F(GalleryPage, TheFirstChapterHasNoBefore) {
    open();
    EXPECT_EQ(browser->evaluate("document.querySelectorAll('#chapter-01 input, #chapter-01 .before').length"), 0);
    EXPECT_TRUE(alike(seen("#chapter-01 .frame", 0.02), GalleryFixture::red));
}

TEST_F(GalleryPage, TheSliderFollowsTheMouse) {
    open();
    const Place frame = place(fourth);
    const auto at = [&](double share) { return frame.left + share * frame.width; };
    const double y = frame.top + frame.height / 2;
    browser->mouse("mousePressed", at(0.5), y);
    browser->mouse("mouseMoved", at(0.6), y);
    browser->mouse("mouseMoved", at(0.8), y);
    EXPECT_TRUE(alike(seen(fourth, 0.75), GalleryFixture::green)); // the square one before, fitted into the middle
    EXPECT_TRUE(alike(seen(fourth, 0.85), GalleryFixture::blue));
    EXPECT_EQ(browser->evaluate("document.querySelector('#split-04').value"), "80");
    browser->mouse("mouseReleased", at(0.8), y);
    browser->mouse("mouseMoved", at(0.1), y); // no longer held
    EXPECT_TRUE(alike(seen(fourth, 0.75), GalleryFixture::green));
    browser->mouse("mousePressed", at(0.9), y);
    browser->mouse("mouseMoved", at(-0.5), y); // beyond the picture's rim
    browser->mouse("mouseReleased", at(-0.5), y);
    EXPECT_TRUE(alike(seen(fourth, 0.25), GalleryFixture::blue));
    EXPECT_EQ(browser->evaluate("document.querySelector('#split-04').value"), "0");
}

TEST_F(GalleryPage, TheSliderFollowsAFinger) {
    open(360, 740);
    const Place frame = place(fourth);
    const double y = frame.top + frame.height / 2;
    browser->touch("touchStart", frame.left + 0.3 * frame.width, y);
    for (const double share : {0.35, 0.5, 0.7})
        browser->touch("touchMove", frame.left + share * frame.width, y);
    browser->touch("touchEnd", 0, 0);
    EXPECT_TRUE(alike(seen(fourth, 0.65), GalleryFixture::green));
    EXPECT_TRUE(alike(seen(fourth, 0.75), GalleryFixture::blue));
}

TEST_F(GalleryPage, TheSliderFollowsTheKeys) {
    open();
    browser->evaluate("document.querySelector('#split-04').focus()");
    browser->key("Home", 36);
    EXPECT_TRUE(alike(seen(fourth, 0.25), GalleryFixture::blue));
    browser->key("End", 35);
    EXPECT_TRUE(alike(seen(fourth, 0.7), GalleryFixture::green));
    browser->key("Home", 36);
    for (int i = 0; i < 3; ++i)
        browser->key("ArrowRight", 39);
    EXPECT_EQ(browser->evaluate("document.querySelector('#split-04').value"), "3");
    EXPECT_EQ(browser->evaluate("document.querySelector('#split-04').getAttribute('aria-valuetext')"),
              "3 % of chapter 02, Primitives");
    browser->key("ArrowLeft", 37);
    EXPECT_EQ(
        browser->evaluate("getComputedStyle(document.querySelector('" + fourth + "')).getPropertyValue('--split')"),
        "2%");
}

// A wide picture before a square one: it is shown whole, in the middle, with the mat above and below, not stretched.
TEST_F(GalleryPage, PicturesOfDifferentSizesAlign) {
    open();
    browser->evaluate("document.querySelector('#split-02').focus()");
    browser->key("End", 35);
    const Place frame = place(second);
    const double wide =
        std::min(frame.width * 54 / 96, frame.height) / frame.height; // the share of the height it takes
    EXPECT_TRUE(alike(seen(second, 0.5, 0.5 + 0.45 * wide), GalleryFixture::red));
    const Colour mat = seen(second, 0.5, 0.5 + 0.55 * wide);
    EXPECT_LT(glm::length(mat), 0.05f); // neither the green picture beneath nor a stretched red one
}

TEST_F(GalleryPage, EveryControlIsReachedAndSeenByKeyboard) {
    open();
    browser->key("Tab", 9);
    EXPECT_EQ(browser->evaluate("document.activeElement.className"), "skip");
    EXPECT_GE(place(".skip").left, 0);
    std::vector<std::string> reached;
    for (int i = 0; i < 80 && browser->evaluate("document.activeElement !== document.body"); ++i) {
        reached.push_back(browser->evaluate("document.activeElement.id"));
        EXPECT_EQ(browser->evaluate("getComputedStyle(document.activeElement).outlineStyle"), "solid")
            << reached.back();
        browser->key("Tab", 9);
    }
    EXPECT_EQ(std::ranges::count(reached, "split-02"), 1);
    EXPECT_EQ(std::ranges::count(reached, "split-04"), 1);
    EXPECT_EQ(browser->evaluate("[...document.querySelectorAll('a, input, summary')].filter(e => "
                                "!e.closest('details:not([open]) > :not(summary)')).length"),
              reached.size());
}

TEST_F(GalleryPage, AScreenReaderIsToldWhatThingsAre) {
    open();
    int sliders = 0;
    const Json tree = browser->call("Accessibility.getFullAXTree");
    for (const Json &node : tree["nodes"]) {
        const std::string role = node.value("/role/value"_json_pointer, "");
        if (role == "slider" || role == "link" || role == "navigation" || role == "DisclosureTriangle") {
            EXPECT_NE(node.value("/name/value"_json_pointer, ""), "") << node.dump();
        }
        if (role == "slider") {
            ++sliders;
            EXPECT_TRUE(node["name"]["value"].get<std::string>().starts_with("Before: chapter 0")) << node["name"];
        }
    }
    EXPECT_EQ(sliders, 2);
    EXPECT_EQ(browser->evaluate("[...document.images].filter(i => !i.hasAttribute('alt')).length"), 0);
    EXPECT_EQ(browser->evaluate("[...document.querySelectorAll('figure img')].filter(i => !i.alt).length"), 0);
    // Headings in order: one h1, and none skips a level.
    EXPECT_EQ(
        browser->evaluate("[...document.querySelectorAll('h1,h2,h3,h4,h5,h6')].map(h => +h.tagName[1])"
                          ".every((level, i, all) => i === 0 ? level === 1 : level > 1 && level <= all[i - 1] + 1)"),
        true);
}

TEST_F(GalleryPage, FitsEveryWidth) {
    open();
    browser->evaluate("document.querySelectorAll('details').forEach(d => d.open = true)");
    for (const int width : {320, 360, 600, 900, 1280, 2560}) {
        browser->resize(width, 800);
        EXPECT_EQ(browser->evaluate("document.scrollingElement.scrollWidth"), width);
        EXPECT_EQ(browser->evaluate(
                      "[...document.querySelectorAll('body *:not(.skip)')].filter(e => !e.closest('.scroll') && "
                      "e.getBoundingClientRect().right > innerWidth + 0.5).map(e => e.outerHTML.slice(0, 80))"),
                  Json::array())
            << width;
    }
}

// WCAG's contrast of every text with what is behind it: at least 4.5, light and dark.
constexpr const char *faint_texts = R"((() => {
  const linear = v => (v /= 255) <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4;
  const parts = c => c.match(/[\d.]+/g).map(Number);
  const luminance = c => { const [r, g, b] = parts(c).map(linear); return 0.2126 * r + 0.7152 * g + 0.0722 * b; };
  const behind = e => { for (; e; e = e.parentElement) { const c = getComputedStyle(e).backgroundColor;
    if (parts(c)[3] !== 0) return c; } return 'rgb(255, 255, 255)'; };
  return [...document.querySelectorAll('body *')].filter(e => [...e.childNodes].some(n => n.nodeType === 3 && n.data.trim()) &&
      !['SCRIPT', 'STYLE'].includes(e.tagName)).filter(e => {
    const a = luminance(getComputedStyle(e).color), b = luminance(behind(e));
    return (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05) < 4.5;
  }).map(e => e.outerHTML.slice(0, 80));
})())";

TEST_F(GalleryPage, IsReadableInLightAndDark) {
    for (const bool dark : {false, true}) {
        browser->prefer("prefers-color-scheme", dark ? "dark" : "light");
        open();
        browser->evaluate("document.querySelectorAll('details').forEach(d => d.open = true)");
        EXPECT_EQ(browser->evaluate(faint_texts), Json::array()) << (dark ? "dark" : "light");
        const float paper = seen("body", 0.001, 0.5).g;
        EXPECT_TRUE(dark ? paper < 0.05f : paper > 0.8f) << paper;
    }
    browser->prefer("prefers-color-scheme", "light");
}

TEST_F(GalleryPage, MovesOnlyWhereMotionIsWelcome) {
    browser->prefer("prefers-reduced-motion", "reduce");
    open();
    EXPECT_EQ(browser->evaluate("getComputedStyle(document.documentElement).scrollBehavior"), "auto");
    EXPECT_EQ(browser->evaluate("document.getAnimations().length"), 0);
    browser->prefer("prefers-reduced-motion", "no-preference");
}

TEST_F(GalleryPage, LinksLeadSomewhere) {
    open();
    const Json files =
        browser->evaluate("[...document.querySelectorAll('a')].map(a => a.href).filter(a => !a.includes('#'))");
    EXPECT_GT(files.size(), 20u);
    for (const std::string address : files) {
        std::string path;
        for (std::size_t i = std::string("file://").size(); i < address.size(); ++i)
            if (address[i] == '%') {
                path += static_cast<char>(std::stoi(address.substr(i + 1, 2), nullptr, 16));
                i += 2;
            } else
                path += address[i];
        EXPECT_TRUE(std::filesystem::exists(path)) << address;
    }
    EXPECT_EQ(browser->evaluate("[...document.querySelectorAll('a[href^=\"#\"]')].filter(a => "
                                "!document.getElementById(a.getAttribute('href').slice(1))).map(a => a.outerHTML)"),
              Json::array());
}

TEST_F(GalleryPage, EverySectionIsThereAndNamedInTheBar) {
    open();
    EXPECT_EQ(browser->evaluate("[...document.querySelectorAll('main > section')].map(s => s.id)"),
              Json::array({"start", "chapters", "accuracy", "compare", "claims", "gpu", "slides", "exercises"}));
    EXPECT_EQ(browser->evaluate("[...document.querySelectorAll('.parts a')].map(a => a.hash.slice(1))"),
              Json::array({"chapters", "accuracy", "compare", "claims", "gpu", "slides", "exercises"}));
    EXPECT_EQ(browser->evaluate("[...document.querySelectorAll('main > section')].filter(s => s.offsetHeight < 100)"
                                ".map(s => s.id)"),
              Json::array()); // none is empty
}

// Waits a moment each time, since the browser says by itself when a part has come into sight.
TEST_F(GalleryPage, TheBarStaysInSightAndSaysWhichPartIsShown) {
    browser->prefer("prefers-reduced-motion", "reduce");
    open();
    for (const std::string part : {"claims", "accuracy", "exercises", "chapters"}) {
        EXPECT_EQ(browser->evaluate("new Promise(done => { document.querySelector('.parts a[href=\"#" + part +
                                    "\"]').click(); setTimeout(() => done([...document.querySelectorAll('.parts "
                                    "[aria-current]')].map(a => a.hash)), 300); })"),
                  Json::array({"#" + part}));
        EXPECT_EQ(browser->evaluate("document.querySelector('.parts').getBoundingClientRect().top"), 0) << part;
        const double heading =
            browser->evaluate("document.querySelector('#" + part + " h2').getBoundingClientRect().top");
        EXPECT_GT(heading, browser->evaluate("document.querySelector('.parts').offsetHeight - 16").get<double>())
            << part;
    }
    browser->prefer("prefers-reduced-motion", "no-preference");
}

TEST_F(GalleryPage, AClaimShowsItsFigureWhenAsked) {
    open();
    browser->evaluate("document.querySelector('#claim-C1 summary').focus()");
    browser->key("Enter", 13);
    EXPECT_EQ(browser->evaluate("new Promise(done => setTimeout(() => done(document.querySelector('#claim-C1 "
                                "img').naturalWidth), 300))"),
              82);
    EXPECT_EQ(browser->complaints, std::vector<std::string>{});
}

int take_screenshots(const std::filesystem::path &page, const std::filesystem::path &folder) {
    std::filesystem::create_directories(folder);
    for (const char *scheme : {"light", "dark"})
        for (const auto &[name, width, height] : {std::tuple{"wide", 1280, 900}, {"narrow", 360, 740}}) {
            browser->prefer("prefers-color-scheme", scheme);
            browser->open(page, width, height);
            browser->screenshot(folder / (std::string(name) + "_" + scheme + ".png"), true);
        }
    for (const std::string &complaint : browser->complaints)
        std::fprintf(stderr, "%s\n", complaint.c_str());
    return browser->complaints.empty() ? 0 : 1;
}

} // namespace

int main(int argc, char **argv) {
    testing::InitGoogleTest(&argc, argv);
    const auto program = Browser::find();
    if (!program) {
        std::puts("skipped: no Chromium is installed (package chromium)");
        return 77;
    }
    try {
        browser = std::make_unique<Browser>(*program);
    } catch (const std::exception &error) {
        std::printf("skipped: %s is installed but does not start: %s\n", program->c_str(), error.what());
        return 77;
    }
    const bool show = argc == 4 && std::string(argv[1]) == "--screenshots";
    const int status = show ? take_screenshots(argv[2], argv[3]) : RUN_ALL_TESTS();
    browser.reset();
    return status;
}
