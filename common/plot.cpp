#include "common/plot.hpp"

#include "common/errors.hpp"
#include "common/output_files.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <sstream>

namespace course {
namespace {

// Okabe and Ito's colours, which colour-blind readers can tell apart.
constexpr std::array colours{"#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000", "#8C6D00"};

// What stands in for 0 on a logarithmic axis: a tenth of the smallest positive value.
struct Floor {
    double smallest = std::numeric_limits<double>::infinity();
    bool needed = false;

    void see(double value) {
        if (value > 0)
            smallest = std::min(smallest, value);
        else
            needed = true;
    }
    double value() const { return std::isfinite(smallest) ? smallest / 10 : 1e-9; }
    double shown(double v) const { return v > 0 ? v : value(); }
    std::string note() const {
        char text[64] = "";
        if (needed)
            std::snprintf(text, sizeof text, " (0 is drawn at %.1g)", value());
        return text;
    }
};

std::string quoted(const std::string &text) {
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\')
            result += '\\';
        result += c;
    }
    return result + "\"";
}

const char *style_words(Series::Style style) {
    switch (style) {
    case Series::Style::line:
        return "lines";
    case Series::Style::points:
        return "points";
    default:
        return "linespoints";
    }
}

std::string script(const Plot &plot, const std::string &svg) {
    Floor floor_x, floor_y;
    for (const Series &series : plot.series)
        for (const PlotPoint &point : series.points) {
            floor_x.see(point.x);
            floor_y.see(point.y);
        }
    std::ostringstream out;
    out.precision(10);
    out << "set terminal svg size 820,500 font 'DejaVu Sans,14' background '#ffffff' noenhanced\n"
        << "set output " << quoted(svg) << "\nset encoding utf8\n"
        << "set title " << quoted(plot.title) << "\nset grid lc rgb '#dddddd'\nset border lc rgb '#555555'\n"
        << "set key outside right top\nset offsets graph 0.05, graph 0.05, graph 0.05, graph 0.05\n"
        << "set xlabel " << quoted(plot.x_label + (plot.log_x ? floor_x.note() : "")) << "\n"
        << "set ylabel " << quoted(plot.y_label + (plot.log_y ? floor_y.note() : "")) << "\n";
    if (plot.log_x)
        out << "set logscale x\nset format x '%.0g'\n";
    if (plot.log_y)
        out << "set logscale y\nset format y '%.0g'\n";

    std::ostringstream data, curves, labels;
    data.precision(10);
    for (std::size_t i = 0; i < plot.series.size(); ++i) {
        const Series &series = plot.series[i];
        data << "$data" << i << " << EOD\n";
        for (const PlotPoint &point : series.points)
            data << (plot.log_x ? floor_x.shown(point.x) : point.x) << " "
                 << (plot.log_y ? floor_y.shown(point.y) : point.y) << " " << quoted(point.label) << "\n";
        data << "EOD\n";
        const char *colour = colours[i % colours.size()];
        const bool labelled =
            std::ranges::any_of(series.points, [](const PlotPoint &point) { return !point.label.empty(); });
        curves << (i ? ", " : "plot ") << "$data" << i << " using 1:2 with " << style_words(series.style) << " lw 2 ";
        if (series.style != Series::Style::line) // gnuplot refuses points where there are only lines
            curves << "ps 0.9 pt " << i + 4;
        curves << " lc rgb '" << colour << "' title " << quoted(series.name);
        if (labelled)
            labels << ", $data" << i << " using 1:2:3 with labels left offset 0.8,0.3 font ',11' tc rgb '" << colour
                   << "' notitle";
    }
    out << data.str() << curves.str() << labels.str() << "\n";
    return out.str();
}

} // namespace

namespace {

std::string escaped(const std::string &text) {
    std::string result;
    for (const char c : text)
        result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
    return result;
}

void replace_between(std::string &text, const std::string &before, const std::string &after, const std::string &with) {
    const auto start = text.find(before), end = text.find(after, start);
    if (start != std::string::npos && end != std::string::npos)
        text.replace(start + before.size(), end - start - before.size(), with);
}

// gnuplot names every picture "Gnuplot". Its title and description are what a reader hears who cannot see it.
void say_what_it_shows(const std::filesystem::path &svg, const Plot &plot) {
    std::ostringstream read;
    read << std::ifstream(svg).rdbuf();
    std::string text = read.str();
    std::string shown = plot.y_label + " against " + plot.x_label;
    for (const Series &series : plot.series)
        shown += (&series == &plot.series.front() ? ": " : ", ") + series.name;
    replace_between(text, "<title>", "</title>", escaped(plot.title));
    replace_between(text, "<desc>", "</desc>", escaped(shown));
    std::ofstream(svg, std::ios::binary) << text;
}

} // namespace

bool write_plot(const std::filesystem::path &svg, const Plot &plot) {
    static const bool found = std::system("command -v gnuplot >/dev/null 2>&1") == 0;
    if (!found) {
        static const bool said = std::fputs("plots are left out, because gnuplot is not installed\n", stderr) >= 0;
        return said && false;
    }
    require_writable(svg);
    replace_file(svg, [&](const std::filesystem::path &beside) {
        FILE *gnuplot = popen("gnuplot", "w");
        if (!gnuplot)
            throw InputError(svg.string(), "gnuplot could not be started");
        std::fputs(script(plot, beside.string()).c_str(), gnuplot);
        if (pclose(gnuplot) != 0)
            throw InputError(svg.string(), "gnuplot failed");
        say_what_it_shows(beside, plot);
    });
    return true;
}

} // namespace course
