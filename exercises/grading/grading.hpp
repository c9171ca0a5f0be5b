// Grades an answer, check by check, and says what is wrong in words that teach.
#pragma once
#include "chapters/01_ray_casting/ray.hpp"
#include "exercises/grading/not_done.hpp"
#include "tests/oracle/oracle.hpp"

#include <concepts>
#include <cstdio>
#include <functional>
#include <initializer_list>
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

// One thing that a case is made of, as it will be shown: {"ray", ray}, {"radius", 2}. (What tests use much is defined
// in grading.cpp, so that they compile quickly.)
class Fact {
  public:
    Fact(std::string_view name, double number);
    Fact(std::string_view name, const Vec<double> &vector);
    Fact(std::string_view name, const Ray<double> &ray);
    Fact(std::string_view name, const std::string &text);
    template <class T> Fact(std::string_view name, const Vec<T> &vector) : Fact(name, Vec<double>(vector)) {}
    template <class T>
        requires std::is_arithmetic_v<T> Fact(std::string_view name, T number)
            : Fact(name, static_cast<double>(number)) {}
        Fact(const Fact &);
        ~Fact();

        std::string row() const;

      private:
        std::string_view name_;
        std::variant<double, Vec<double>, Ray<double>, std::string> value_;
};

// What the oracle guarantees of its t, generously: 2^-42 of it.
inline constexpr double oracle_ulp = 2048;

// Puts the questions of one check. The first answer that is not as it should be ends the check.
class Check {
  public:
    // What the next questions are about.
    void given(std::initializer_list<Fact>);
    void given(const std::vector<Fact> &);

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
    void that(bool holds, std::string_view expected, std::string_view yours);
    [[noreturn]] void fail(std::string_view expected, std::string_view yours);

    int asked = 0;

  private:
    void whole(std::string_view what, long long yours, long long expected, bool truth);

    std::vector<Fact> facts_;
};

// Refers to a function object that puts the questions.
class Ask {
  public:
    template <class F> Ask(const F &f)
        : object_(&f), call_([](const void *object, Check &check) { (*static_cast<const F *>(object))(check); }) {}
    void operator()(Check &check) const { call_(object_, check); }

  private:
    const void *object_;
    void (*call_)(const void *, Check &);
};

// Runs the checks of one answer and collects what came of them. What is under way is written to the journal, so that
// an answer that crashes leaves word of where.
class Grading {
  public:
    explicit Grading(std::FILE *journal = nullptr) : journal_(journal) {}

    // The lesson that the following checks belong to: the name of its chapter's folder.
    void lesson(std::string chapter) { chapter_ = std::move(chapter); }
    void check(const char *name, const char *why, const char *heading, Ask ask) {
        check(Question{name, why, chapter_, heading}, ask);
    }
    void check(const Question &question, Ask ask);
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

// An answer in GLSL, as the text of its file: a graphics exercise says `using Task = GlslAnswer`.
struct GlslAnswer {
    std::string text;
};

// The main() of a learner's grader: GRADER ANSWER JOURNAL REPORT. The task is a pointer to what the answer handed over.
using Grade = std::function<void(const void *task, Grading &)>;
int grade_answer(int argc, char **argv, const Grade &grade);
std::string text_of(const std::string &file);

} // namespace course
