#include "exercises/grading/grading.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>

namespace course {

namespace {

constexpr std::size_t label_width = 11;

struct Wrong {
    std::string message;
};

// The shortest digits that give this very number back.
std::string text(double number) {
    if (std::isnan(number))
        return "NaN";
    char digits[32];
    return {digits, std::to_chars(digits, digits + sizeof digits, number).ptr};
}

std::string text(const Vec<double> &v) { return "(" + text(v.x) + ", " + text(v.y) + ", " + text(v.z) + ")"; }

std::string text(const Ray<double> &ray) {
    const bool whole = ray.t_min == 0 && ray.t_max == infinity<double>;
    const std::string next = "\n" + std::string(label_width, ' ');
    return "origin    " + text(ray.origin) + next + "direction " + text(ray.direction) +
           (whole ? "" : next + text(ray.t_min) + " < t < " + text(ray.t_max));
}

const std::string &text(const std::string &words) { return words; }

std::string row(std::string_view label, const std::string &value) {
    std::string line(label);
    line.resize(std::max(line.size() + 1, label_width), ' ');
    return line + value + "\n";
}

double ulp_of(double number) {
    const double size = std::abs(number);
    return size < infinity<double> ? std::nextafter(size, infinity<double>) - size : infinity<double>;
}

// How far off, in ulp; where zero was expected, whose ulp says nothing, as it is.
std::string off_by(double error, double unit, double expected) {
    char words[64];
    if (expected == 0)
        std::snprintf(words, sizeof words, " (off by %.3g)", error);
    else
        std::snprintf(words, sizeof words, " (off by %.3g ulp)", error / unit);
    return words;
}

std::string number_in_words(std::string_view what, double number) { return std::string(what) + " = " + text(number); }

} // namespace

std::string in_words(double number) { return text(number); }
std::string in_words(const Vec<double> &v) { return text(v); }

const char *word(Status status) {
    return status == Status::passed ? "passed" : status == Status::wrong ? "wrong" : "not done";
}

Fact::Fact(std::string_view name, double number) : name_(name), value_(number) {}
Fact::Fact(std::string_view name, const Vec<double> &vector) : name_(name), value_(vector) {}
Fact::Fact(std::string_view name, const Ray<double> &ray) : name_(name), value_(ray) {}
Fact::Fact(std::string_view name, const std::string &words) : name_(name), value_(words) {}
Fact::Fact(const Fact &) = default;
Fact::~Fact() = default;

std::string Fact::row() const {
    return course::row(name_, std::visit([](const auto &value) { return text(value); }, value_));
}

void Check::given(std::initializer_list<Fact> facts) { given(std::vector<Fact>(facts)); }
void Check::given(const std::vector<Fact> &facts) {
    facts_.clear();
    facts_.insert(facts_.end(), facts.begin(), facts.end());
}

void Check::fail(std::string_view expected, std::string_view yours) {
    std::string message;
    for (const Fact &fact : facts_)
        message += fact.row();
    throw Wrong{message + row("expected", std::string(expected)) + row("yours", std::string(yours))};
}

void Check::that(bool holds, std::string_view expected, std::string_view yours) {
    ++asked;
    if (!holds)
        fail(expected, yours);
}

void Check::hit(const std::optional<double> &yours, const exact::Answer &expected, double ulp) {
    ++asked;
    const std::string exact_words =
        expected.may_hit() ? number_in_words("t", expected.t) + (expected.may_miss() ? ", or no hit (on the rim)" : "")
                           : "no hit";
    if (!yours) {
        if (!expected.may_miss())
            fail(exact_words, "no hit");
        return;
    }
    if (!expected.may_hit())
        fail(exact_words, number_in_words("t", *yours));
    const double error = std::abs(*yours - expected.t), unit = ulp_of(expected.t);
    if (!(error <= ulp * unit))
        fail(exact_words, number_in_words("t", *yours) + off_by(error, unit, expected.t));
}

void Check::number(std::string_view what, double yours, double expected, double ulp) {
    ++asked;
    const double error = std::abs(yours - expected), unit = ulp_of(expected);
    if (!(yours == expected || error <= ulp * unit))
        fail(number_in_words(what, expected), number_in_words(what, yours) + off_by(error, unit, expected));
}

void Check::number(std::string_view what, float yours, double expected, double ulp) {
    ++asked;
    const double error = std::abs(static_cast<double>(yours) - expected);
    const auto size = static_cast<float>(std::abs(expected));
    const auto unit = static_cast<double>(std::nextafter(size, infinity<float>) - size);
    if (!(static_cast<double>(yours) == expected || error <= ulp * unit))
        fail(number_in_words(what, expected), number_in_words(what, yours) + off_by(error, unit, expected));
}

void Check::colour(std::string_view what, const Colour &yours, const Vec<double> &expected, double ulp) {
    const char *const channels[] = {" red", " green", " blue"};
    for (int i = 0; i < 3; ++i)
        number(std::string(what) + channels[i], yours[i], expected[i], ulp);
}

void Check::vector(std::string_view what, const Vec<double> &yours, const Vec<double> &expected, double ulp) {
    ++asked;
    double error = 0, size = 0;
    bool known = true;
    for (int axis = 0; axis < 3; ++axis) {
        const double difference = std::abs(yours[axis] - expected[axis]);
        known = known && difference < infinity<double>;
        error = std::max(error, difference);
        size = std::max(size, std::abs(expected[axis]));
    }
    if (!(known && error <= ulp * ulp_of(size)))
        fail(std::string(what) + " = " + text(expected),
             std::string(what) + " = " + text(yours) + (known ? off_by(error, ulp_of(size), size) : ""));
}

void Check::whole(std::string_view what, long long yours, long long expected, bool truth) {
    ++asked;
    const auto words = [&](long long value) {
        return std::string(what) + (truth ? value ? ": yes" : ": no" : " = " + std::to_string(value));
    };
    if (yours != expected)
        fail(words(expected), words(yours));
}

void Check::at_most(std::string_view what, std::size_t yours, std::size_t limit) {
    ++asked;
    if (yours > limit)
        fail(std::string(what) + ": at most " + std::to_string(limit), std::to_string(yours));
}

void Grading::note(const char *what, const std::string &name) {
    if (journal_) {
        std::fprintf(journal_, "%s\t%s\n", what, name.c_str());
        std::fflush(journal_);
    }
}

void Grading::check(const Question &question, Ask ask) {
    note("running", question.name);
    Result result{question, Status::passed, ""};
    Check check;
    const auto wrong = [&](const std::string &message) { result = {question, Status::wrong, message}; };
    try {
        ask(check);
        if (check.asked == 0)
            wrong("this check asks nothing\n");
    } catch (const NotDone &) {
        result.status = Status::not_done;
    } catch (const Wrong &found) {
        wrong(found.message);
    } catch (const std::exception &error) {
        wrong(row("yours", "threw an exception: " + std::string(error.what())));
    } catch (...) {
        wrong(row("yours", "threw an exception"));
    }
    note(word(result.status), question.name);
    results_.push_back(result);
}

Status Grading::status() const {
    const auto any = [&](Status status) { return std::ranges::count(results_, status, &Result::status) > 0; };
    return results_.empty() || any(Status::wrong) ? Status::wrong
           : any(Status::not_done)                ? Status::not_done
                                                  : Status::passed;
}

} // namespace course
