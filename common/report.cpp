#include "common/report.hpp"

#include "common/output_files.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

namespace course {
namespace {

std::string processor() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);)
        if (line.starts_with("model name"))
            return line.substr(line.find(':') + 2);
    return "unknown processor";
}

std::string compiler() {
#if defined(__clang__)
    return "clang " __clang_version__;
#else
    return "g++ " __VERSION__;
#endif
}

std::string shown(double number) {
    char text[40];
    const double size = std::abs(number);
    if (number == 0 || (size >= 1e-3 && size < 1e7))
        std::snprintf(text, sizeof text, "%.*f",
                      number == 0 ? 0 : std::max(0, 3 - static_cast<int>(std::floor(std::log10(size)))), number);
    else
        std::snprintf(text, sizeof text, "%.3g", number);
    return text;
}

struct Shown {
    std::string operator()(bool value) const { return value ? "yes" : "no"; }
    std::string operator()(std::int64_t value) const { return std::to_string(value); }
    std::string operator()(double value) const { return shown(value); }
    std::string operator()(const std::string &value) const { return value; }
};

std::vector<std::string> columns_of(const std::vector<Row> &rows) {
    std::vector<std::string> columns;
    for (const Row &row : rows)
        for (const auto &[name, value] : row.values())
            if (std::ranges::find(columns, name) == columns.end())
                columns.push_back(name);
    return columns;
}

// Letters that continue a UTF-8 sequence take no room of their own.
std::size_t letters(const std::string &text) {
    return static_cast<std::size_t>(std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}

std::string table(const std::vector<Row> &rows, const std::string &before, const std::string &between,
                  const std::string &after, bool rule) {
    const auto columns = columns_of(rows);
    std::vector<std::vector<std::string>> cells{columns};
    std::vector<bool> is_number(columns.size(), true);
    for (const Row &row : rows) {
        auto &line = cells.emplace_back();
        for (std::size_t i = 0; i < columns.size(); ++i) {
            const Value *value = row.find(columns[i]);
            line.push_back(value ? std::visit(Shown{}, *value) : "");
            if (value && std::holds_alternative<std::string>(*value))
                is_number[i] = false;
        }
    }
    std::vector<std::size_t> widths(columns.size(), 3);
    for (const auto &line : cells)
        for (std::size_t i = 0; i < line.size(); ++i)
            widths[i] = std::max(widths[i], letters(line[i]));

    std::string text;
    for (std::size_t l = 0; l < cells.size(); ++l) {
        text += before;
        for (std::size_t i = 0; i < columns.size(); ++i) {
            const std::string gap(widths[i] - letters(cells[l][i]), ' ');
            text += (i ? between : "") + (is_number[i] ? gap + cells[l][i] : cells[l][i] + gap);
        }
        text += after + "\n";
        if (l == 0 && rule) {
            text += "|";
            for (std::size_t i = 0; i < columns.size(); ++i)
                text += " " + std::string(widths[i] - 1, '-') + (is_number[i] ? ":" : "-") + " |";
            text += "\n";
        }
    }
    return text;
}

struct AsJson {
    nlohmann::ordered_json operator()(double value) const {
        return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json();
    }
    nlohmann::ordered_json operator()(const auto &value) const { return value; }
};

nlohmann::ordered_json as_json(const Row &row) {
    auto object = nlohmann::ordered_json::object();
    for (const auto &[name, value] : row.values())
        object[name] = std::visit(AsJson{}, value);
    return object;
}

} // namespace

Row::Row() = default;
Row::Row(const Row &) = default;
Row::Row(Row &&) noexcept = default;
Row &Row::operator=(const Row &) = default;
Row &Row::operator=(Row &&) noexcept = default;
Row::~Row() = default;

Row &Row::set(const std::string &name, const Value &value) {
    const auto at = std::ranges::find(values_, name, &std::pair<std::string, Value>::first);
    if (at != values_.end())
        at->second = value;
    else
        values_.emplace_back(name, value);
    return *this;
}
Row &Row::set(const std::string &name, bool yes) { return set(name, Value(yes)); }
Row &Row::set(const std::string &name, std::int64_t number) { return set(name, Value(number)); }
Row &Row::set(const std::string &name, double number) { return set(name, Value(number)); }
Row &Row::set(const std::string &name, const std::string &text) { return set(name, Value(text)); }
Row &Row::set(const std::string &name, const char *text) { return set(name, Value(std::string(text))); }

const Value *Row::find(const std::string &name) const {
    const auto at = std::ranges::find(values_, name, &std::pair<std::string, Value>::first);
    return at == values_.end() ? nullptr : &at->second;
}

std::string terminal_table(const std::vector<Row> &rows) { return table(rows, "", "  ", "", false); }

std::string markdown_table(const std::vector<Row> &rows) { return table(rows, "| ", " | ", " |", true); }

// What is not UTF-8, as a file's name may be, is replaced.
constexpr auto instead = nlohmann::ordered_json::error_handler_t::replace;

std::string json_line(const Row &row) { return as_json(row).dump(-1, ' ', false, instead); }

std::string machine_in_words() {
    return processor() + ", " + std::to_string(std::thread::hardware_concurrency()) + " cores, " + compiler();
}

void write_json(const std::filesystem::path &file, const Report &report) {
    nlohmann::ordered_json json;
    json["machine"] = {
        {"processor", processor()}, {"cores", std::thread::hardware_concurrency()}, {"compiler", compiler()}};
    json["options"] = as_json(report.options);
    json["results"] = nlohmann::ordered_json::array();
    for (const Row &row : report.results)
        json["results"].push_back(as_json(row));
    write_text(file, json.dump(1, ' ', false, instead) + "\n");
}

void write_markdown(const std::filesystem::path &file, const Report &report) {
    std::string text = "# " + report.title + "\n\nMeasured on: " + machine_in_words() + "\n\n";
    if (!report.options.values().empty())
        text += markdown_table({report.options}) + "\n";
    write_text(file, text + markdown_table(report.results));
}

} // namespace course
