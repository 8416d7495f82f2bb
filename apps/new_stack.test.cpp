// suffuse new --filter: a case of a base and its filter.

#include "tests/support/soils_to_model.hpp"

namespace suffuse {
namespace {

using namespace test;

class NewStack : public SoilsToModel {};

TEST_F(NewStack, WithAFilterIsABaseThatWaterTakesThere) {
    write_to(folder / "base.csv", "d [mm],passing [%]\n0.2,0\n0.25,100\n");
    write_to(folder / "drain.csv", "d [mm],passing [%]\n0.9,0\n1.1,100\n");
    const ProgramResult made = run_suffuse({"new", "base.csv", "--filter", "drain.csv", "-i", "5"});
    ASSERT_EQ(made.code, 0) << made.error;
    const std::string path = "base-and-drain/case.toml";
    expect_in(path, made.out);
    expect_in("grains of base on", made.error);
    const std::string text = read_all(folder / path);
    expect_in("gradients    = [5]", text);
    expect_in("downward", text);
    const ProgramResult checked = run_suffuse({"check", path, "--json"});
    EXPECT_EQ(checked.code, 0) << checked.error;
    EXPECT_EQ(run_suffuse({"plan", path}).code, 0);
    const ProgramResult assessed = run_suffuse({"assess", "base.csv", "--filter", "drain.csv"});
    expect_in("suffuse new base.csv --filter drain.csv", assessed.error);
    write_to(folder / "two.csv", "d [mm],fine,drain\n0.2,0,0\n0.25,100,0\n0.9,100,0\n1.1,100,100\n");
    expect_in(
        "choose it by --filter-sample NAME", run_suffuse({"new", "z", "--psd", "base.csv", "--filter", "two.csv"}).error
    );
    const ProgramResult both =
        run_suffuse({"new", "two.csv", "--sample", "fine", "--filter", "two.csv", "--filter-sample", "drain", "-i", "5"}
        );
    ASSERT_EQ(both.code, 0) << both.error;
    expect_in("fine-and-drain/case.toml", both.out);
    const ProgramResult swapped = run_suffuse({"new", "x", "--psd", "drain.csv", "--filter", "base.csv"});
    EXPECT_EQ(swapped.code, 3);
    expect_in("not coarser than its base", swapped.error);
    write_to(folder / "silt.csv", "d [mm],passing [%]\n0.01,0\n0.02,100\n");
    const ProgramResult fine = run_suffuse({"new", "y", "--psd", "silt.csv", "--filter", "drain.csv"});
    EXPECT_EQ(fine.code, 3);
    expect_in("more than 40000", fine.error);
    EXPECT_FALSE(std::filesystem::exists(folder / "y"));
}

TEST_F(NewStack, HowAFileIsReadIsAboutTheBaseAndNotAboutItsFilter) {
    write_to(folder / "base.csv", "size,share\n0.2,0\n0.23,50\n0.25,50\n");
    write_to(folder / "drain.csv", "d [mm],passing [%]\n0.9,0\n1,30\n1.1,100\n");
    const ProgramResult assessed =
        run_suffuse({"assess", "base.csv", "--by", "number", "--size", "1:mm", "--share", "2", "--filter", "drain.csv"}
        );
    ASSERT_EQ(assessed.code, 0) << assessed.error;
    expect_in("suffuse new base.csv --size 1:mm --share 2 --by number --filter drain.csv", assessed.error);
    const ProgramResult made = run_suffuse(
        {"new", "stack", "--psd", "base.csv", "--size", "1:mm", "--share", "2", "--by", "number", "--filter",
         "drain.csv"}
    );
    ASSERT_EQ(made.code, 0) << made.error;
    expect_in("0.9,0\n1,30\n1.1,100\n", read_all(folder / "stack/data/drain.csv"));
}

TEST_F(NewStack, WhatAStackDoesNotKnowIsRefused) {
    using Words = std::vector<std::string>;
    for (const Words& words :
         {Words{"--particles", "50"}, {"--fines", "0.5mm"}, {"--surrogate"}, {"--sizes", "1mm,2mm"}}) {
        Words all{"new", "x", "--psd", "gap.csv", "--filter", "well.csv"};
        all.insert(all.end(), words.begin(), words.end());
        const ProgramResult refused = run_suffuse(all);
        EXPECT_EQ(refused.code, 2) << words.front();
        expect_in("excludes", refused.error);
        expect_in(words.front(), refused.error);
    }
}

TEST_F(NewStack, TheGradientInABaseIsMarkedAndStatedWhereItIsAssumed) {
    write_to(folder / "base.csv", "d [mm],passing [%]\n0.2,0\n0.25,100\n");
    write_to(folder / "drain.csv", "d [mm],passing [%]\n0.9,0\n1.1,100\n");
    const ProgramResult assumed = run_suffuse({"new", "a", "--psd", "base.csv", "--filter", "drain.csv"});
    expect_in("a pressure of 100 kPa and a gradient of 1 are assumed: enter your own in a/case.toml", assumed.error);
    expect_in(
        "gradients    = [1]                    #~ yours: the hydraulic gradient", read_all(folder / "a/case.toml")
    );
    const ProgramResult given =
        run_suffuse({"new", "b", "--psd", "base.csv", "--filter", "drain.csv", "-i", "5", "--pressure", "50 kPa"});
    EXPECT_EQ(given.error.find("assumed"), std::string::npos) << given.error;
    expect_in("gradients    = [5]                    # as specified:", read_all(folder / "b/case.toml"));
}

TEST_F(NewStack, OfABaseAndItsFilterOnlyWhatWasMeasuredIsModeled) {
    write_to(folder / "base.csv", "d [mm],passing [%]\n0.2,30\n0.25,60\n0.3,100\n");
    write_to(folder / "drain.csv", "d [mm],passing [%]\n0.9,0\n1.1,96\n");
    const ProgramResult made = run_suffuse({"new", "stack", "--psd", "base.csv", "--filter", "drain.csv", "--json"});
    ASSERT_EQ(made.code, 0) << made.error;
    expect_in("left out of base, for its sizes were not measured: the 30 % finer than 0.2 mm", made.error);
    expect_in("left out of drain, for its sizes were not measured: the 4 % coarser than 1.1 mm", made.error);
    EXPECT_EQ(made.json().at("left_out").at("base"), "the 30 % finer than 0.2 mm");
    EXPECT_EQ(made.error.find("next:"), std::string::npos) << made.error; // commands, which no program types
    expect_in("[%]\n0.2,30\n0.25,60\n0.3,100\n", read_all(folder / "stack/data/base.csv")); // as it was measured
    const std::string text = read_all(folder / "stack/case.toml");
    expect_in("sizes = [\"0.2 mm\", \"0.3 mm\"] #~ without the 30 % finer than 0.2 mm", text);
    expect_in("sizes = [\"0.9 mm\", \"1.1 mm\"] #~ without the 4 % coarser than 1.1 mm", text);
    const ProgramResult assessed = run_suffuse({"assess", "stack/case.toml", "--json"});
    EXPECT_EQ(assessed.json().at("soils").at(0).at("missing_fine"), 0.3) << assessed.out;
}

} // namespace
} // namespace suffuse
