// Every ./course command that a text shows is one that the launcher knows, with options that its program has and values
// that it takes. The commands that only stand for others (FILE, NAME, N) are checked as far as they go, and listed.
#include "tests/house/pattern.hpp"
#include "tests/house/texts.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <map>
#include <optional>
#include <set>

namespace {

using namespace texts;

struct Command {
    std::string text;
    fs::path where;
};

// From `inline code`, which may be broken over two lines, and from blocks, where a comment follows # or some spaces.
std::vector<Command> commands_of(const fs::path &file) {
    static const Pattern inline_code("`(\\./course[^`]*)`"), spaces("\\s+"), comment("\\s+#.*$|   +.*$");
    std::vector<Command> commands;
    const auto add = [&](const std::string &text) {
        for (std::size_t from = 0; from < text.size();) { // a && b is two commands
            const std::size_t to = std::min(text.find("&&", from), text.size());
            const std::string one = trimmed(spaces.replaced_in(text.substr(from, to - from), " "));
            if (one.starts_with("./course"))
                commands.push_back({one, file});
            from = to + 2;
        }
    };
    std::string prose;
    bool in_code = false;
    for (const std::string &line : lines_of(file)) {
        if (trimmed(line).starts_with("```"))
            in_code = !in_code;
        else if (in_code || line.starts_with("    ./course"))
            add(comment.replaced_in(trimmed(line), ""));
        else
            prose += line + "\n";
    }
    for (const Found &found : inline_code.all_in(prose))
        add(found[1]);
    return commands;
}

std::vector<std::string> words_of(const std::string &command) {
    std::istringstream in(command);
    std::vector<std::string> words;
    for (std::string word; in >> word;)
        words.push_back(word);
    return words;
}

// FILE, NAME, N, NN_name: something that the reader puts in.
bool is_placeholder(const std::string &word) {
    static const Pattern pattern("[A-Z]+|NN_[a-z_]+|…|\\.\\.\\.");
    return pattern.matches(word);
}

std::string output_of(const std::string &command) {
    std::string output;
    FILE *pipe = popen((command + " 2>&1 </dev/null").c_str(), "r");
    if (!pipe)
        return output;
    std::array<char, 4096> part;
    while (const std::size_t count = fread(part.data(), 1, part.size(), pipe))
        output.append(part.data(), count);
    pclose(pipe);
    return output;
}

std::optional<std::string> chapter_called(const std::string &word) {
    const std::string number = word.size() == 1 ? "0" + word : word;
    for (const std::string &chapter : chapters())
        if (chapter == word || chapter.substr(0, 2) == number || chapter.substr(3) == word)
            return chapter;
    return {};
}

bool exercise_called(const std::string &word) {
    const std::string begins = word.size() == 1 ? "0" + word : word;
    for (const auto &entry : fs::directory_iterator("exercises")) {
        const std::string name = entry.path().filename().string();
        if (fs::exists(entry.path() / "test.cpp") && (name.starts_with(begins) || name.substr(3).starts_with(begins)))
            return true;
    }
    return false;
}

// The options of a program, as its --help shows them, with what each takes: INT, TEXT:{box,grid} ..., or nothing.
const std::map<std::string, std::string> &options_of(const std::string &program) {
    static std::map<std::string, std::map<std::string, std::string>> known;
    if (!known.contains(program)) {
        static const Pattern line(R"(\n  (?:-\w,)?(--[\w-]+)(?: ((?:INT|UINT|FLOAT|TEXT)[^ \n=]*))?)");
        const std::string help = output_of(program + " --help");
        auto &options = known[program];
        for (const Found &found : line.all_in(help))
            options[found[1]] = found[2];
    }
    return known.at(program);
}

// What is wrong with an option's value, or nothing.
std::string objection_to_value(const std::string &option, const std::string &type, const std::string &value) {
    static const Pattern number(R"(-?[0-9]+(\.[0-9]*)?(e-?[0-9]+)?)"), whole(R"(-?[0-9]+)");
    const auto choices = type.find('{');
    if (choices != std::string::npos) {
        std::string list = type.substr(choices + 1, type.find('}') - choices - 1);
        if (("," + list + ",").find("," + value + ",") == std::string::npos)
            return option + " takes one of " + list + ", not " + value;
    } else if (type.starts_with("FLOAT") ? !number.matches(value) : !type.starts_with("TEXT") && !whole.matches(value))
        return option + " takes a number, not " + value;
    return "";
}

// What is wrong with the options and their values, or nothing.
std::string objection(const std::string &program, const std::vector<std::string> &arguments, bool &only_a_form) {
    if (!fs::exists(program))
        return program + " is not built";
    const auto &options = options_of(program);
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const std::string &option = arguments[i];
        if (!options.contains(option))
            return option + " is no option of " + program;
        const std::string &type = options.at(option);
        if (type.empty())
            continue;
        if (++i == arguments.size())
            return option + " needs a value";
        if (is_placeholder(arguments[i]))
            only_a_form = true;
        else if (const std::string wrong = objection_to_value(option, type, arguments[i]); !wrong.empty())
            return wrong;
    }
    return "";
}

std::string objection(const std::vector<std::string> &words, bool &only_a_form) {
    static const std::string build = COURSE_BUILD_FOLDER, launcher = text_of("course");
    if (words.size() < 2)
        return "";
    const std::string &command = words[1];
    std::vector<std::string> rest(words.begin() + 2, words.end());
    if (is_placeholder(command)) {
        only_a_form = true;
        return "";
    }
    if (command != "help" && !Pattern("\n" + command + "\\) ").occurs_in(launcher))
        return "the launcher has no command " + command;
    if (command == "run" || command == "view") {
        if (rest.empty() || rest[0] == "--full")
            return "";
        if (is_placeholder(rest[0])) {
            only_a_form = true;
            return "";
        }
        const auto chapter = chapter_called(rest[0]);
        if (!chapter)
            return "no chapter " + rest[0];
        rest.erase(rest.begin());
        if (command == "view")
            rest.push_back("--window");
        return objection(build + "/chapters/" + *chapter, rest, only_a_form);
    }
    if (command == "compare")
        return objection(build + "/chapters/16_comparison", rest, only_a_form);
    if (command == "accuracy")
        return objection(build + "/tests/accuracy", rest, only_a_form);
    if (command == "claims")
        return objection(build + "/tools/claims", rest, only_a_form);
    if (command == "test") {
        if (rest.empty() || (rest.size() == 2 && rest[0] == "--label" &&
                             (is_placeholder(rest[1]) || fs::exists(fs::path("tests") / rest[1]))))
            return "";
        return "test takes --label and a folder of tests/";
    }
    if (command == "exercise") {
        if (rest.empty())
            return "";
        only_a_form = std::ranges::any_of(rest, is_placeholder);
        const std::string known = text_of("exercises/exercise.sh");
        const bool verb = known.find("./course exercise " + rest[0] + " ") != std::string::npos;
        const std::string name = verb ? (rest.size() > 1 ? rest[1] : "") : rest[0];
        if (rest[0] != "list" && rest[0] != "grade" && !name.empty() && !is_placeholder(name) && !exercise_called(name))
            return "no exercise " + name;
        for (const std::string &word : rest)
            if (word.starts_with("--") && known.find(word) == std::string::npos)
                return word + " is no option of ./course exercise";
        return "";
    }
    if (command == "slides")
        return rest.empty() ||
                       (rest.size() == 1 && text_of("slides/build.sh").find("1-" + rest[0] + ")") != std::string::npos)
                   ? ""
                   : "slides does not take " + rest[0];
    return rest.empty() ? "" : command + " takes nothing";
}

TEST(Commands, OfTheTextsAreUnderstood) {
    std::set<std::string> seen, forms;
    for (const fs::path &file : all_texts())
        for (const Command &command : commands_of(file)) {
            if (!seen.insert(command.text).second)
                continue;
            bool only_a_form = false;
            EXPECT_EQ(objection(words_of(command.text), only_a_form), "") << command.where << ": " << command.text;
            if (only_a_form)
                forms.insert(command.text);
        }
    EXPECT_GT(seen.size(), 50u);
    std::printf("%zu commands are understood; of these, %zu stand for others:\n", seen.size(), forms.size());
    for (const std::string &form : forms)
        std::printf("    %s\n", form.c_str());
}

// The test itself must be able to fail.
TEST(Commands, ThatAreWrongAreNoticed) {
    bool form = false;
    for (const char *wrong :
         {"./course dance", "./course run 99", "./course run 1 --no-such-option", "./course view 88",
          "./course run 1 --width wide", "./course accuracy --famly H1", "./course test --quick",
          "./course exercise 99_nothing", "./course doctor now", "./course claims --claims C1",
          "./course run 12 --structure ball", "./course run 1 --width"})
        EXPECT_NE(objection(words_of(wrong), form), "") << wrong;
}

} // namespace
