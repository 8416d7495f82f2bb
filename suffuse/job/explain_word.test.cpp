#include "suffuse/job/explain_word.hpp"

#include "suffuse/base/error.hpp"

#include <gtest/gtest.h>

#include "tests/support/reference.hpp"
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>

namespace suffuse::job {
namespace {

TEST(ExplainWord, KnowsEveryWordThatItOffers) {
    EXPECT_GT(explained_words().size(), 150U);
    for (const std::string& word : explained_words()) {
        EXPECT_GT(explain_word(word).size(), word.size() + 20) << word;
    }
}

TEST(ExplainWord, KnowsCriteriaByTheirAuthorsAndNumbersAndKeysByTheirPlaceInACase) {
    EXPECT_EQ(explain_word("kezdi"), explain_word("kezdi-1979"));
    EXPECT_NE(
        explain_word("alpha").find("mean effective stress in the fines over that of the soil"), std::string::npos
    );
    EXPECT_NE(explain_word("study.x.stage.y.prepare.adhesion.normal").find("adhesion"), std::string::npos);
    EXPECT_THROW(explain_word("study.x.stage.y.nothing"), UsageError);
}

TEST(ExplainWord, KnowsTheFindingsThatAReportJudges) {
    EXPECT_NE(explain_word("E4").find("met when  Pass 2: more than 50 %"), std::string::npos) << explain_word("E4");
    EXPECT_NE(explain_word("M9").find("paper     "), std::string::npos);
    EXPECT_THROW(explain_word("E8"), UsageError);
}

TEST(ExplainWord, OffersTheNearestKeyForAMisspeltPlaceInACase) {
    const auto offered = [](const std::string& word) -> std::string {
        try {
            explain_word(word);
        } catch (const UsageError& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_NE(
        offered("study.x.stage.y.voi_ratio").find("suffuse explain study.x.stage.y.void_ratio"), std::string::npos
    );
    EXPECT_NE(offered("contcat.modulus").find("suffuse explain contact.modulus"), std::string::npos);
    EXPECT_NE(offered("study.x.stage.y.nothing").find("suffuse schema lists all keys"), std::string::npos);
}

TEST(ExplainWord, KnowsEveryFigureThatAReportCanDraw) {
    const std::regex quoted_id("\"((own|fig)-?[a-z0-9]+(-[a-z0-9]+)*)\"");
    std::set<std::string> ids;
    for (const auto& entry : std::filesystem::directory_iterator(test::in_checkout("suffuse/figures"))) {
        const std::string name = entry.path().filename().string();
        if (!name.starts_with("figures_") && !name.starts_with("stability_")) {
            continue;
        }
        std::ifstream file(entry.path());
        const std::string text{std::istreambuf_iterator<char>(file), {}};
        for (std::sregex_iterator at(text.begin(), text.end(), quoted_id), end; at != end; ++at) {
            ids.insert((*at)[1]);
        }
    }
    EXPECT_GE(ids.size(), 15U);
    for (const std::string& id : ids) {
        EXPECT_NO_THROW(explain_word(id)) << id;
    }
}

} // namespace
} // namespace suffuse::job
