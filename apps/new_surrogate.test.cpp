// suffuse new --surrogate: a case of two fractions that stands for a soil too wide to simulate.

#include "tests/support/soils_to_model.hpp"

namespace suffuse {
namespace {

using namespace test;

class NewSurrogate : public SoilsToModel {};

TEST_F(NewSurrogate, ASurrogateStandsForASoilThatIsTooWide) {
    const std::string refused = run_suffuse({"new", "--psd", "wide gravel.csv"}).error;
    expect_in("suffuse new --psd 'wide gravel.csv' --surrogate", refused);
    const ProgramResult made = run_suffuse({"new", "wide gravel.csv", "--surrogate", "--json"}); // short for --psd
    ASSERT_EQ(made.code, 0) << made.error;
    const nlohmann::json document = made.json();
    EXPECT_NEAR(document.at("fines_content").get<double>(), 0.21, 1e-12);
    EXPECT_TRUE(document.at("extrapolated").get<bool>());
    EXPECT_EQ(document.at("size_ratios"), nlohmann::json({3, 4.5, 7.5}));
    const std::string text = read_all(folder / "wide-gravel/case.toml");
    expect_in("surrogate         = { finer_than = \"0.3 mm\" }", text);
    expect_in("gradients = { up_to = 1.2, steps = 24 }", text); // those that the ramp would add
    expect_in("size_ratio = [3, 4.5, 7.5]", text);
    expect_in("direction = \"x\"", text);
    expect_in("direction = \"z\"", text);
    const ProgramResult plan = run_suffuse({"plan", "wide-gravel", "--json"});
    ASSERT_EQ(plan.code, 0) << plan.error;
    EXPECT_EQ(run_suffuse({"check", "wide-gravel", "--preset", "standard"}).code, 0);
}

TEST_F(NewSurrogate, ASurrogateHasTheSizeRatioOfItsSoilWhereThatIsInReach) {
    const nlohmann::json document =
        run_suffuse({"new", "gap.csv", "--surrogate", "--flow", "up", "-i", "0.3", "--json"}).json();
    EXPECT_FALSE(document.at("extrapolated").get<bool>());
    EXPECT_EQ(document.at("size_ratios").size(), 1U);
    EXPECT_EQ(document.at("size_ratios").front(), document.at("size_ratio"));
    const std::string text = read_all(folder / "gap/case.toml");
    expect_in("asked_gradient = 0.3", text);
    EXPECT_EQ(text.find("direction = \"x\""), std::string::npos) << "upward alone";
    EXPECT_EQ(run_suffuse({"check", "gap"}).code, 0);
}

TEST_F(NewSurrogate, OfASoilThatNoSplitMakesUnstableThereIsNoSurrogate) {
    const ProgramResult refused = run_suffuse({"new", "well.csv", "--surrogate"});
    EXPECT_EQ(refused.code, 3);
    expect_in("no split of this curve is unstable", refused.error);
    expect_in("suffuse assess well.csv", refused.error);
    EXPECT_EQ(run_suffuse({"new", "well.csv", "--surrogate", "--fines", "0.2mm"}).code, 0) << "where one is requested";
}

TEST_F(NewSurrogate, ASurrogateHasRatiosWithoutRepetitionAndLeavesNothingBehindIfThereIsNone) {
    write_to(folder / "y.csv", "d [mm],passing [%]\n0.01,0\n0.075,35\n0.3,60\n1,80\n4,95\n10,100\n");
    EXPECT_EQ(run_suffuse({"new", "f", "--psd", "y.csv", "--surrogate"}).code, 3) << "95 % of fines have no skeleton";
    EXPECT_FALSE(std::filesystem::exists(folder / "f"));
    const ProgramResult made = run_suffuse({"new", "f", "--psd", "y.csv", "--surrogate", "--fines", "4mm", "--json"});
    ASSERT_EQ(made.code, 0) << made.error;
    EXPECT_EQ(made.json().at("size_ratios"), (std::vector<double>{1.5, 2}));
    const ProgramResult none =
        run_suffuse({"new", "g", "--psd", "y.csv", "--surrogate", "--fines", "4mm", "--particles", "5000"});
    EXPECT_EQ(none.code, 3);
    expect_in("nothing can be extrapolated", none.error);
    EXPECT_FALSE(std::filesystem::exists(folder / "g"));
    EXPECT_EQ(run_suffuse({"new", "h", "--psd", "y.csv"}).error.find("--surrogate"), std::string::npos);
}

} // namespace
} // namespace suffuse
