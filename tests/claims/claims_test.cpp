// The table of claims is complete and names chapters that exist; and the rule from cases to a verdict.
#include "tests/claims/cases.hpp"

#include <algorithm>
#include <filesystem>
#include <gtest/gtest.h>
#include <set>

namespace course {
namespace {

const Claim &claim_of(const std::vector<Claim> &all, const std::string &id) {
    return *std::ranges::find(all, id, &Claim::id);
}

TEST(Claims, EveryClaimOfTheNotesStandsInTheTableOnce) {
    const std::vector<Claim> all = all_claims();
    std::multiset<std::string> ids;
    for (const Claim &claim : all)
        ids.insert(claim.id);
    const bool gpu = ids.contains("C15") || ids.contains("C16"); // chapter 17's: both, or neither yet
    for (int number = 1; number <= 21; ++number) {
        const std::string id = std::string("C").append(std::to_string(number));
        EXPECT_EQ(ids.count(id), (number == 15 || number == 16) && !gpu ? 0u : 1u) << id;
    }
    EXPECT_EQ(ids.size(), gpu ? 21u : 19u);
}

TEST(Claims, EveryRowNamesAChapterThatIsThereAndSaysHowItJudges) {
    for (const Claim &claim : all_claims()) {
        EXPECT_TRUE(std::filesystem::exists(std::filesystem::path("chapters") / claim.chapter / "main.cpp"))
            << claim.id << claim.chapter;
        for (const std::string &text : {claim.claim, claim.chapter, claim.how, claim.rule})
            EXPECT_FALSE(text.empty()) << claim.id;
    }
}

TEST(Cases, HoldInAllInNoneOrDepend) {
    const Plot plot;
    Cases all("the scene"), none("the scene"), most("the scene"), few("the scene");
    for (const std::string name : {"hall", "soup", "rings"}) {
        all.add(name, true, "0.5 s");
        none.add(name, false);
        most.add(name, name != "soup");
        few.add(name, name == "soup");
    }
    EXPECT_EQ(all.finding(plot).verdict, Holds::yes);
    EXPECT_EQ(all.finding(plot, "done").measured, "hall: 0.5 s; soup: 0.5 s; rings: 0.5 s; done");
    EXPECT_EQ(all.finding(plot).depends_on, "");
    EXPECT_EQ(none.finding(plot).verdict, Holds::no);
    EXPECT_EQ(most.finding(plot).verdict, Holds::depends);
    EXPECT_EQ(most.finding(plot).depends_on, "the scene; it does not hold for: soup");
    EXPECT_EQ(few.finding(plot).depends_on, "the scene; it holds only for: soup");
}

// What no clock blurs comes out the same wherever it is measured.
TEST(Claims, VerdictsThatNeedNoClock) {
    const std::vector<Claim> all = all_claims();
    const auto verdict_on = [&](const std::string &id) {
        EXPECT_FALSE(claim_of(all, id).timed) << id;
        const Finding finding = claim_of(all, id).measure({.quick = true, .seed = 7});
        EXPECT_FALSE(finding.measured.empty()) << id;
        EXPECT_EQ(finding.depends_on.empty(), finding.verdict != Holds::depends) << id;
        return finding.verdict;
    };
    for (const std::string id : {"C5", "C7", "C13", "C14", "C19", "C21"})
        EXPECT_EQ(verdict_on(id), Holds::yes) << id;
    for (const std::string id : {"C1", "C11", "C12", "C17"})
        EXPECT_EQ(verdict_on(id), Holds::depends) << id;
}

} // namespace
} // namespace course
