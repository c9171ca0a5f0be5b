// Grades an answer, check by check, and says what is wrong in words that teach.
#pragma once
#include "chapters/01_ray_casting/ray.hpp"
#include "exercises/grading/not_done.hpp"
#include "tests/oracle/oracle.hpp"

#include <concepts>
#include <cstdio>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace course {

// What a check is about. The name says what holds ("from inside, the far side is met"), the reason why it matters and
// what usually went wrong where it does not hold; chapter and heading say where the lesson explains it.
struct Question {
    std::string name, why, chapter, heading;
};

enum class Status { passed, wrong, not_done };

// The outcome of one check; the message tells of the first case that went wrong.
struct Result {
    Question question;
    Status status;
    std::string message;
};

// One thing that a case is made of, as it will be shown: {"ray", ray}, {"radius", 2}.
struct Fact {
    Fact(std::string_view label, const Ray<double> &ray) : name(label), value(ray) {}
    Fact(std::string_view label, const std::string &text) : name(label), value(text) {}
    template <class T> Fact(std::string_view label, const Vec<T> &vector) : name(label), value(Vec<double>(vector)) {}
    template <class T>
        requires std::is_arithmetic_v<T> Fact(std::string_view label, T number)
            : name(label), value(static_cast<double>(number)) {}

        std::string_view name;
        std::variant<double, Vec<double>, Ray<double>, std::string> value;
};

// What the oracle guarantees of its t, generously: 2^-42 of it.
inline constexpr double oracle_ulp = 2048;

// Puts the questions of one check. The first answer that is not as it should be ends the check.
class Check {
  public:
    // What the next questions are about.
    void given(std::vector<Fact> facts) { facts_ = std::move(facts); }

    // Hit or miss as exact arithmetic says, and t within so many ulp of a double.
    void hit(const std::optional<double> &yours, const exact::Answer &expected, double ulp = oracle_ulp);
    // A number, within so many ulp of a double.
    void number(std::string_view what, double yours, double expected, double ulp = 16);
    // A number that was computed in float, within so many ulp of a float.
    void number(std::string_view what, float yours, double expected, double ulp = 8);
    // A colour, each channel within so many ulp of a float.
    void colour(std::string_view what, const Colour &yours, const Vec<double> &expected, double ulp = 8);
    // A vector, each component within so many ulp of the longest.
    void vector(std::string_view what, const Vec<double> &yours, const Vec<double> &expected, double ulp = 16);
    // A whole number or a truth, exactly.
    void same(std::string_view what, std::integral auto yours, std::integral auto expected) {
        whole(what, static_cast<long long>(yours), static_cast<long long>(expected),
              std::is_same_v<decltype(yours), bool>);
    }
    // A count that may not be larger than so many.
    void at_most(std::string_view what, std::size_t yours, std::size_t limit);
    // A property, in words that follow "expected" and "yours".
    void that(bool holds, std::string_view expected, std::string_view yours) {
        ++asked;
        if (!holds)
            fail(std::string(expected), std::string(yours));
    }
    [[noreturn]] void fail(const std::string &expected, const std::string &yours);

    int asked = 0;

  private:
    void whole(std::string_view what, long long yours, long long expected, bool truth);

    std::vector<Fact> facts_;
};

// Runs the checks of one answer and collects what came of them. What is under way is written to the journal, so that
// an answer that crashes leaves word of where.
class Grading {
  public:
    explicit Grading(std::FILE *journal = nullptr) : journal_(journal) {}

    // The lesson that the following checks belong to: the name of its chapter's folder.
    void lesson(std::string chapter) { chapter_ = std::move(chapter); }
    void check(const std::string &name, const std::string &why, const std::string &heading,
               const std::function<void(Check &)> &ask) {
        check(Question{name, why, chapter_, heading}, ask);
    }
    void check(const Question &question, const std::function<void(Check &)> &ask);
    // Wrong if any check found something wrong, else not done if anything is not done; nothing asked is not a pass.
    Status status() const;
    const std::vector<Result> &results() const { return results_; }

  private:
    void note(const char *word, const std::string &name);

    std::FILE *journal_;
    std::string chapter_;
    std::vector<Result> results_;
};

const char *word(Status);

// As the reports show them: the shortest digits that give the very number back.
std::string in_words(double);
std::string in_words(const Vec<double> &);

// An answer in GLSL, as the text of its file: a graphics exercise says `using Task = ShaderText`.
struct ShaderText {
    std::string text;
};

// The main() of a learner's grader: GRADER ANSWER JOURNAL REPORT. The task is a pointer to what the answer handed over.
using Grade = std::function<void(const void *task, Grading &)>;
int grade_answer(int argc, char **argv, const Grade &grade);
std::string text_of(const std::string &file);

} // namespace course
