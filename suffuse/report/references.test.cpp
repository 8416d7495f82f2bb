#include "suffuse/report/references.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace suffuse::report {
namespace {

TEST(References, EveryWorkOfTheBibliographyReadsAsAnEntry) {
    const std::vector<Work> works = read_works(bibliography());
    EXPECT_GT(works.size(), 60U);
    for (const Work& work : works) {
        EXPECT_TRUE(work.entry.find_first_of("{}\\") == std::string::npos) << work.entry;
        EXPECT_EQ(work.entry.find("()"), std::string::npos) << work.entry;
        EXPECT_NE(work.cited.find_first_of("0123456789"), std::string::npos) << work.key << " has a year";
    }
    const auto kenney = std::ranges::find(works, "KenneyLau1985", &Work::key);
    ASSERT_NE(kenney, works.end());
    EXPECT_EQ(kenney->cited, "Kenney and Lau 1985");
    EXPECT_TRUE(kenney->entry.starts_with("Kenney, T. C. and Lau, D. (1985). Internal stability")) << kenney->entry;
}

TEST(References, OfAPageAreThoseThatItNamesInTheOrderInWhichItDoes) {
    const std::vector<Work> works = {
        {"A1999", "Adam 1999", "Adam (1999)."},
        {"B2000", "Berg and Cole 2000", "Berg (2000)."},
        {"C", "Cox 1", "Cox."}};
    const CitedWorks cited = resolve_citations("<p>By Berg and Cole 2000.</p><td>A1999</td><td>A19991</td>", works);
    ASSERT_EQ(cited.works.size(), 2U);
    EXPECT_EQ(cited.works[0].key, "B2000");
    EXPECT_NE(cited.html.find("<td><a href=\"#ref-A1999\" title=\"Adam 1999\">[2]</a></td>"), std::string::npos)
        << cited.html;
    EXPECT_NE(cited.html.find("<td>A19991</td>"), std::string::npos);
    EXPECT_NE(references_content(cited.works).find("<li id=\"ref-B2000\">Berg (2000).</li>"), std::string::npos);
    EXPECT_EQ(references_content({}), "");
}

} // namespace
} // namespace suffuse::report
