// The grader of one exercise as a program: loads an answer, grades it, writes the report that the learner reads.
#include "exercises/grading/grading.hpp"

#include <dlfcn.h>

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace course {

std::string text_of(const std::string &file) {
    std::ifstream in(file);
    std::ostringstream whole;
    whole << in.rdbuf();
    if (!in)
        throw std::runtime_error(file + " cannot be read");
    return whole.str();
}

namespace {

// The text in lines of at most 100 letters.
std::string folded(const std::string &words, const std::string &indent) {
    std::istringstream in(words);
    std::string lines, line;
    for (std::string next; in >> next;) {
        if (!line.empty() && indent.size() + line.size() + 1 + next.size() > 100) {
            lines += indent + line + "\n";
            line.clear();
        }
        line += (line.empty() ? "" : " ") + next;
    }
    return lines + indent + line + "\n";
}

std::string report(const Grading &grading) {
    std::string lines;
    for (const Result &result : grading.results())
        lines += "  " + (word(result.status) + std::string(11, ' ')).substr(0, 11) + result.question.name + "\n";
    for (const Result &result : grading.results()) {
        if (result.status != Status::wrong)
            continue;
        lines += "\nFirst to mend: " + result.question.name + "\n\n";
        std::istringstream message(result.message);
        for (std::string line; std::getline(message, line);)
            lines += "    " + line + "\n";
        lines += "\n" + folded(result.question.why, "  ") + "  Read: chapters/" + result.question.chapter +
                 "/README.md, \"" + result.question.heading + "\"\n";
        break;
    }
    return lines;
}

const void *handed_over(const std::string &library) {
    void *loaded = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
    void *symbol = loaded ? dlsym(loaded, "course_task") : nullptr;
    if (!symbol)
        throw std::runtime_error(dlerror());
    return reinterpret_cast<const void *(*)()>(symbol)();
}

} // namespace

int grade_answer(int argc, char **argv, const Grade &grade) {
    if (argc != 4) {
        std::fprintf(stderr, "usage: GRADER ANSWER JOURNAL REPORT\n");
        return 2;
    }
    const std::string answer = argv[1];
    try {
        std::FILE *journal = std::fopen(argv[2], "w");
        std::ofstream report_file(argv[3]);
        if (!journal || !report_file)
            throw std::runtime_error("the journal or the report cannot be written");
        Grading grading(journal);
        if (answer.ends_with(".glsl")) {
            const GlslAnswer shader{text_of(answer)};
            grade(&shader, grading);
        } else {
            grade(handed_over(answer), grading);
        }
        report_file << report(grading) << std::flush;
        std::fprintf(journal, "end\t%s\n", word(grading.status()));
        std::fclose(journal);
        return grading.status() == Status::passed ? 0 : grading.status() == Status::wrong ? 1 : 3;
    } catch (const std::exception &error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
}

} // namespace course
