#include "suffuse/facts/every_fact.hpp"

#include "suffuse/facts/by_key.hpp"
#include "suffuse/facts/mobility.hpp"
#include "suffuse/facts/pass.hpp"

#include <gtest/gtest.h>

#include "tests/support/reference.hpp"
#include <fstream>
#include <set>
#include <sstream>

namespace suffuse::facts {
namespace {

TEST(Facts, ThePageOfResultsIsTheOneThatTheProgramPrints) {
    std::ostringstream page;
    page << std::ifstream(test::in_checkout("docs/results.md")).rdbuf();
    EXPECT_EQ(page.str(), results_markdown()) << "suffuse schema --results > docs/results.md";
}

TEST(Facts, AKeyThatIsInOneObjectTwiceIsNoted) {
    for (const Group& group : every_group()) {
        std::set<std::string_view> keys;
        for (const Fact& fact : group.facts) {
            EXPECT_TRUE(keys.insert(fact.key).second) << group.title << ": " << fact.key;
            EXPECT_EQ(fact.words.find('|'), std::string_view::npos) << fact.key << ": would break the table";
        }
    }
}

TEST(Facts, AKeyHasOneUnitInWhateverObjectItIs) {
    std::map<std::string_view, std::string_view> seen;
    for (const Group& group : every_group()) {
        for (const Fact& fact : group.facts) {
            const auto at = seen.emplace(fact.key, fact.unit).first;
            EXPECT_EQ(at->second, fact.unit) << fact.key << " of " << group.title;
        }
    }
    EXPECT_EQ(units().at("mean_stress"), "Pa");
    EXPECT_EQ(units().at("force_distribution.mean_force"), "N");
    EXPECT_EQ(units().count("void_ratio"), 0U);
}

TEST(Facts, NamesInResultsCborOccurOnce) {
    std::set<std::string_view> names;
    const auto note = [&](const Fact& fact) {
        if (!fact.saved.empty()) {
            EXPECT_TRUE(names.insert(fact.saved).second) << fact.saved;
        }
    };
    for_each_row(pass, note);
    for_each_row(pass_with_water, note);
    names.clear();
    for_each_row(mobility, note);
    EXPECT_GT(names.size(), 30U);
}

} // namespace
} // namespace suffuse::facts
