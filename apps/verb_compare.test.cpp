// compare and verify as a user calls them: code 5 and what differs.

#include "suffuse/record/stage_sums.hpp"

#include "tests/support/program.hpp"
#include <sstream>

namespace suffuse {
namespace {

using namespace test;

class Compare : public Cli {
protected:
    void SetUp() override {
        ASSERT_EQ(run_suffuse({"new", "soil", "--from", "replay"}).code, 0);
        ASSERT_EQ(run("first", {}).code, 0);
    }

    ProgramResult run(const std::string& name, std::vector<std::string> more) {
        more.insert(more.begin(), {"run", "soil/case.toml", "-q", "--no-cache", "-o", name});
        return run_suffuse(more);
    }
};

TEST_F(Compare, TheSameRunWithOtherThreadsDoesNotDiffer) {
    ASSERT_EQ(run("second", {"-j", "2"}).code, 0);
    const ProgramResult result = run_suffuse({"compare", "first", "second", "--json"});
    EXPECT_EQ(result.code, 0) << result.out << result.error;
    const nlohmann::json found = result.json();
    EXPECT_EQ(found.at("stages"), 4);
    EXPECT_EQ(found.at("same_states"), 4);
    EXPECT_GT(found.at("numbers"), 100);
    EXPECT_TRUE(found.at("differences").empty());
    EXPECT_TRUE(found.at("circumstances").empty());
}

TEST_F(Compare, AnotherPressureIsCodeFiveAndSaysWhereItDiffers) {
    ASSERT_EQ(run("second", {"--set", "study.replay.stage.settled.pressure=101 kPa"}).code, 0);
    const ProgramResult result = run_suffuse({"compare", "first", "second", "-v"});
    EXPECT_EQ(result.code, 5);
    expect_in("case - study.replay.stage.settled.stress = [\"100 kPa\"", result.out); // as --set takes it
    expect_in("case + study.replay.stage.settled.stress = [\"101 kPa\"", result.out);
    expect_in("replay/settled: mean_stress", result.out);
    expect_in("state_hash", result.out);
    // The pressures differ by 1 %: within 2 % of each other, as the void ratios are; one can differ and the other not.
    const nlohmann::json near = run_suffuse({"compare", "first", "second", "--tolerance", "2 %", "--json"}).json();
    for (const nlohmann::json& difference : near.at("differences")) {
        EXPECT_GT(difference.at("relative"), 0.02) << difference;
        EXPECT_NE(difference.at("where"), "replay/settled: mean_stress");
        EXPECT_NE(difference.at("where"), "replay/settled: void_ratio");
    }
    EXPECT_LT(
        near.at("differences").size(),
        run_suffuse({"compare", "first", "second", "--json"}).json().at("differences").size()
    );
}

TEST_F(Compare, WhetherAndHowMuchRunsDifferComesFirstAndResultsComeBeforeNoise) {
    ASSERT_EQ(run("second", {"--set", "study.replay.stage.settled.pressure=101 kPa"}).code, 0);
    const ProgramResult result = run_suffuse({"compare", "first", "second", "-v"});
    EXPECT_EQ(result.out.rfind("the runs differ in ", 0), 0U) << result.out.substr(0, 200);
    const auto place = [&](const char* what) {
        const std::size_t at = result.out.find(what);
        EXPECT_NE(at, std::string::npos) << what;
        return at;
    };
    EXPECT_LT(place("case - "), place("results of stages:"));
    EXPECT_LT(place("replay/settled: mean_stress"), place("numbers behind figures:"));
    EXPECT_LT(place("numbers behind figures:"), place("how it was computed (not a result):"));
    const std::size_t noise = place("how it was computed (not a result):");
    for (const char* const what : {"state_hash", "unbalanced_force", "force_sum[1]", "force_sum_error", "residual"}) {
        EXPECT_GT(place(what), noise) << what;
    }
    expect_in("replay/settled: mean_stress   1.0001e+05 and 1.0101e+05   0.989 %", result.out);
}

TEST_F(Compare, AShearStressIsReportedRelativeToTheStressNotToItsChance) {
    std::filesystem::copy(folder / "first", folder / "second", std::filesystem::copy_options::recursive);
    const std::filesystem::path kept = folder / "second/studies/replay/settled/stage.json";
    nlohmann::json stage = nlohmann::json::parse(read_all(kept));
    stage["stress"][0][1] = stage.at("stress")[0][1].get<double>() + 1e3;
    record::seal_stage(kept.parent_path(), stage); // as a stage that ended with it
    const ProgramResult result = run_suffuse({"compare", "first", "second", "--json"});
    const nlohmann::json differences = result.json().at("differences");
    ASSERT_EQ(differences.size(), 1U) << result.out;
    EXPECT_EQ(differences[0].at("where"), "replay/settled: stress[0][1]");
    EXPECT_NEAR(differences[0].at("relative").get<double>(), 0.01, 1e-4); // of 100 kPa, within the servo's tolerance
}

TEST_F(Compare, RunsThatDifferOnlyInHowTheyWereComputedHaveTheSameResults) {
    std::filesystem::copy(folder / "first", folder / "second", std::filesystem::copy_options::recursive);
    const std::filesystem::path kept = folder / "second/studies/replay/seep/stage.json";
    nlohmann::json stage = nlohmann::json::parse(read_all(kept));
    stage["residual"] = 2 * stage.at("residual").get<double>();
    record::seal_stage(kept.parent_path(), stage); // as a stage that computed it so
    const ProgramResult result = run_suffuse({"compare", "first", "second"});
    EXPECT_EQ(result.code, 5);
    expect_in("the same results, with 1 difference in how they were computed", result.out);
}

TEST_F(Compare, AFigureThatLostTheValuesOfItsLastColumnDiffers) {
    std::filesystem::copy(folder / "first", folder / "second", std::filesystem::copy_options::recursive);
    const std::filesystem::path table = folder / "second/figures/own-throat-flux.csv";
    std::istringstream whole(read_all(table));
    std::string emptied;
    int rows = 0;
    for (std::string line; std::getline(whole, line);) {
        if (!line.starts_with('#') && rows++ > 0) { // the first names the columns
            line.erase(line.rfind(',') + 1);
        }
        emptied += line + "\n";
    }
    write_to(table, emptied);
    const ProgramResult refused = run_suffuse({"compare", "first", "second"});
    EXPECT_EQ(refused.code, 74);
    expect_in("second/figures/own-throat-flux.csv was changed since the run ended", refused.error);
    std::filesystem::remove(folder / "second/SHA256SUMS"); // as of a report that wrote it so
    const ProgramResult result = run_suffuse({"compare", "first", "second", "-v"});
    EXPECT_EQ(result.code, 5) << result.out;
    expect_in("figure own-throat-flux: ", result.out);
}

TEST_F(Compare, ARunThatLacksAStageDiffersInIt) {
    ASSERT_EQ(run("second", {"--until", "settled"}).code, 0);
    const ProgramResult result = run_suffuse({"compare", "first", "second"});
    EXPECT_EQ(result.code, 5);
    expect_in("replay/seep   done and not there", result.out);
}

TEST_F(Compare, RunsWithoutACommonStageAreReportedWithTheStagesOfEach) {
    std::string text = read_all(folder / "soil/case.toml");
    for (std::size_t at = 0; (at = text.find("study.replay", at)) != std::string::npos;) {
        text.replace(at, 12, "study.second");
    }
    write_to(folder / "soil/case.toml", text);
    ASSERT_EQ(run("second", {"--until", "settled"}).code, 0);
    const ProgramResult result = run_suffuse({"compare", "first", "second"});
    EXPECT_EQ(result.code, 5);
    expect_in("nothing to compare: no stage of the same study, sample and name is in both", result.out);
    expect_in("first has replay/compressed, ", result.out);
    expect_in("second has second/settled, second/start", result.out);
    EXPECT_EQ(result.out.find("case - "), std::string::npos);
    EXPECT_EQ(run_suffuse({"compare", "first", "second", "--json"}).json().at("only_second").size(), 2U);
}

TEST_F(Compare, WithThePaperEachFindingIsJudged) {
    const ProgramResult result = run_suffuse({"compare", "first", "--paper", "--json"});
    EXPECT_EQ(result.code, 0) << result.error; // the replay holds nothing that the paper speaks of
    EXPECT_TRUE(result.json().at("findings").empty());
    nlohmann::json summary = nlohmann::json::parse(read_all(folder / "first/summary.json"));
    std::filesystem::remove(folder / "first/SHA256SUMS"); // as of a report that wrote it so
    const nlohmann::json claim = {{"claim", "c"}, {"paper", "30 %"}, {"ours", "31 %"}};
    summary["findings"] = {claim, claim};
    summary["findings"][0].update({{"id", "M1"}, {"met", true}});
    summary["findings"][1].update({{"id", "M2"}, {"met", nullptr}});
    write_to(folder / "first/summary.json", summary.dump());
    EXPECT_EQ(run_suffuse({"compare", "first", "--paper"}).code, 0) << "what is undecided is no difference";
    summary["findings"][1].update(
        {{"met", false},
         {"verdict", "not met by our number"},
         {"our_numbers", {"25 to 35 %"}},
         {"why", "The skeleton was kept."}}
    );
    write_to(folder / "first/summary.json", summary.dump());
    const ProgramResult other = run_suffuse({"compare", "first", "--paper"});
    EXPECT_EQ(other.code, 5);
    expect_in("M1  met", other.out); // of a run that an earlier version reported
    expect_in("M2  not met by our number", other.out);
    expect_in("our number 25 to 35 %", other.out);
    expect_in("why        The skeleton was kept.", other.out);
    summary["findings"][1].update({{"met", nullptr}, {"verdict", "met by noise"}});
    write_to(folder / "first/summary.json", summary.dump());
    EXPECT_EQ(run_suffuse({"compare", "first", "--paper"}).code, 5) << "agreement by noise is none";
}

TEST_F(Compare, WrongUseSaysWhatToGive) {
    EXPECT_EQ(run_suffuse({"compare", "first"}).code, 2);
    EXPECT_EQ(run_suffuse({"compare", "first", "first", "--paper"}).code, 2);
    EXPECT_EQ(run_suffuse({"compare", "first", "first", "--tolerance", "much"}).code, 2);
    EXPECT_EQ(run_suffuse({"compare", "first", "first", "--tolerance", "200 %"}).code, 2);
    const ProgramResult none = run_suffuse({"compare", "first", "soil"});
    EXPECT_EQ(none.code, 74);
    expect_in("holds no run", none.error);
}

TEST_F(Compare, AWholeRunIsVerifiedAndSha256sumAgrees) {
    const ProgramResult result = run_suffuse({"verify", "first", "--json"});
    EXPECT_EQ(result.code, 0) << result.out << result.error;
    EXPECT_GT(result.json().at("files"), 10);
    EXPECT_EQ(result.json().at("states"), 4);
    EXPECT_EQ(std::system(("cd '" + (folder / "first").string() + "' && sha256sum --quiet -c SHA256SUMS").c_str()), 0);
    ASSERT_EQ(run_suffuse({"report", "first"}).code, 0);
    EXPECT_EQ(run_suffuse({"verify", "first"}).code, 0) << "the report wrote its checksums anew";
}

TEST_F(Compare, WhatWasChangedLostOrAddedIsFound) {
    const std::string stage = "studies/replay/settled/";
    write_to(
        folder / ("first/" + stage + "history.csv"), read_all(folder / ("first/" + stage + "history.csv")) + "1\n"
    );
    ASSERT_TRUE(std::filesystem::remove(folder / "first/figures/own-throat-flux.csv"));
    std::filesystem::remove(folder / "first/summary.json");
    write_to(folder / "first/notes.txt", "mine");
    const ProgramResult result = run_suffuse({"verify", "first", "-v"});
    EXPECT_EQ(result.code, 5);
    expect_in(stage + "history.csv was changed", result.out);
    expect_in("summary.json is missing", result.out);
    expect_in("own-throat-flux.csv is missing", result.out);
    expect_in("notes.txt", result.error);
    EXPECT_EQ(result.out.find("notes.txt"), std::string::npos) << "what came later is no damage";
}

TEST_F(Compare, AStateThatIsNotTheRecordedOneIsFound) {
    // As if someone had edited a number and then written the checksums of the stage and of the run anew.
    const std::string file = "studies/replay/settled/stage.json";
    nlohmann::json numbers = nlohmann::json::parse(read_all(folder / ("first/" + file)));
    numbers["state_hash"] = "0123456789abcdef";
    record::seal_stage((folder / ("first/" + file)).parent_path(), numbers);
    ASSERT_EQ(run_suffuse({"report", "first"}).code, 0);
    const ProgramResult result = run_suffuse({"verify", "first"});
    EXPECT_EQ(result.code, 5);
    expect_in(file + " records the state 0123456789abcdef, but state.h5 holds", result.out);
}

TEST_F(Compare, AnInterruptedRunIsReportedWithItsMissingStages) {
    std::filesystem::remove(folder / "first/SHA256SUMS");
    const ProgramResult ended = run_suffuse({"verify", "first"});
    EXPECT_EQ(ended.code, 74);
    expect_in("suffuse report first writes them", ended.error);
    std::filesystem::remove(folder / "first/studies/replay/seep/stage.json");
    const ProgramResult result = run_suffuse({"verify", "first"});
    EXPECT_EQ(result.code, 74);
    expect_in("1 of 4 stages are missing: replay/seep; suffuse resume first continues it", result.error);

    ASSERT_EQ(run_suffuse({"report", "first"}).code, 0);
    expect_in(
        "<b>This run is not complete.</b> 1 of 4 stages are missing: replay/seep.",
        read_all(folder / "first/report.html")
    );
    const ProgramResult partial = run_suffuse({"verify", "first"});
    EXPECT_EQ(partial.code, 5);
    expect_in("unchanged, but not complete", partial.out);
    expect_in("continue with suffuse resume first", partial.out);

    ASSERT_EQ(run_suffuse({"resume", "first"}).code, 0);
    EXPECT_EQ(read_all(folder / "first/report.html").find("not complete"), std::string::npos);
    EXPECT_EQ(run_suffuse({"verify", "first"}).code, 0);
    EXPECT_EQ(run_suffuse({"verify", "soil"}).code, 74);
}

} // namespace
} // namespace suffuse
