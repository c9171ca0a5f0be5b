// Lesson 17, step 11: times as bars, a panel for each scene, each with a scale of its own.
#pragma once
#include "common/output_files.hpp"

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

namespace course {

struct Bar {
    std::string name, colour;
    double milliseconds;
};
struct BarPanel {
    std::string title;
    std::vector<Bar> bars;
};

// Colours of Okabe and Ito, which colour-blind readers can tell apart; and every bar says its name and its number.
inline std::string colour_of_way(const std::string &stage, const std::string &walk, bool specialised) {
    if (stage == "cpu")
        return "#444444";
    if (stage == "raster")
        return "#E69F00";
    if (stage == "compute")
        return "#009E73";
    return !specialised ? "#CC79A7" : walk == "skip" ? "#56B4E9" : "#0072B2";
}

// An SVG with a ground of its own, so that it is read on a dark page as well.
class BarChart {
  public:
    BarChart(std::string title, std::string below) : title_(std::move(title)), below_(std::move(below)) {}

    void add(BarPanel panel) { panels_.push_back(std::move(panel)); }

    void write(const std::string &file) const {
        double bottom = top;
        std::string drawings;
        for (std::size_t i = 0; i < panels_.size(); i += 2) {
            std::size_t most = 0;
            for (std::size_t k = i; k < std::min(i + 2, panels_.size()); ++k) {
                drawings += drawn(panels_[k], k % 2 ? 0.5 * width + 6 : 18, bottom);
                most = std::max(most, panels_[k].bars.size());
            }
            bottom += 42 + bar_step * static_cast<double>(most);
        }
        const double height = bottom + 30;
        std::string svg = said("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %.0f %.0f\" width=\"%.0f\" "
                               "height=\"%.0f\" font-family=\"DejaVu Sans, Arial, sans-serif\" font-size=\"13\" "
                               "fill=\"#222222\">\n",
                               width, height, width, height);
        svg += "<title>" + title_ + "</title>\n<desc>" + in_words() + "</desc>\n";
        svg += said("<rect width=\"%.0f\" height=\"%.0f\" rx=\"6\" fill=\"#ffffff\"/>\n", width, height);
        svg += text(width / 2, 30, title_, "font-size=\"17\" text-anchor=\"middle\"") + drawings;
        svg += text(width / 2, height - 14, below_, "font-size=\"12\" fill=\"#555555\" text-anchor=\"middle\"");
        write_text(file, svg + "</svg>\n");
    }

  private:
    static constexpr double width = 860, top = 52, bar_step = 24, names = 142, longest = 190;

    template <class... Numbers> static std::string said(const char *format, Numbers... numbers) {
        char line[512];
        std::snprintf(line, sizeof line, format, numbers...);
        return line;
    }
    static std::string text(double x, double y, const std::string &words, const std::string &how = "") {
        return said("<text x=\"%.1f\" y=\"%.1f\" ", x, y) + how + ">" + words + "</text>\n";
    }
    static std::string number(double milliseconds) { return said(milliseconds < 9.95 ? "%.1f" : "%.0f", milliseconds); }

    static std::string drawn(const BarPanel &panel, double x, double y) {
        std::string svg = text(x, y + 16, panel.title, "font-weight=\"bold\"");
        const double most = std::ranges::max(panel.bars, {}, &Bar::milliseconds).milliseconds;
        for (std::size_t i = 0; i < panel.bars.size(); ++i) {
            const Bar &bar = panel.bars[i];
            const double at = y + 26 + bar_step * static_cast<double>(i), end = longest * bar.milliseconds / most;
            svg += text(x + names - 8, at + 14, bar.name, "text-anchor=\"end\"");
            svg += said("<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"18\" fill=\"", x + names, at, end) +
                   bar.colour + "\"/>\n";
            svg += text(x + names + end + 6, at + 14, number(bar.milliseconds) + " ms");
        }
        return svg;
    }

    // What a reader hears who cannot see it.
    std::string in_words() const {
        std::string words;
        for (const BarPanel &panel : panels_) {
            words += panel.title + ": ";
            for (const Bar &bar : panel.bars)
                words += bar.name + " " + number(bar.milliseconds) + " ms" + (&bar == &panel.bars.back() ? ". " : ", ");
        }
        return words;
    }

    std::string title_, below_;
    std::vector<BarPanel> panels_;
};

} // namespace course
