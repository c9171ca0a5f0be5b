#include "tests/exercises/answers.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>

namespace course {

namespace {

// A copy of the results in which each line is status, name, chapter, heading, message in one line.
std::string written(const Grading &grading) {
    std::string lines;
    for (const Result &result : grading.results()) {
        std::string message = result.message + result.question.why;
        std::ranges::replace(message, '\n', ' ');
        lines += std::string(word(result.status)) + "\t" + result.question.name + "\t" + result.question.chapter +
                 "\t" + result.question.heading + "\t" + message + "\n";
    }
    return lines + "end\n";
}

struct Row {
    std::string status, name, chapter, heading, message;
};

// Grades in a process of its own, so that an answer may crash or hang. Crashes are a row of their own.
std::vector<Row> graded(const Candidate &answer, const Grade &grade) {
    int ends[2];
    if (pipe(ends) != 0)
        std::abort();
    std::fflush(nullptr);
    const pid_t child = fork();
    if (child == 0) {
        close(ends[0]);
        alarm(60);
        Grading grading;
        grade(answer.task, grading);
        const std::string lines = written(grading);
        for (std::size_t done = 0; done < lines.size();)
            if (const ssize_t now = write(ends[1], lines.data() + done, lines.size() - done); now > 0)
                done += static_cast<std::size_t>(now);
        _exit(0);
    }
    close(ends[1]);
    std::string lines;
    char block[4096];
    for (ssize_t got; (got = read(ends[0], block, sizeof block)) > 0;)
        lines.append(block, static_cast<std::size_t>(got));
    close(ends[0]);
    int status = 0;
    waitpid(child, &status, 0);

    std::vector<Row> rows;
    std::istringstream in(lines);
    bool ended = false;
    for (std::string line; std::getline(in, line);) {
        std::istringstream fields(line);
        Row row;
        for (std::string *field : {&row.status, &row.name, &row.chapter, &row.heading, &row.message})
            std::getline(fields, *field, '\t');
        if (row.status == "end")
            ended = true;
        else
            rows.push_back(row);
    }
    if (!ended)
        rows.push_back({"wrong", WTERMSIG(status) == SIGALRM ? "it ends" : "it does not crash", "", "", "stopped"});
    return rows;
}

// What the mistake's own comment says catches it: the rest of the line after "Caught by: ".
std::string catcher(const std::string &file) {
    const std::string text = text_of(file), mark = "Caught by: ";
    const auto at = text.find(mark);
    return at == text.npos ? "" : text.substr(at + mark.size(), text.find('\n', at) - at - mark.size());
}

bool has_heading(const std::string &file, const std::string &heading) {
    std::istringstream lines(text_of(file));
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with("#") && line.find_first_not_of("# ") != line.npos &&
            line.substr(line.find_first_not_of("# ")) == heading)
            return true;
    return false;
}

} // namespace

int check_answers(const std::string &exercise, const std::vector<Candidate> &answers, const Grade &grade) {
    int wrong = 0, mistakes = 0, caught = 0;
    const auto complain = [&](const std::string &words) {
        std::printf("%s: %s\n", exercise.c_str(), words.c_str());
        ++wrong;
    };
    for (const Candidate &answer : answers) {
        const std::string role = std::filesystem::path(answer.file).parent_path().filename();
        const std::vector<Row> rows = graded(answer, grade);
        if (rows.empty())
            complain(answer.file + ": nothing was asked");
        if (role == "mistakes") {
            ++mistakes;
            const auto first = std::ranges::find(rows, "wrong", &Row::status);
            const std::string by = catcher(answer.file);
            if (by.empty())
                complain(answer.file + " does not say which check catches it (Caught by: ...)");
            else if (first == rows.end())
                complain(answer.file + " is not caught");
            else if (first->name != by || first->message.empty())
                complain(answer.file + " should be caught by '" + by + "', not by '" + first->name +
                         "': " + first->message);
            else
                ++caught;
            continue;
        }
        const std::string should = role == "starter" ? "not done" : "passed";
        for (const Row &row : rows) {
            if (row.status != should)
                complain(answer.file + " should be " + should + ", but '" + row.name + "' is " + row.status + ": " +
                         row.message);
            const std::string lesson = "chapters/" + row.chapter + "/README.md";
            if (role == "solution" && !(std::filesystem::exists(lesson) && has_heading(lesson, row.heading)))
                complain("'" + row.name + "' sends to \"" + row.heading + "\", which is no heading of " + lesson);
        }
    }
    if (mistakes < 2)
        complain("fewer than two mistakes");
    std::printf("%s: %d of %d mistakes caught\n", exercise.c_str(), caught, mistakes);
    return wrong == 0 ? 0 : 1;
}

} // namespace course
