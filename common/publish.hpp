// How a chapter's experiment leaves its findings: on the terminal and beside the chapter's picture.
#pragma once
#include "common/plot.hpp"
#include "common/program.hpp"
#include "common/report.hpp"

#include <cstdio>

namespace course {

// Prints the table, and writes NAME_<suffix>.json, .md and, of the plot, .svg.
inline void publish(const Program &program, const std::string &suffix, const Report &report, const Plot &plot) {
    std::printf("%s\n%s\n", report.title.c_str(), terminal_table(report.results).c_str());
    write_json(program.beside_picture(suffix + ".json"), report);
    write_markdown(program.beside_picture(suffix + ".md"), report);
    write_plot(program.beside_picture(suffix + ".svg"), plot);
}

} // namespace course
