// What a measurement leaves: rows of named values, shown as a table and written as JSON and Markdown.
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace course {

using Value = std::variant<bool, std::int64_t, double, std::string>;

// Values in the order in which they are shown. What copies, moves and ends them is in report.cpp: it would be compiled
// anew into each of the many sources that make rows.
class Row {
  public:
    Row();
    Row(const Row &);
    Row(Row &&) noexcept;
    Row &operator=(const Row &);
    Row &operator=(Row &&) noexcept;
    ~Row();

    Row &set(const std::string &name, bool yes);
    Row &set(const std::string &name, std::int64_t number);
    Row &set(const std::string &name, double number);
    Row &set(const std::string &name, const std::string &text);
    Row &set(const std::string &name, const char *text);
    Row &set(const std::string &name, const Value &value);
    template <class Number>
    requires std::is_arithmetic_v<Number> Row &set(const std::string &name, Number number) {
        if constexpr (std::is_integral_v<Number>)
            return set(name, static_cast<std::int64_t>(number));
        else
            return set(name, static_cast<double>(number));
    }
    const Value *find(const std::string &name) const; // nullptr where the row has no such value
    const std::vector<std::pair<std::string, Value>> &values() const { return values_; }

  private:
    std::vector<std::pair<std::string, Value>> values_;
};

struct Report {
    std::string title;
    Row options; // with what the measurement was run
    std::vector<Row> results;
};

// A table with a column for every name that some row has, in the order of first appearance: aligned for a terminal,
// or in Markdown. Numbers are right-aligned with four significant digits.
std::string terminal_table(const std::vector<Row> &rows);
std::string markdown_table(const std::vector<Row> &rows);

// The row as a JSON object in one line.
std::string json_line(const Row &row);

// {"machine": {...}, "options": {...}, "results": [...]}; NaN and infinities become null.
void write_json(const std::filesystem::path &file, const Report &report);

// The title, the machine, the options and the table.
void write_markdown(const std::filesystem::path &file, const Report &report);

// One line about this machine: processor, cores, compiler.
std::string machine_in_words();

} // namespace course
