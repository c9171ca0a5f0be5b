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

// In double quotes, in which gnuplot would run what stands between backquotes.
std::string quoted(const std::string &text) {
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\' || c == '`')
            result += '\\';
        result += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    }
    return result + "\"";
}

// A tick's words: 0.01, 20, 5,000, and 10⁶ or 2·10⁻⁸ where digits would be too many.
std::string tick_words(double value) {
    char text[64];
    if (value >= 0.001 && value < 1e5) {
        std::snprintf(text, sizeof text, "%.6g", value);
        std::string digits = text;
        if (value >= 1000 && digits.find('.') == std::string::npos)
            digits.insert(digits.size() - 3, ",");
        return digits;
    }
    static constexpr std::array superscripts{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    const int power = static_cast<int>(std::floor(std::log10(value) + 1e-9));
    const int factor = static_cast<int>(std::lround(value / std::pow(10.0, power)));
    std::string raised = power < 0 ? "⁻" : "";
    for (const char digit : std::to_string(std::abs(power)))
        raised += superscripts[static_cast<std::size_t>(digit - '0')];
    return (factor == 1 ? "10" : std::to_string(factor) + "·10") + raised;
}

// A logarithmic axis, on which a value that is not positive stands at a place of its own before all others, marked 0.
struct LogAxis {
    double least = std::numeric_limits<double>::infinity(), greatest = 0;
    bool has_zero = false;

    void see(double value) {
        if (value > 0 && std::isfinite(value)) {
            least = std::min(least, value);
            greatest = std::max(greatest, value);
        } else {
            has_zero = true;
        }
    }
    int first_power() const {
        return std::isfinite(least) ? static_cast<int>(std::floor(std::log10(least) + 1e-9)) : 0;
    }
    double zero() const { return std::pow(10.0, first_power() - 1); }
    double shown(double value) const { return value > 0 ? value : zero(); }

    // Each power of ten; at every second or third where they are many, twice and five times as well where they are few
    // and there is room for their words.
    std::vector<double> ticks(double from, double to, bool room = true) const {
        std::vector<double> places;
        if (!has_zero && to / from < 5) { // less than a power: steps of equal length, 1, 2 or 5 of the right size
            const double rough = (to - from) / 5, size = std::pow(10.0, std::floor(std::log10(rough)));
            const double step = size * (rough < 2 * size ? 2 : rough < 5 * size ? 5 : 10);
            for (double at = std::ceil(from / step) * step; at < to; at += step)
                places.push_back(at);
            return places;
        }
        const int last_power = static_cast<int>(std::ceil(std::log10(to) - 1e-9)), powers = last_power - first_power();
        for (int power = first_power(); power <= last_power; power += 1 + powers / 9)
            for (const int factor : {1, 2, 5})
                if (factor == 1 || (room && to / from < 60))
                    places.push_back(factor * std::pow(10.0, power));
        return places;
    }

    // Whether the words of neighbouring ticks would touch on a horizontal axis, of 65 letters' length, between these.
    static bool crowded(const std::vector<double> &places, double from, double to) {
        const auto letters = [](double place) {
            const std::string words = tick_words(place);
            return std::ranges::count_if(words, [](char c) { return (c & 0xc0) != 0x80; });
        };
        for (std::size_t i = 1; i < places.size(); ++i) {
            const double distance = 65 * std::log(places[i] / places[i - 1]) / std::log(to / from);
            if (distance < 1 + 0.5 * static_cast<double>(letters(places[i - 1]) + letters(places[i])))
                return true;
        }
        return false;
    }

    // gnuplot's words for the axis x or y: its range with a little air, and its ticks.
    std::string script(const std::string &name) const {
        if (!std::isfinite(least) && !has_zero)
            return "";
        const double positive = std::isfinite(least) ? least : 1, from = has_zero ? zero() : positive;
        const double to = std::max({greatest, positive, 1.01 * from}), air = std::pow(std::max(to / from, 2.0), 0.07);
        std::ostringstream out;
        out.precision(10);
        out << "set logscale " << name << "\nset " << name << "range [" << from / air << ":" << to * air << "]\nset "
            << name << "tics (";
        if (has_zero)
            out << "\"0\" " << zero() << ", ";
        std::vector<double> places = ticks(positive, to * air);
        if (name == "x" && crowded(places, from / air, to * air))
            places = ticks(positive, to * air, false);
        for (const double place : places)
            out << quoted(tick_words(place)) << " " << place << ", ";
        std::string words = out.str();
        return words.erase(words.size() - 2) + ")\n";
    }
};

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
    LogAxis log_x, log_y;
    bool below_zero = false;
    for (const Series &series : plot.series)
        for (const PlotPoint &point : series.points) {
            log_x.see(point.x);
            log_y.see(point.y);
            below_zero |= point.y < 0;
        }
    std::ostringstream out;
    out.precision(10);
    out << "set terminal svg size 820,540 font 'DejaVu Sans,17' background '#ffffff' noenhanced\n"
        << "set output " << quoted(svg) << "\nset encoding utf8\n"
        << "set title " << quoted(plot.title) << "\nset grid lc rgb '#dddddd'\nset border lc rgb '#555555'\n"
        << "set key outside bottom center horizontal samplen 1.2 width -1 font ',14'\n"
        << "set offsets graph 0.05, graph 0.05, graph 0.05, graph 0.05\n"
        << "set xlabel " << quoted(plot.x_label) << (plot.x_label.empty() ? "" : ".\"\\n \"") << "\nset ylabel "
        << quoted(plot.y_label) << "\n";
    if (plot.log_x)
        out << log_x.script("x");
    if (plot.log_y)
        out << log_y.script("y");
    else if (!below_zero && log_y.least < 0.3 * log_y.greatest)
        out << "set yrange [0:*]\n"; // nothing below, so the axis need not go there
    for (std::size_t i = 0; i < plot.x_names.size(); ++i)
        out << (i ? ", " : "set xtics (") << quoted(plot.x_names[i]) << " " << i + 1
            << (i + 1 == plot.x_names.size() ? ")\n" : "");

    std::ostringstream data, curves, labels;
    data.precision(10);
    for (std::size_t i = 0; i < plot.series.size(); ++i) {
        const Series &series = plot.series[i];
        data << "$data" << i << " << EOD\n";
        for (const PlotPoint &point : series.points)
            data << (plot.log_x ? log_x.shown(point.x) : point.x) << " "
                 << (plot.log_y ? log_y.shown(point.y) : point.y) << " " << quoted(point.label) << "\n";
        data << "EOD\n";
        const char *colour = colours[series.colour < 0 ? i % colours.size() : static_cast<std::size_t>(series.colour)];
        const std::size_t dash = series.dash > 0 ? static_cast<std::size_t>(series.dash) : 1 + i / colours.size();
        const bool labelled =
            std::ranges::any_of(series.points, [](const PlotPoint &point) { return !point.label.empty(); });
        curves << (i ? ", " : "plot ") << "$data" << i << " using 1:2 with " << style_words(series.style) << " lw 2 ";
        if (series.style != Series::Style::points)
            curves << "dt " << dash << " ";
        if (series.style != Series::Style::line) // gnuplot refuses points where there are only lines
            curves << "ps 0.9 pt " << i + 4;
        curves << " lc rgb '" << colour << "' title " << quoted(series.name);
        if (labelled)
            labels << ", $data" << i << " using 1:2:3 with labels left offset 0.8,0.3 font ',14' tc rgb '" << colour
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
    for (const std::string &name : plot.x_names)
        shown += (&name == &plot.x_names.front() ? "" : ", ") + name;
    for (const Series &series : plot.series)
        shown += (&series == &plot.series.front() ? ": " : ", ") + series.name;
    replace_between(text, "<title>", "</title>", escaped(plot.title));
    replace_between(text, "<desc>", "</desc>", escaped(shown));
    std::ofstream out(svg, std::ios::binary);
    out << text << std::flush;
    if (text.empty() || !out)
        throw InputError(svg.string(), "cannot be written in full");
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
        FILE *gnuplot = popen("gnuplot -d", "w"); // without its user's own settings
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
