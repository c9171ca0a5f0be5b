// Plots as SVG files (gnuplot, a program of its own; where it is missing, plots are left out with one line).
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace course {

struct PlotPoint {
    double x, y;
    std::string label = {}; // written beside the point
};

struct Series {
    enum class Style { line, points, line_and_points };
    std::string name;
    std::vector<PlotPoint> points;
    Style style = Style::line_and_points;
    int colour = -1; // 0 to 7; without, each series has its own as far as there are eight
    int dash = 0;    // 1: a whole line, 2 to 5: broken ones; without, lines are broken where colours repeat
};

struct Plot {
    std::string title, x_label, y_label;
    bool log_x = false, log_y = false;
    std::vector<Series> series;
    std::vector<std::string> x_names = {}; // what x = 1, 2, ... stand for, where they stand for something
};

// Writes the plot. On a logarithmic axis a value that is not positive stands at the axis's beginning, marked 0. Colours
// can be told apart by colour-blind readers; every series has its own mark. Returns false, after one line on stderr,
// where gnuplot is not installed.
bool write_plot(const std::filesystem::path &svg, const Plot &plot);

} // namespace course
