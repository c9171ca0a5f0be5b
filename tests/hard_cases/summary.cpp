#include "tests/hard_cases/summary.hpp"

#include <algorithm>
#include <map>

namespace course::hard {
namespace {

std::string text_of(const Row &row, const std::string &name) {
    const Value *value = row.find(name);
    const auto *text = value ? std::get_if<std::string>(value) : nullptr;
    return text ? *text : "";
}

double number_of(const Row &row, const std::string &name) {
    const Value *value = row.find(name);
    if (!value)
        return 0;
    if (const auto *whole = std::get_if<std::int64_t>(value))
        return static_cast<double>(*whole);
    const auto *number = std::get_if<double>(value);
    return number ? *number : 0;
}

bool flag_of(const Row &row, const std::string &name, bool otherwise) {
    const Value *value = row.find(name);
    const auto *flag = value ? std::get_if<bool>(value) : nullptr;
    return flag ? *flag : otherwise;
}

std::string kernel_of(const Row &row) { return text_of(row, "kernel") + ", " + text_of(row, "scalar"); }

// The rows of one kernel in several cells, added up.
struct Sum {
    double cases = 0, wrong = 0, nan = 0, t_error = 0, worst = -1;
    std::string worst_parameter;
    const Row *first = nullptr;
    bool reached = true;

    void add(const Row &row) {
        if (!first)
            first = &row;
        cases += number_of(row, "cases");
        wrong += number_of(row, "misclassified");
        nan += number_of(row, "nan");
        t_error = std::max(t_error, number_of(row, "t_error_ulp_max"));
        reached = reached && flag_of(row, "reached", true);
        if (const double per_million = number_of(row, "misclassified_per_million"); per_million > worst) {
            worst = per_million;
            worst_parameter = text_of(row, "parameter");
        }
    }
    double per_million() const { return cases > 0 ? 1e6 * wrong / cases : 0; }
};

} // namespace

std::vector<std::string> distinct(const std::vector<Row> &rows, const std::string &name) {
    std::vector<std::string> found;
    for (const Row &row : rows)
        if (const std::string text = text_of(row, name); std::ranges::find(found, text) == found.end())
            found.push_back(text);
    return found;
}

std::vector<Row> summary_of_family(const std::vector<Row> &rows, const std::string &family) {
    std::vector<std::string> order;
    std::map<std::string, Sum> sums;
    for (const Row &row : rows)
        if (text_of(row, "family") == family) {
            const std::string key = text_of(row, "test") + ": " + kernel_of(row);
            if (!sums.contains(key))
                order.push_back(key);
            sums[key].add(row);
        }
    std::vector<Row> lines;
    for (const std::string &key : order) {
        const Sum &sum = sums[key];
        const Row &first = *sum.first;
        const bool is_default = flag_of(first, "default", false);
        Row line;
        line.set("test", text_of(first, "test")).set("kernel", kernel_of(first));
        line.set("cases", static_cast<std::int64_t>(sum.cases)).set("wrong per million", sum.per_million());
        line.set("worst", sum.worst > 0 ? sum.worst_parameter : "-").set("t off, ulp", sum.t_error);
        line.set("NaN", static_cast<std::int64_t>(sum.nan));
        if (first.find("ns_per_test")) {
            line.set("ns", number_of(first, "ns_per_test")).set("ns, hard", number_of(first, "ns_per_test_hard"));
            line.set("hit, %", 100 * number_of(first, "hit_share"));
            line.set("hard hit, %", 100 * number_of(first, "hit_share_hard"));
        }
        const bool asked = is_default || first.find("reached");
        line.set("threshold", !asked ? "" : sum.reached ? "reached" : "MISSED");
        lines.push_back(line);
    }
    return lines;
}

Plot plot_of_test(const std::vector<Row> &rows, const std::string &test) {
    Plot plot{.title = "Ray and " + test + ": speed against error on the hard cases",
              .x_label = "time per test on random rays, ns",
              .y_label = "wrong answers per million",
              .log_x = true,
              .log_y = true,
              .series = {}};
    std::vector<std::string> order;
    std::map<std::string, Sum> sums;
    for (const Row &row : rows)
        if (text_of(row, "test") == test && row.find("ns_per_test")) {
            if (!sums.contains(kernel_of(row)))
                order.push_back(kernel_of(row));
            sums[kernel_of(row)].add(row);
        }
    std::vector<PlotPoint> points;
    for (const std::string &kernel : order) {
        const Sum &sum = sums[kernel];
        points.push_back({number_of(*sum.first, "ns_per_test"), sum.per_million(), kernel});
    }
    std::vector<PlotPoint> frontier;
    for (const PlotPoint &point : points)
        if (std::ranges::none_of(points, [&](const PlotPoint &other) {
                return other.x <= point.x && other.y <= point.y && (other.x < point.x || other.y < point.y);
            }))
            frontier.push_back({point.x, point.y});
    std::ranges::sort(frontier, {}, &PlotPoint::x);
    for (const PlotPoint &point : points)
        plot.series.push_back({point.label, {{point.x, point.y}}, Series::Style::points});
    if (!points.empty())
        plot.series.push_back({"frontier", frontier, Series::Style::line, 6, 1});
    return plot;
}

} // namespace course::hard
