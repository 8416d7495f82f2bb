#include "suffuse/casefile/refine.hpp"

#include "suffuse/casefile/case_for_tests.hpp"

#include <gtest/gtest.h>

namespace {

using namespace suffuse;
using namespace suffuse::casefile;
using namespace suffuse::casefile::testing;

TEST(Refine, AValueBetweenTwoIsWrittenAsTheyAre) {
    EXPECT_EQ(value_between(Scalar("30 %"), Scalar("35 %"), 0.5), Scalar("32.5 %"));
    EXPECT_EQ(value_between(Scalar("50 kPa"), Scalar("100kPa"), 0.5), Scalar("75 kPa"));
    EXPECT_EQ(value_between(Scalar(0.25), Scalar(0.5), 1.0 / 3), Scalar(0.333333));
    EXPECT_EQ(value_between(Scalar(std::int64_t{1000}), Scalar(std::int64_t{2001}), 0.5), Scalar(std::int64_t{1501}));
    EXPECT_EQ(value_between(Scalar("10 %"), Scalar(0.2), 0.5), Scalar(0.15));
    EXPECT_EQ(value_between(Scalar("1 mm"), Scalar("100 um"), 0.0), Scalar("1 mm"));
}

TEST(Refine, MakesTheCopiesThatTheListWouldHaveMade) {
    const Case c = load(full_case);
    const auto copies =
        variants_at(c, "main", {{"fines_content", Scalar("20 %")}, {"stage.initial.pressure", Scalar("100 kPa")}});
    ASSERT_EQ(copies.size(), 2U);
    const Variant& listed = c.studies[0].variants[6];
    EXPECT_EQ(copies[0].folder, listed.folder);
    EXPECT_EQ(copies[0].seed, listed.seed);
    EXPECT_EQ(copies[0].soil->fines_content, listed.soil->fines_content);
    EXPECT_EQ(copies[0].stages.size(), listed.stages.size());
    const auto between =
        variants_at(c, "main", {{"fines_content", Scalar("15 %")}, {"stage.initial.pressure", Scalar("100 kPa")}});
    EXPECT_EQ(between[1].folder, "main/fc=15/pressure=100kPa/rep=2");
    EXPECT_EQ(between[1].soil->fines_content, 0.15);
}

TEST(Refine, IsReadAndItsMistakesAreReported) {
    const Refine refine = load(full_case).studies[0].refine.value();
    EXPECT_EQ(refine.key, "fines_content");
    EXPECT_EQ(refine.of, "void_ratio");
    EXPECT_EQ(refine.at, (std::vector<std::string>{"initial"}));
    EXPECT_EQ(refine.add, 2);
    EXPECT_FALSE(refine.maximum);
    const auto with = [](const std::string& what, const std::string& instead) {
        std::string text = full_case;
        return problems_of(text.replace(text.find(what), what.size(), instead));
    };
    EXPECT_NE(
        find_problem(with("key = \"fines_content\"", "key = \"particles\""), "E406").message.find("not swept"),
        std::string::npos
    );
    EXPECT_NE(
        find_problem(with("at = [\"initial\"]", "at = [\"intial\"]"), "E401").help.find("initial"), std::string::npos
    );
    EXPECT_EQ(find_problem(with("around = \"minimum\"", "around = \"minium\""), "E206").code, "E206");
}

} // namespace
