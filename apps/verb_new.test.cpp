// suffuse new --psd: a case from a grading curve of the user's.

#include <fmt/format.h>

#include "tests/support/soils_to_model.hpp"

namespace suffuse {
namespace {

using namespace test;

class NewSoil : public SoilsToModel {};

TEST_F(NewSoil, TheCaseIsCheckedAndPlannedAsItStands) {
    for (const auto& [name, reason] :
         {std::pair{"gap", "the fine end of the gap"}, std::pair{"well", "stable by Kenney and Lau"}}) {
        const std::string path = std::string(name) + "/case.toml";
        const ProgramResult made = run_suffuse({"new", "--psd", std::string(name) + ".csv"});
        ASSERT_EQ(made.code, 0) << made.error;
        expect_in(path, made.out);
        expect_in(reason, made.error);
        expect_in("suffuse run " + path, made.error);
        expect_in(reason, read_all(folder / path));
        const ProgramResult checked = run_suffuse({"check", path, "--json"});
        ASSERT_EQ(checked.code, 0) << checked.error;
        EXPECT_EQ(checked.json().at("preset"), "quick");
        EXPECT_EQ(run_suffuse({"check", path, "--preset", "standard"}).code, 0);
        const ProgramResult plan = run_suffuse({"plan", path, "--json"});
        ASSERT_EQ(plan.code, 0) << plan.error;
        EXPECT_EQ(plan.json().at("stages").size(), 5U);
    }
    const std::string gap = read_all(folder / "gap/case.toml");
    expect_in("finer_than = \"0.3 mm\"", gap);
    expect_in("#~ yours: the hydraulic gradient", gap);
    expect_in("0.15,0\n", read_all(folder / "gap/data/gap.csv"));
    EXPECT_EQ(run_suffuse({"new", "--psd", "gap.csv"}).code, 2); // nothing is overwritten
}

TEST_F(NewSoil, WithAFlowItsFinesHaveWeight) {
    for (const auto& [way, direction] : {std::pair{"up", "\"z\""}, {"down", "\"-z\""}, {"level", "\"x\""}}) {
        const std::string path = std::string(way) + "/case.toml";
        ASSERT_EQ(run_suffuse({"new", way, "--psd", "gap.csv", "-i", "0.2", "--flow", way}).code, 0);
        const std::string text = read_all(folder / path);
        expect_in("[gravity]", text);
        expect_in("asked_gradient = 0.2", text);
        expect_in("direction      = " + std::string(direction), text);
        EXPECT_EQ(run_suffuse({"check", path, "--preset", "standard"}).code, 0);
        const ProgramResult plan = run_suffuse({"plan", path, "--json"});
        ASSERT_EQ(plan.code, 0) << plan.error;
        expect_in("rest under weight, then 25 gradients", plan.json().dump());
    }
    EXPECT_EQ(read_all(folder / "up/case.toml").find("(Grains have no weight here"), std::string::npos);
    ASSERT_EQ(run_suffuse({"new", "slope", "--psd", "gap.csv", "--flow", "30deg"}).code, 0);
    expect_in(
        "direction      = [0.8660, 0, 0.5000]       # rising at 30 degrees", read_all(folder / "slope/case.toml")
    );
    EXPECT_EQ(run_suffuse({"check", "slope/case.toml", "--preset", "standard"}).code, 0);
    EXPECT_EQ(run_suffuse({"new", "aside", "--psd", "gap.csv", "--flow", "aside"}).code, 2);
    const ProgramResult no_run = run_suffuse({"assess", "gap.csv", "--alpha-from", "up"});
    EXPECT_NE(no_run.code, 0);
    expect_in("holds no run", no_run.error);
}

TEST_F(NewSoil, ItRuns) {
    ASSERT_EQ(run_suffuse({"new", "dyke", "--psd", "gap.csv"}).code, 0);
    const ProgramResult ran = run_suffuse({"run", "dyke/case.toml", "-o", "runs/dyke", "--until", "cloud", "-q"});
    ASSERT_EQ(ran.code, 0) << ran.error;
    const auto summary = nlohmann::json::parse(read_all(folder / "runs/dyke/summary.json"));
    const auto& cloud = summary.at("stages").at("erosion/cloud");
    EXPECT_NEAR(cloud.at("fines_content").get<double>(), 0.2, 0.02); // the tolerance of a grading
}

TEST_F(NewSoil, ACurveTooLargeForAnyComputerIsRefusedAndAssessJudgesTheWhole) {
    write_to(folder / "till.csv", "d [mm],passing [%]\n0.002,0\n0.063,12\n0.3,20\n2,40\n20,75\n100,100\n");
    const ProgramResult result = run_suffuse({"new", "till", "--psd", "till.csv"});
    EXPECT_EQ(result.code, 3);
    expect_in("= no computer holds so many: a run can model a part of this soil only", result.error);
    expect_in("= only suffuse assess till.csv can judge the whole curve", result.error);
}

TEST_F(NewSoil, OfATableOfSeveralSamplesOneIsChosen) {
    write_to(folder / "wide.csv", "d [mm],TP-1,TP-2\n0.5,0,0\n1,40,60\n2,100,100\n");
    const ProgramResult many = run_suffuse({"new", "x", "--psd", "wide.csv"});
    EXPECT_EQ(many.code, 3);
    expect_in("wide.csv holds 2 samples, and one is needed: TP-1, TP-2; choose it by --sample NAME", many.error);
    EXPECT_EQ(run_suffuse({"new", "x", "--psd", "wide.csv", "--sample", "tp-2"}).code, 0);
    expect_in("1,60", read_all(folder / "x/data/TP-2.csv"));
    expect_in("psd", read_all(folder / "x/case.toml"));
}

TEST_F(NewSoil, ACurveThatIsTooWideIsRefusedWithTheSizesThatWillDo) {
    const ProgramResult refused = run_suffuse({"new", "gravel", "--psd", "wide gravel.csv"});
    EXPECT_EQ(refused.code, 3);
    expect_in("too far apart for one sample", refused.error);
    const std::string& text = refused.error;
    const std::size_t at = text.find("--sizes ") + 8;
    const std::string sizes = text.substr(at, text.find(' ', at) - at);
    expect_in("it takes more than 300,000,000 grains", text);
    expect_in("--sizes " + sizes + " added to the command keeps ", text); // with all else that was requested
    const auto instead = run_suffuse({"new", "--psd", "wide gravel.csv", "--json"}).json().at("error").at("instead");
    EXPECT_EQ(
        fmt::format(
            "{:.4g}mm,{:.4g}mm", 1e3 * instead.at("sizes").at(0).get<double>(),
            1e3 * instead.at("sizes").at(1).get<double>()
        ),
        sizes
    );
    EXPECT_FALSE(std::filesystem::exists(folder / "gravel"));
    const ProgramResult made = run_suffuse({"new", "gravel", "--psd", "wide gravel.csv", "--sizes", sizes});
    ASSERT_EQ(made.code, 0) << made.error;
    expect_in("left out: the ", made.error);
    expect_in("[soil.wide-gravel]", read_all(folder / "gravel/case.toml"));
    expect_in("#~ without the ", read_all(folder / "gravel/case.toml"));
    EXPECT_EQ(run_suffuse({"check", "gravel/case.toml"}).code, 0);
    write_to(folder / "far.csv", "d,passing\n0.002,0\n0.004,30\n10,30\n20,100\n");
    const ProgramResult far = run_suffuse({"new", "--psd", "far.csv", "--json"});
    expect_in("= cutting its ends does not help", far.error);
    EXPECT_TRUE(far.json().at("error").at("instead").at("sizes").is_null());
}

TEST_F(NewSoil, SaysOfWhichMassTheFinesAreAShareAndKeepsOfAllFines) {
    write_to(folder / "part.csv", "d [mm],passing [%]\n0.1,8\n0.2,30\n0.4,70\n0.6,95\n"); // F(0.146 mm) = 20 %
    const ProgramResult made = run_suffuse({"new", "part", "--psd", "part.csv", "--fines", "0.146mm"});
    expect_in("finer than 0.146 mm, 13.8 % of the modeled part, 20 % of the whole soil: as specified", made.error);
    expect_in(
        "#~ 13.8 % of the modeled part, 20 % of the whole soil; as specified", read_all(folder / "part/case.toml")
    );
    const ProgramResult refused = run_suffuse({"new", "gravel", "--psd", "wide gravel.csv"});
    expect_in(
        "the fines (below 0.3 mm) are 17.7 % of the modeled part, 21 % of the whole soil: it takes", refused.error
    );
    // 1 - F(0.213 mm)/F(0.3 mm), where F = 17 % + 4 % ln(0.213/0.2)/ln(0.3/0.2)
    expect_in("--sizes 0.213mm,2.78mm added to the command keeps 16 % of the fines and 18 % of", refused.error);
}

TEST_F(NewSoil, TheVerdictsThatACutChangesAreListedAndTheWholeCurveStaysWithTheCase) {
    const std::string turned = "unstable -> stable: Kenney and Lau 1985";
    expect_in(turned, run_suffuse({"new", "gravel", "--psd", "wide gravel.csv"}).error); // the advice to cut
    const ProgramResult made = run_suffuse({"new", "gravel", "--psd", "wide gravel.csv", "--sizes", "0.209mm,2.66mm"});
    ASSERT_EQ(made.code, 0) << made.error;
    const auto summary_of = [&](const char* soil) {
        return run_suffuse({"assess", soil, "--json"}).json()["soils"][0]["summary"].get<std::string>();
    };
    const std::string whole = summary_of("wide gravel.csv");
    expect_in("criteria say unstable (Kenney and Lau 1985, ", whole);
    expect_in("grading as given: " + whole, made.error);
    expect_in("part that is modeled: 2 of ", made.error);
    expect_in(" verdicts (whole soil -> modeled part): ", made.error);
    expect_in(turned, made.error);
    expect_in("sizes = [\"0.209 mm\", \"2.66 mm\"] #~ without the ", read_all(folder / "gravel/case.toml"));
    expect_in("0.063,4\n", read_all(folder / "gravel/data/wide-gravel.csv")); // all that was measured
    EXPECT_EQ(summary_of("gravel/case.toml"), whole);
}

TEST_F(NewSoil, PressureAndGradientCanBeGivenAndAreThenNotAssumed) {
    const ProgramResult made =
        run_suffuse({"new", "--psd", "gap.csv", "--pressure", "300 kPa", "-i", "12 m / 30 m", "--json"});
    ASSERT_EQ(made.code, 0) << made.error;
    EXPECT_EQ(made.json().at("pressure"), 300e3);
    EXPECT_EQ(made.json().at("gradient"), 0.4);
    EXPECT_EQ(made.error.find("assumed"), std::string::npos) << made.error;
    const std::string text = read_all(folder / "gap/case.toml");
    expect_in("pressure = \"300 kPa\"                  # as specified: the effective stress", text);
    expect_in("gradient  = 0.4                       # as specified: the hydraulic gradient", text);
    EXPECT_EQ(run_suffuse({"check", "gap/case.toml", "--json"}).code, 0);
    ASSERT_EQ(run_suffuse({"new", "soft", "--psd", "gap.csv", "-i", "0.4"}).code, 0);
    const auto modulus = [&](const std::string& name) {
        const std::string whole = read_all(folder / name / "case.toml");
        return whole.substr(whole.find("modulus"), 40);
    };
    EXPECT_NE(modulus("gap"), modulus("soft")); // stiffer for the finest grains under more stress
    expect_in("a pressure of 100 kPa is assumed", run_suffuse({"new", "third", "--psd", "gap.csv", "-i", "0.4"}).error);
    EXPECT_EQ(run_suffuse({"new", "none", "--psd", "gap.csv", "--pressure", "0 kPa"}).code, 2);
    EXPECT_EQ(run_suffuse({"new", "none", "--psd", "gap.csv", "-i", "0"}).code, 2);
    expect_in(
        "3kN", run_suffuse({"new", "none", "--psd", "wide gravel.csv", "--pressure", "3kN"}).error
    ); // before the curve
}

TEST_F(NewSoil, TheNumberOfGrainsCanBeSpecified) {
    const ProgramResult made = run_suffuse({"new", "--psd", "gap.csv", "--particles", "23456", "--json"});
    ASSERT_EQ(made.code, 0) << made.error;
    EXPECT_EQ(made.json().at("particles"), 23456);
    expect_in("particles       = 23456               # as specified\n", read_all(folder / "gap/case.toml"));
    EXPECT_EQ(run_suffuse({"plan", "gap/case.toml", "--json"}).json().at("stages").at(0).at("grains"), 23456);
    const ProgramResult few = run_suffuse({"new", "few", "--psd", "gap.csv", "--particles", "300"});
    EXPECT_EQ(few.code, 3);
    expect_in("--particles allows 300", few.error);
    const ProgramResult wider = run_suffuse({"new", "wider", "--psd", "wide gravel.csv", "--particles", "100000"});
    EXPECT_NE(wider.error, run_suffuse({"new", "wider", "--psd", "wide gravel.csv"}).error)
        << "the advice is for as many";
}

// A wide grading gets stiffer contacts, and so shorter steps: more than the number of grains suggests.
TEST_F(NewSoil, TheReportedPriceIsThatOfThePlan) {
    const ProgramResult made = run_suffuse({"new", "--psd", "gap.csv", "--json"});
    ASSERT_EQ(made.code, 0) << made.error;
    expect_in("14,800 grains in the preset quick: ", made.error);
    expect_in(" on this machine", made.error);
    const nlohmann::json planned = run_suffuse({"plan", "gap/case.toml", "--json"}).json();
    EXPECT_EQ(made.json().at("steps"), planned.at("steps")); // times measure a machine that other programs use too
    EXPECT_GT(made.json().at("seconds").at(0), 0);
    EXPECT_GE(made.json().at("seconds").at(1), made.json().at("seconds").at(0));
}

TEST_F(NewSoil, OfAWholeCurveThereIsOneVerdict) {
    const ProgramResult made = run_suffuse({"new", "--psd", "gap.csv", "--json"});
    ASSERT_EQ(made.code, 0) << made.error;
    const auto stability = made.json().at("stability");
    EXPECT_EQ(stability.at("given"), stability.at("modeled"));
    EXPECT_TRUE(stability.at("turned").empty());
    EXPECT_EQ(made.error.find("warning"), std::string::npos);
    expect_in(stability.at("given"), made.error);
}

TEST_F(NewSoil, AnOpenCurveIsModeledAsFarAsItWasMeasured) {
    write_to(folder / "open.csv", "d,passing\n0.1,5\n0.2,30\n0.4,70\n0.8,95\n");
    const ProgramResult made = run_suffuse({"new", "--psd", "open.csv", "--json"});
    ASSERT_EQ(made.code, 0) << made.error;
    EXPECT_EQ(made.json().at("left_out"), "the 5 % finer than 0.1 mm and the 5 % coarser than 0.8 mm");
    expect_in("\n0.1,5\n", read_all(folder / "open/data/open.csv"));
    expect_in("sizes = [\"0.1 mm\", \"0.8 mm\"]", read_all(folder / "open/case.toml"));
    EXPECT_EQ(run_suffuse({"check", "open/case.toml"}).code, 0);
}

TEST_F(NewSoil, TakesTheFinesThatAssessFindsAlsoOnAnOpenCurveOrTheSpecifiedOnes) {
    // Above 0 % at its fine end: counted from 0 anew, the sizes from 0.25 to 0.5 mm would be steep enough to be no gap.
    write_to(folder / "open.csv", "d,passing\n0.125,1\n0.25,20\n0.5,22.99\n1,24\n2,26\n4,100\n");
    const auto assessed = run_suffuse({"assess", "open.csv", "--json"}).json().at("soils").at(0).at("fine_fraction");
    EXPECT_EQ(assessed.at("finer_than"), 0.25e-3);
    const ProgramResult made = run_suffuse({"new", "--psd", "open.csv", "--particles", "1000000", "--json"});
    ASSERT_EQ(made.code, 0) << made.error;
    EXPECT_EQ(made.json().at("finer_than"), assessed.at("finer_than"));
    const ProgramResult explained =
        run_suffuse({"new", "mine", "--psd", "open.csv", "--fines", "0.2mm", "--particles", "1000000", "--json"});
    ASSERT_EQ(explained.code, 0) << explained.error;
    EXPECT_EQ(explained.json().at("finer_than"), 0.2e-3);
    EXPECT_EQ(explained.json().at("reason"), "as specified");
    expect_in("finer_than = \"0.2 mm\"", read_all(folder / "mine/case.toml"));
    const ProgramResult beyond = run_suffuse({"new", "none", "--psd", "open.csv", "--fines", "30mm"});
    EXPECT_EQ(beyond.code, 3);
    expect_in("100 % of it is finer than 30 mm", beyond.error);
}

TEST_F(NewSoil, AFolderMayStandBehindTheFileOfACurve) {
    EXPECT_EQ(run_suffuse({"new", "gap.csv", "of gap"}).code, 0);
    EXPECT_TRUE(exists(folder / "of gap/case.toml"));
    const ProgramResult two_folders = run_suffuse({"new", "no.csv", "of no"});
    EXPECT_EQ(two_folders.code, 2);
    expect_in("no.csv is no file of a grading curve", two_folders.error);
}

TEST_F(NewSoil, AFinesLimitBelowWhatWasMeasuredIsNamed) {
    for (const char* curve :
         {"0.075,35\n0.3,60\n1,80\n4,95\n10,100\n", "0.075,60\n0.425,80\n2,95\n4.75,100\n",
          "0.075,90\n0.425,96\n2,99\n4.75,100\n", "1,40\n2,90\n4,100\n"}) {
        write_to(folder / "open.csv", std::string("d [mm],passing [%]\n") + curve);
        const ProgramResult refused = run_suffuse({"new", "q", "--psd", "open.csv"});
        EXPECT_EQ(refused.code, 3) << curve;
        expect_in("where the measured curve begins at", refused.error);
        expect_in("--fines D", refused.error);
        expect_in("what to do says: suffuse new --psd open.csv", run_suffuse({"assess", "open.csv"}).error);
    }
    write_to(folder / "open.csv", "d [mm],passing [%]\n1,40\n2,90\n4,100\n");
    EXPECT_EQ(run_suffuse({"new", "q", "--psd", "open.csv", "--fines", "1.5mm"}).code, 0);
}

TEST_F(NewSoil, SuggestsCommandsThatNameTheSampleAndTheFilter) {
    write_to(folder / "two.csv", "d [mm],TP1,TP2\n0.002,0,0\n0.063,12,12\n0.3,20,20\n2,40,40\n20,75,70\n100,100,100\n");
    expect_in(
        "suffuse assess two.csv --sample TP1", run_suffuse({"new", "n", "--psd", "two.csv", "--sample", "TP1"}).error
    );
    write_to(folder / "silt.csv", "d [mm],passing [%]\n0.01,0\n0.02,100\n");
    write_to(folder / "drain.csv", "d [mm],passing [%]\n0.9,0\n1.1,100\n");
    expect_in(
        "suffuse assess silt.csv --filter drain.csv",
        run_suffuse({"new", "s", "--psd", "silt.csv", "--filter", "drain.csv"}).error
    );
    EXPECT_EQ(
        run_suffuse({"assess", "silt.csv", "--filter", "drain.csv"}).error.find("suffuse new silt.csv --filter"),
        std::string::npos
    );
    expect_in("write 2.65g/cm^3", run_suffuse({"assess", "silt.csv", "-i", "0.3", "--density", "2.65"}).error);
}

TEST_F(NewSoil, WrongUseSaysWhatToWrite) {
    const ProgramResult neither = run_suffuse({"new", "dyke"});
    EXPECT_EQ(neither.code, 2);
    expect_in("--psd FILE", neither.error);
    expect_in("fontainebleau-2016", neither.error);
    for (const auto& [words, part] : std::vector<std::pair<std::vector<std::string>, std::string>>{
             {{"--psd", "gap.csv", "--from", "replay"}, "excludes"},
             {{"--from", "replay", "--sizes", "1mm,2mm"}, "--psd"},
             {{"--psd", "gap.csv", "--sizes", "1mm"}, "0.1mm,4mm"},
             {{"--psd", "gap.csv", "--sizes", "1,2"}, "1mm"},
             {{"--psd", "gap.csv", "--sizes", "2mm,1mm"}, "comes first"}}) {
        std::vector<std::string> all{"new", "dyke"};
        all.insert(all.end(), words.begin(), words.end());
        const ProgramResult result = run_suffuse(all);
        EXPECT_EQ(result.code, 2) << words.back();
        expect_in(part, result.error);
    }
    const ProgramResult outside = run_suffuse({"new", "dyke", "--psd", "gap.csv", "--sizes", "0.8mm,2mm"});
    EXPECT_EQ(outside.code, 3);
    expect_in("choose sizes on both sides", outside.error);
    EXPECT_EQ(run_suffuse({"new", "--psd", "nowhere.csv"}).code, 74);
    write_to(folder / "flat.csv", "d,passing\n1,50\n2,50\n");
    EXPECT_EQ(run_suffuse({"new", "--psd", "flat.csv"}).code, 3);
    EXPECT_FALSE(std::filesystem::exists(folder / "dyke"));
}

} // namespace
} // namespace suffuse
