// suffuse assess, as a user calls it.

#include "suffuse/stability/criterion_guide.hpp"

#include "tests/support/program.hpp"
#include "tests/support/reference.hpp"
#include <cmath>
#include <set>
#include <sstream>

namespace suffuse {
namespace {

using namespace test;

const char* const gravel = "# two sizes, nothing between\nd [mm],passing [%]\n0.15,0\n0.3,25\n1,25\n2,100\n";

class Assess : public Cli {
protected:
    void SetUp() override { write_to(folder / "dyke.csv", gravel); }

    /// Exit code of `assess` with these words; what it says is in `out` and `error`.
    int call(const std::string& words) {
        std::vector<std::string> all{"assess"};
        std::istringstream text(words);
        for (std::string word; text >> word;) {
            all.push_back(word);
        }
        const ProgramResult result = run_suffuse(all);
        out = result.out, error = result.error;
        return result.code;
    }

    void expect_out(const std::string& part) const { expect_in(part, out); }

    std::string out, error;
};

TEST_F(Assess, SaysNumberLimitAndVerdictOfEachCriterion) {
    EXPECT_EQ(call("dyke.csv"), 0);
    expect_out("gap at 0.3-1 mm");
    expect_out("fines 25 % below 0.3 mm (fine end of the gap)");
    for (const char* line :
         {"Kenney and Lau 1985      (H/F)min 0.357             >= 1.3        unstable",
          "Chang and Zhang 2013     gap ratio Gr 3.33          < 3           unstable",
          "Sherard 1979             D15c/d85f 4.1              <= 5          stable", "unverified", "unstable ("}) {
        expect_out(line);
    }
    expect_in("suffuse new", error);
    EXPECT_EQ(out.find("seepage"), std::string::npos);
}

TEST_F(Assess, SaysThatAlmostNoFinesPassWhereTheConstrictionsAreTooNarrow) {
    write_to(folder / "uniform.csv", "d [mm],passing [%]\n0.8,0\n1,50\n1.25,100\n");
    EXPECT_EQ(call("uniform.csv --fines 0.9mm"), 0);
    expect_out("almost none of the finer grains are smaller than that");
}

TEST_F(Assess, WithAGradientSaysWhatMarginIsLeft) {
    EXPECT_EQ(call("dyke.csv -i 0.33"), 0);
    expect_out("upward seepage, i = 0.33; porosity 0.4, grains 2650 kg/m3");
    expect_out("factor of safety 3");
    expect_out("the fines stay in place only if alpha >= 0.333");
    EXPECT_EQ(call("dyke.csv -i 0.33 --alpha 0.5 --porosity 0.3 --density 2.6g/cm^3 --json"), 0);
    const auto gradients = nlohmann::json::parse(out)["soils"][0]["gradients"];
    EXPECT_NEAR(gradients[0]["limit"].get<double>(), 1.6 * 0.7, 1e-12);
    EXPECT_NEAR(gradients[1]["limit"].get<double>(), 0.5 * 1.6 * 0.7, 1e-12);
    EXPECT_EQ(gradients[1]["verdict"], "stable");
}

TEST_F(Assess, OfLevelFlowOnlyTheAtlasSaysSomething) {
    EXPECT_EQ(call("dyke.csv -i 0.33"), 0);
    expect_out("atlas of simulated soils: D50/d50 ");
    EXPECT_EQ(call("dyke.csv -i 0.33 --flow level"), 0);
    expect_out("level seepage, i = 0.33");
    expect_out("only upward flow lifts grains");
    EXPECT_EQ(out.find("factor of safety"), std::string::npos);
    EXPECT_EQ(call("dyke.csv -i 0.33 --flow level --json"), 0);
    const auto soil = nlohmann::json::parse(out)["soils"][0];
    EXPECT_TRUE(soil["gradients"].empty());
    EXPECT_EQ(soil["seepage"]["flow"], "level");
    ASSERT_FALSE(soil["atlas"].empty());
    for (const auto& entry : soil["atlas"]) {
        EXPECT_EQ(entry["flow"], "level");
        EXPECT_NEAR(entry["fines_content"].get<double>(), 0.25, 1e-12);
    }
    EXPECT_EQ(call("dyke.csv -i 0.33 --flow down"), 0);
    expect_out("it has upward and level flow, none downward");
    EXPECT_EQ(call("dyke.csv --flow level"), 2);
    expect_in("add -i I", error);
    EXPECT_EQ(call("dyke.csv -i 0.33 --flow sideways"), 2);
    expect_in("expected up, down, level, or the angle", error);
}

TEST_F(Assess, InclinedFlowIsHeldAgainstTheLimitOfVerticalFlow) {
    EXPECT_EQ(call("dyke.csv -i 0.33 --flow 30deg"), 0);
    expect_out("rising seepage at 30 degrees, i = 0.33");
    expect_out("the limit is that of vertical flow");
    EXPECT_EQ(call("dyke.csv -i 0.33 --flow 30deg --porosity 0.3 --density 2.6g/cm^3 --json"), 0);
    const auto soil = nlohmann::json::parse(out)["soils"][0];
    EXPECT_NEAR(soil["gradients"][0]["limit"].get<double>(), 1.6 * 0.7, 1e-12);
    EXPECT_EQ(soil["seepage"]["flow"], "30deg");
    std::set<std::string> flows;
    for (const auto& entry : soil["atlas"]) {
        flows.insert(entry["flow"].get<std::string>());
    }
    EXPECT_EQ(flows, (std::set<std::string>{"level", "up"})) << "between the two";
}

TEST_F(Assess, TakesSharesInPercent) {
    EXPECT_EQ(call("dyke.csv -i 33% --alpha 50% --porosity 30% --relative-density 70% --json"), 0);
    const auto soil = nlohmann::json::parse(out)["soils"][0];
    EXPECT_DOUBLE_EQ(soil["seepage"]["gradient"].get<double>(), 0.33);
    EXPECT_DOUBLE_EQ(soil["seepage"]["stress_share"].get<double>(), 0.5);
    EXPECT_DOUBLE_EQ(soil["seepage"]["porosity"].get<double>(), 0.3);
    EXPECT_EQ(call("dyke.csv --relative-density 170%"), 2);
    expect_in("or as in 50%", error);
    EXPECT_EQ(call("dyke.csv -i 3x%"), 2);
    EXPECT_EQ(call("dyke.csv -i 0,4"), 2);
    expect_in("write a decimal point", error);
    EXPECT_EQ(call("dyke.csv -i 12m/30m --json"), 0);
    EXPECT_EQ(nlohmann::json::parse(out)["soils"][0]["seepage"]["gradient"], 0.4);
}

TEST_F(Assess, JsonHasTheKeysOfTheFormatsPage) {
    EXPECT_EQ(call("dyke.csv --fines 0.3mm --relative-density 0.7 --json"), 0);
    const auto soil = nlohmann::json::parse(out)["soils"][0];
    EXPECT_EQ(soil["soil"], "dyke.csv");
    EXPECT_NEAR(soil["gap"]["to"].get<double>(), 1e-3, 1e-15);
    EXPECT_EQ(soil["fine_fraction"]["basis"], "as given");
    EXPECT_EQ(soil["criteria"].size() + 2, stability::criterion_ids().size()); // two are of gradients
    EXPECT_EQ(soil["criteria"][1]["id"], "kenney-lau-1986");
    EXPECT_EQ(soil["criteria"][1]["verdict"], "unstable");
    EXPECT_EQ(soil["criteria"][1]["sense"], "at-least");
    EXPECT_EQ(soil["criteria"][1]["stable_if"], ">= 1");
    EXPECT_EQ(soil["criteria"].back()["verified"], false);
    for (const char* key :
         {"sizes", "uniformity", "finer_limit", "constrictions", "summary", "seepage", "gradients", "atlas"}) {
        EXPECT_TRUE(soil.contains(key)) << key;
    }
}

TEST_F(Assess, WritesAPageWithFiguresAndNumbers) {
    EXPECT_EQ(call("dyke.csv -o pages/dyke"), 0);
    expect_out("pages/dyke/report.html");
    const std::string page = read_all(folder / "pages/dyke/report.html");
    expect_in("Internal stability of dyke.csv", page);
    expect_in("Kenney and Lau 1985", page);
    EXPECT_EQ(page.find("id=\"quality\""), std::string::npos);
    for (const char* file : {"own-stability-grading", "own-stability-shape"}) {
        const auto chart =
            nlohmann::json::parse(read_all(folder / "pages/dyke/figures" / (std::string(file) + ".vl.json")));
        EXPECT_GT(chart["data"]["values"].size(), 5U);
        EXPECT_NE(read_all(folder / "pages/dyke/figures" / (std::string(file) + ".csv")), "");
    }
    EXPECT_EQ(nlohmann::json::parse(read_all(folder / "pages/dyke/assessment.json"))["soil"], "dyke.csv");
}

TEST_F(Assess, OfSeveralSoilsTheGradientsAreColumns) {
    write_to(folder / "well.csv", "d [mm],passing [%]\n0.1,0\n0.15,10\n0.25,30\n0.4,55\n0.63,80\n1,100\n");
    EXPECT_EQ(call("dyke.csv well.csv -i 0.3 --flow up --porosity 0.35"), 0);
    expect_out("upward seepage, i = 0.3; porosity 0.35");
    expect_out("T Terzaghi, SB94 Skempton and Brogan 1994, each with its critical gradient");
    expect_out("s 1.07   ?\n");      // alpha of the gap-graded one is not known
    expect_out("s 1.07   s 1.07\n"); // the other carries with all its grains
    EXPECT_EQ(call("dyke.csv well.csv -i 0.3 --flow level"), 0);
    expect_out("only upward flow lifts grains");
    EXPECT_EQ(out.find("Terzaghi"), std::string::npos) << out;
    EXPECT_EQ(call("dyke.csv well.csv"), 0);
    EXPECT_EQ(out.find("seepage"), std::string::npos) << out;
}

TEST_F(Assess, TakesTheSoilsOfACase) {
    EXPECT_EQ(call(test::in_checkout("examples/fontainebleau-2016/case.toml") + " --json"), 0);
    const auto soils = nlohmann::json::parse(out)["soils"];
    ASSERT_EQ(soils.size(), 1U);
    EXPECT_NEAR(soils[0]["fine_fraction"]["finer_than"].get<double>(), 0.26e-3, 1e-15);
    EXPECT_EQ(soils[0]["tally"]["unstable"], 0);
}

TEST_F(Assess, ComparesManySamplesAndNamesTheWorst) {
    write_to(folder / "wide.csv", "d [mm],A,B\n0.1,0,0\n0.2,15,22\n0.63,60,25\n2,90,30\n6.3,100,100\n");
    EXPECT_EQ(call("dyke.csv wide.csv"), 0);
    expect_out("wide.csv, A");
    expect_out("worst: ");
    expect_in("2 columns are read as cumulative shares", error);
    EXPECT_EQ(call("dyke.csv wide.csv --json"), 0);
    const auto parsed = nlohmann::json::parse(out);
    EXPECT_EQ(parsed["soils"].size(), 3U);
    EXPECT_EQ(parsed["matrix"]["soils"][1]["soil"], "wide.csv, A");
    EXPECT_EQ(parsed["remarks"].size(), 1U);
    const std::string worst = parsed["matrix"]["worst"];
    for (const auto& soil : parsed["soils"]) { // as counted here
        const int unstable = soil["tally"]["unstable"];
        EXPECT_LE(
            unstable, (worst == "dyke.csv" ? parsed["soils"][0] : parsed["soils"][2])["tally"]["unstable"].get<int>()
        );
    }
    EXPECT_EQ(call("wide.csv --sample b"), 0);
    expect_out("wide.csv, B");
    EXPECT_EQ(call("wide.csv --sample C"), 3);
    expect_in("it has A, B", error);
    EXPECT_EQ(call("wide.csv -o pages"), 0);
    expect_in("own-stability-overlay", read_all(folder / "pages/report.html"));
    EXPECT_TRUE(std::filesystem::exists(folder / "pages/002-B/report.html"));
}

TEST_F(Assess, AFileThatCannotBeReadLeavesTheOthersJudged) {
    write_to(folder / "bad.csv", "d [mm],passing [%]\n0.1,0\n0.2,70\n0.3,60\n");
    write_to(folder / "sand.csv", "d [mm],passing [%]\n0.1,0\n0.2,40\n0.4,100\n");
    EXPECT_EQ(call("bad.csv nowhere.csv dyke.csv sand.csv"), 3) << "the code of the first error";
    expect_in("bad.csv:4", error);
    expect_in("nowhere.csv", error);
    expect_out("worst: ");
    EXPECT_EQ(call("nowhere.csv dyke.csv --json"), 74);
    const auto parsed = nlohmann::json::parse(out);
    ASSERT_EQ(parsed["soils"].size(), 1U);
    EXPECT_EQ(parsed["errors"].size(), 1U);
    EXPECT_EQ(parsed["errors"][0]["file"], "nowhere.csv");
    EXPECT_EQ(parsed["errors"][0]["kind"], "io");
    expect_in("suffuse new --psd dyke.csv", error); // what can be done with the one that is left
    EXPECT_EQ(call("bad.csv dyke.csv --show-reading --json"), 3);
    EXPECT_EQ(nlohmann::json::parse(out)["soils"].size(), 1U);
    EXPECT_EQ(call("dyke.csv sand.csv --fines 0.18mm --json"), 0);
    EXPECT_EQ(call("dyke.csv sand.csv --fines 0.13mm --json"), 3) << "the dyke has nothing that fine";
    EXPECT_EQ(nlohmann::json::parse(out)["soils"][0]["soil"], "sand.csv");
    EXPECT_EQ(nlohmann::json::parse(out)["errors"][0]["file"], "dyke.csv");
    EXPECT_EQ(call("bad.csv nowhere.csv --json"), 3);
    EXPECT_EQ(nlohmann::json::parse(out)["errors"].size(), 2U);
    EXPECT_EQ(call("dyke.csv sand.csv --json"), 0);
    EXPECT_FALSE(nlohmann::json::parse(out).contains("errors"));
}

TEST_F(Assess, JudgesAFilterBetweenTwoSoils) {
    write_to(folder / "filter.csv", "d [mm],passing [%]\n2,0\n8,100\n");
    EXPECT_EQ(call("dyke.csv --filter filter.csv"), 0);
    expect_out("The filter filter.csv fails by 2 of 7 rules: Terzaghi and Peck, No erosion (NRCS 2017)");
    expect_out("D15F/d85B");
    EXPECT_EQ(call("dyke.csv --filter filter.csv --json"), 0);
    const auto filter = nlohmann::json::parse(out)["soils"][0]["filter"]["criteria"];
    ASSERT_EQ(filter.size(), 8U);
    // D15F = 2 * 4^0.15 mm; the base is regraded on the fine end of its gap, 0.3 mm: 85 % of what is finer lie at 0.15
    // * 2^0.85 mm.
    EXPECT_NEAR(filter[0]["value"].get<double>(), 2 * std::pow(4, 0.15) / (0.15 * std::pow(2, 0.85)), 1e-9);
    EXPECT_EQ(filter[0]["verdict"], "fails");
    const auto simulated = nlohmann::json::parse(out)["soils"][0]["filter"]["simulated"];
    EXPECT_EQ(simulated["size_ratio"], filter[0]["value"]);
    EXPECT_NEAR(simulated["base_width"].get<double>(), std::pow(2, 0.70), 1e-9) << "of the regraded base";
    EXPECT_FALSE(simulated["gradients"].empty());
}

TEST_F(Assess, SaysHowTheFilterWasUnderstood) {
    write_to(folder / "filter.csv", "d [mm],passing\n2,0\n4,0.5\n8,1\n");
    EXPECT_EQ(call("dyke.csv --filter filter.csv --json"), 0);
    const auto remarks = nlohmann::json::parse(out)["remarks"];
    ASSERT_EQ(remarks.size(), 1U);
    expect_in("filter.csv:4: shares are read as fractions", remarks[0]);
}

TEST_F(Assess, TakesAFilterOutOfATableOfSeveralSamples) {
    write_to(
        folder / "all.csv", "d [mm],base,drain,coarse\n0.5,0,0,0\n1,100,0,0\n2,100,0,0\n4,100,100,40\n32,100,100,100\n"
    );
    EXPECT_EQ(call("dyke.csv --filter all.csv"), 3);
    expect_in("choose it by --filter-sample NAME", error);
    EXPECT_EQ(call("all.csv --sample base --filter all.csv --filter-sample drain"), 0) << error;
    expect_out("The filter all.csv, drain");
    expect_in("suffuse new all.csv --sample base --filter all.csv --filter-sample drain", error);
    EXPECT_EQ(call("all.csv --sample base --filter all.csv --filter-sample sand"), 3);
    expect_in("no sample sand; it has base, drain, coarse", error);
    EXPECT_EQ(call("dyke.csv --filter-sample drain"), 2);
    EXPECT_EQ(call("dyke.csv --sample TP1"), 3);
    expect_in("names no sample", error);
}

TEST_F(Assess, SaysTheFiltersVerdictInTheReportOnThePageAndUnderThePicture) {
    write_to(folder / "filter.csv", "d [mm],passing [%]\n2,0\n8,100\n");
    EXPECT_EQ(call("dyke.csv --filter filter.csv -o dyke"), 0) << error;
    const std::string report = read_all(folder / "dyke/report.html");
    expect_in("The filter filter.csv fails by 2 of 7 rules.", report);
    expect_in("Terzaghi and Peck", report);
    const auto about = nlohmann::json::parse(read_all(folder / "dyke/assessment.json"));
    EXPECT_EQ(about["filter"]["verdict"], "fails");
    expect_in("No simulated base is like this one", report);
    expect_in("own-stability-filter", report);
    EXPECT_EQ(call("dyke.csv --filter filter.csv --page -o page.html"), 0) << error;
    expect_in("fails by 2 of 7 rules", read_all(folder / "page.html"));
}

using DrawingAssess = Drawing<Assess>;

TEST_F(DrawingAssess, DrawsTheCurvesAloneIntoAFile) {
    EXPECT_EQ(call("dyke.csv -o curves.svg"), 0) << error;
    expect_in("<svg", read_all(folder / "curves.svg"));
    EXPECT_EQ(call("dyke.csv -o curves.pdf"), 0) << error;
    const std::string pdf = read_all(folder / "curves.pdf");
    EXPECT_EQ(pdf.substr(0, 5), "%PDF-");
    EXPECT_NE(pdf.find("%%EOF"), std::string::npos);
    EXPECT_EQ(call("dyke.csv -o curves.png"), 0) << error;
    EXPECT_EQ(read_all(folder / "curves.png").substr(1, 3), "PNG");
}

TEST_F(Assess, ReadsStandardInputAndPipesUpToTheSizeOfAGrading) {
    const auto from = [this](const std::string& file) {
        const ProgramResult result =
            wait_for(start({"assess", "-", "--json"}, {}, [file] { dup2(open(file.c_str(), O_RDONLY), STDIN_FILENO); })
            );
        out = result.out, error = result.error;
        return result.code;
    };
    EXPECT_EQ(from("dyke.csv"), 0) << error;
    const auto soil = nlohmann::json::parse(out)["soils"][0];
    EXPECT_EQ(soil["criteria"][1]["verdict"], "unstable");
    EXPECT_EQ(soil["soil"], "-");
    EXPECT_EQ(from("/dev/null"), 3);
    EXPECT_EQ(from("/dev/zero"), 74);
    expect_in("larger than 64 MiB", out + error);
    ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
    EXPECT_EQ(call("pipe"), 3); // nobody writes into it: it is empty, and not waited for
    expect_in("the file is empty", error);
}

TEST_F(Assess, WritesAPageToPlayWith) {
    EXPECT_EQ(call("dyke.csv --page -i 0.25 --alpha 0.2 -o dyke.html"), 0);
    const std::string page = read_all(folder / "dyke.html");
    expect_in("\"gradient\":0.25", page);
    expect_in("\"alpha\":0.2", page);
    expect_in("default-src 'none'", page); // it loads nothing
    for (const char* mark : {"@DATA@", "@SCRIPT@", "@STYLE@", "@PROGRAM@", "http://", "https://"}) {
        EXPECT_EQ(page.find(mark), std::string::npos) << mark;
    }
}

TEST_F(Assess, ThePageBeginsWithTheSeepageThatWasSpecifiedAndWithNoOther) {
    EXPECT_EQ(
        call("dyke.csv --page -i 0.25 --flow level --porosity 0.3 --alpha 0.2 --density 2700kg/m^3 -o level.html"), 0
    );
    expect_in(
        R"("seepage":{"alpha":0.2,"density":2700.0,"flow":"level","gradient":0.25,"porosity":0.3})",
        read_all(folder / "level.html")
    );
    expect_in("\"place\":{\"fines\":0.25,", read_all(folder / "level.html"));
    EXPECT_EQ(call("dyke.csv --page -o none.html"), 0);
    expect_in(R"("flow":"upward","gradient":null,)", read_all(folder / "none.html"));
}

TEST_F(Assess, ReportsClassesOfSizeAndTheNumberOfTheMeasuredPart) {
    EXPECT_EQ(call("dyke.csv"), 0);
    expect_out("ASTM D2487: sand 100 %");
    write_to(folder / "open.csv", "d [mm],passing [%]\n0.063,4\n0.2,15\n0.63,40\n2,70\n6.3,100\n");
    EXPECT_EQ(call("open.csv --json"), 0);
    const auto criteria = nlohmann::json::parse(out)["soils"][0]["criteria"];
    EXPECT_EQ(criteria[0]["verdict"], "cannot say");
    EXPECT_GT(criteria[0]["measured"].get<double>(), 1.3);
}

TEST_F(Assess, ReadsTheColumnsThatAreNamed) {
    write_to(folder / "named.csv", "A,B,C\n63,28,10\n200,22,60\n630,50,100\n");
    EXPECT_EQ(call("named.csv --size A:um --passing C --show-reading"), 0);
    expect_out("sizes: A, in um; shares: C, read as percent passing, in %\n       0.063 mm         10 %\n");
    EXPECT_EQ(call("named.csv --size A:um --share 2 --show-reading --json"), 0);
    const auto shown = nlohmann::json::parse(out)["soils"][0];
    EXPECT_EQ(shown["reading"]["size"], "A");
    EXPECT_EQ(shown["reading"]["unit"], "um");
    EXPECT_EQ(shown["reading"]["share"], "B");
    EXPECT_EQ(shown["reading"]["kind"], "retained on each sieve alone");
    EXPECT_EQ(shown["reading"]["share_unit"], "%");
    EXPECT_EQ(shown["reading"]["flag"], "share");
    EXPECT_TRUE(shown["reading"]["remarks"].is_array());
    EXPECT_NEAR(shown["passing"][1].get<double>(), 0.28, 1e-12);
    EXPECT_EQ(call("named.csv --size A:um --passing C"), 0);
    expect_in("--size A:um --passing C", error); // so that the next command reads it, too
    EXPECT_EQ(call("named.csv --size D --passing C"), 3);
    expect_in("there is no column `D`", error);
    EXPECT_EQ(call("named.csv --by volume"), 2);
}

TEST_F(Assess, ARefusalNamesTheCommandThatWorks) {
    write_to(folder / "both.csv", "d_mm,weight_percent\n2,5\n1,10\n0.5,15\n0.25,20\n0.125,22\n0.063,28\n");
    EXPECT_EQ(call("both.csv"), 3);
    expect_in("--size 1:mm --share 2 or --size 1:mm --retained 2", error);
    EXPECT_EQ(call("both.csv --size 1:mm --share 2"), 0);
    expect_out("d10 0.0805  d50 0.25  d60 0.354 mm  Cu 4.39");
}

TEST_F(Assess, BadInputIsNamedWithItsPlace) {
    write_to(folder / "bad.csv", "d [mm],passing [%]\n0.1,0\n0.2,70\n0.3,60\n0.4,120\n");
    EXPECT_EQ(call("bad.csv"), 3);
    expect_in("bad.csv:5:5", error);
    EXPECT_EQ(call("nowhere.csv"), 74);
    EXPECT_EQ(call("dyke.csv --fines 0.3"), 2);
    expect_in("0.3mm", error);
    EXPECT_EQ(call("dyke.csv --fines 5mm"), 3);
    expect_in("between 0.15 and 2 mm", error);
    EXPECT_EQ(call("dyke.csv --relative-density 70"), 2);
    EXPECT_EQ(call("dyke.csv -i -1"), 2);
    EXPECT_EQ(call("dyke.csv --porosity 0.3"), 2);
    expect_in("-i", error);
    EXPECT_EQ(call(test::in_checkout("examples/replay/case.toml")), 3);
}

} // namespace
} // namespace suffuse
