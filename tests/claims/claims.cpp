// claims: what the lecture notes say about ray tracing, and what came out when it was measured.
#include "common/command_line.hpp"
#include "common/output_files.hpp"
#include "common/parallel.hpp"
#include "common/program.hpp"
#include "common/progress.hpp"
#include "common/report.hpp"
#include "tests/claims/claim.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>

using namespace course;

namespace {

const char *in_words(Holds verdict) {
    return verdict == Holds::yes ? "holds" : verdict == Holds::no ? "fails" : "depends";
}

std::vector<Claim> chosen(std::vector<Claim> all, const std::vector<std::string> &wanted) {
    for (const std::string &id : wanted)
        if (std::ranges::find(all, id, &Claim::id) == all.end())
            throw InputError("--claim " + id, "there is no such claim");
    if (!wanted.empty())
        std::erase_if(all, [&](const Claim &claim) { return std::ranges::find(wanted, claim.id) == wanted.end(); });
    return all;
}

Row row_of(const Claim &claim, const Finding &finding, const std::string &figure) {
    return Row()
        .set("id", claim.id)
        .set("claim", claim.claim)
        .set("how", claim.how)
        .set("measured", finding.measured)
        .set("holds if", claim.rule)
        .set("verdict", in_words(finding.verdict))
        .set("depends on", finding.depends_on)
        .set("chapter", claim.chapter)
        .set("figure", figure);
}

void show(const Claim &claim, const Finding &finding) {
    std::printf("%-4s %-8s %s (chapter %s)\n", claim.id.c_str(), in_words(finding.verdict), claim.claim.c_str(),
                claim.chapter.c_str());
    const auto line = [](const char *title, const std::string &text) {
        if (!text.empty())
            std::printf("     %-11s %s\n", title, text.c_str());
    };
    line("how", claim.how);
    line("measured", finding.measured);
    line("holds if", claim.rule);
    line("depends on", finding.depends_on);
    std::printf("\n");
    std::fflush(stdout);
}

} // namespace

int main(int argc, char **argv) {
    return run_guarded("claims", [&] {
        ClaimOptions how;
        std::string base = "out/claims";
        std::vector<std::string> wanted;
        CommandLine options("claims", "What the lecture notes claim, measured");
        options.flag("--quick", how.quick, "Smaller scenes and fewer rays");
        options.option("--seed", how.seed, "Seed of every random choice");
        options.option("--claim", wanted, "Only this claim, such as C7 (may repeat)");
        options.option("--report", base, "Where the report goes: FILE.json, FILE.md, FILE_C7.svg ...");
        options.parse(argc, argv);
        const auto claims = chosen(all_claims(), wanted);
        require_writable(base + ".json");

        Report report{"Claims, measured", Row().set("quick", how.quick).set("seed", how.seed), {}};
        Progress progress("claims", claims.size());
        for (const Claim &claim : claims) {
            use_threads(claim.timed ? 1 : 0);
            const Finding finding = claim.measure(how);
            std::string figure;
            if (finding.figure && write_plot(base + "_" + claim.id + ".svg", *finding.figure))
                figure = std::filesystem::path(base + "_" + claim.id + ".svg").filename().string();
            report.results.push_back(row_of(claim, finding, figure));
            show(claim, finding);
            progress.advance();
        }
        write_json(base + ".json", report);
        write_markdown(base + ".md", report);
        std::printf("%zu claims, %s.md\n", claims.size(), base.c_str());
        return 0;
    });
}
