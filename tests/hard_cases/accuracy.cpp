// The program behind ./course accuracy: every intersection test on its hard cases, speed against error.
#include "common/command_line.hpp"
#include "common/output_files.hpp"
#include "common/program.hpp"
#include "common/progress.hpp"
#include "tests/hard_cases/frontier.hpp"
#include "tests/hard_cases/reader.hpp"
#include "tests/hard_cases/shader_rows.hpp"
#include "tests/hard_cases/suites.hpp"
#include "tests/hard_cases/summary.hpp"

#include <algorithm>
#include <cstdio>

using namespace course;

namespace {

struct Options {
    hard::Settings settings;
    std::string out_folder = "out", kernel_file;
    bool frontier = false;
};

const std::vector<std::string> families{"H1", "H2",  "H3",  "H4",  "H5",  "H6",  "H7", "H8",
                                        "H9", "H10", "H11", "H12", "H13", "H14", "H15"};

Options options_from(int argc, char **argv) {
    Options options;
    bool quick = false;
    int cases = 0;
    std::vector<std::string> replaced;
    CommandLine line("accuracy", "Hard cases for every intersection test: speed against error, judged exactly");
    line.option("--family", options.settings.families, "Only this family, H1 to H15; may be given again");
    line.option("--seed", options.settings.seed, "Which random cases are drawn");
    line.option("--cases", cases, {0, 1e9}, "Cases in a cell (0: 20000 with --quick, else a million)");
    line.option("--kernel", options.kernel_file,
                "Your own intersection code as a row (see tests/hard_cases/README.md)");
    line.option("--out-folder", options.out_folder, "Where accuracy.json, accuracy.md and the plots go");
    line.option("--replace-default", replaced, "TEST=KERNEL, as in sphere=textbook: the suite must then fail");
    line.flag("--frontier", options.frontier, "Also with --quick: what the defaults cost beside the textbook's forms");
    line.flag("--quick", quick, "20000 cases a cell");
    line.parse(argc, argv);
    for (const std::string &family : options.settings.families)
        if (std::ranges::find(families, family) == families.end())
            throw InputError("--family " + family, "there is no such family, only H1 to H15");
    auto &settings = options.settings;
    for (const std::string &text : replaced) {
        const auto middle = text.find('=');
        if (middle == std::string::npos)
            throw InputError("--replace-default " + text, "a test and a kernel are needed, as in sphere=textbook");
        const std::string test = text.substr(0, middle);
        if (std::ranges::none_of(hard::all_suites(), [&](const auto &suite) { return suite.name == test; }))
            throw InputError("--replace-default " + text, "there is no such test");
        settings.replaced[test] = text.substr(middle + 1);
    }
    options.frontier = options.frontier || (!quick && settings.families.empty());
    settings.quick = quick;
    settings.cases = cases ? static_cast<std::size_t>(cases) : quick ? 20'000 : 1'000'000;
    settings.degenerate_cases = cases ? settings.cases : quick ? 20'000 : 10'000'000;
    if (!options.kernel_file.empty())
        settings.reader = std::make_shared<hard::Reader>(options.kernel_file);
    require_writable(options.out_folder + "/accuracy.json");
    settings.shaders = hard::open_shaders();
    return options;
}

void write_report(const Options &options, const std::vector<Row> &rows) {
    const std::string folder = options.out_folder + "/";
    Report report{"Accuracy: intersection tests on hard cases", {}, rows};
    report.options.set("seed", options.settings.seed).set("quick", options.settings.quick);
    report.options.set("cases", static_cast<std::uint64_t>(options.settings.cases));
    write_json(folder + "accuracy.json", report);
    write_markdown(folder + "accuracy.md", report);
    for (std::string test : hard::distinct(rows, "test"))
        if (const Plot plot = hard::plot_of_test(rows, test); !plot.series.empty()) {
            std::ranges::replace(test, ' ', '_');
            write_plot(folder + "accuracy_" + test + ".svg", plot);
        }
}

// All suites in turn, with a bar that shows how much of the work is done.
hard::Outcome measure(const std::vector<hard::Suite> &suites, hard::Settings settings) {
    constexpr std::size_t steps = 1000;
    double work = 0, done = 0;
    for (const hard::Suite &suite : suites)
        work += suite.work;
    std::size_t shown = 0;
    Progress progress("hard cases", steps);
    const auto advance_to = [&](double so_far) {
        for (; shown < std::min(steps, static_cast<std::size_t>(steps * so_far / work)); ++shown)
            progress.advance();
    };
    hard::Outcome all;
    for (const hard::Suite &suite : suites) {
        double part = 0;
        settings.done = [&](double share) { advance_to(done + suite.work * (part += share)); };
        hard::append(all, suite.measure(settings));
        advance_to(done += suite.work);
    }
    return all;
}

int accuracy(int argc, char **argv) {
    const Options options = options_from(argc, argv);
    std::vector<hard::Suite> suites;
    for (hard::Suite &suite : hard::all_suites())
        if (std::ranges::any_of(suite.families, [&](const auto &family) { return options.settings.wants(family); }))
            suites.push_back(std::move(suite));
    hard::Outcome all = measure(suites, options.settings);
    const auto frontier = options.frontier ? hard::frontier_rows(options.settings.seed) : std::vector<Row>{};
    for (const std::string &family : families)
        if (const auto lines = hard::summary_of_family(all.rows, family); !lines.empty())
            std::printf("%s\n%s\n", family.c_str(), terminal_table(lines).c_str());
    if (!frontier.empty())
        std::printf("The frontier: time over the textbook form's in float, on the same rays\n%s\n",
                    terminal_table(hard::frontier_table(frontier)).c_str());
    all.rows.insert(all.rows.end(), frontier.begin(), frontier.end());
    write_report(options, all.rows);
    if (options.settings.reader)
        for (const std::string &failure : options.settings.reader->failures())
            std::printf("Your %s\n", failure.c_str());
    std::printf("%s; every row is in %s/accuracy.json\n",
                all.passed ? "Every default kernel reached its threshold"
                           : "A default kernel MISSED its threshold (see above)",
                options.out_folder.c_str());
    return all.passed ? 0 : 1;
}

} // namespace

int main(int argc, char **argv) {
    return run_guarded("accuracy", [&] { return accuracy(argc, argv); });
}
