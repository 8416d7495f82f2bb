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
        ASSERT_EQ(say({"new", "soil", "--from", "replay"}).code, 0);
        ASSERT_EQ(run("first", {}).code, 0);
    }

    Said run(const std::string& name, std::vector<std::string> more) {
        more.insert(more.begin(), {"run", "soil/case.toml", "-q", "--no-cache", "-o", name});
        return say(more);
    }
};

TEST_F(Compare, TheSameRunWithOtherThreadsDoesNotDiffer) {
    ASSERT_EQ(run("second", {"-j", "2"}).code, 0);
    const Said said = say({"compare", "first", "second", "--json"});
    EXPECT_EQ(said.code, 0) << said.out << said.error;
    const nlohmann::json found = said.json();
    EXPECT_EQ(found.at("stages"), 4);
    EXPECT_EQ(found.at("same_states"), 4);
    EXPECT_GT(found.at("numbers"), 100);
    EXPECT_TRUE(found.at("differences").empty());
    EXPECT_TRUE(found.at("circumstances").empty());
}

TEST_F(Compare, AnotherPressureIsCodeFiveAndSaysWhereItDiffers) {
    ASSERT_EQ(run("second", {"--set", "study.replay.stage.settled.pressure=101 kPa"}).code, 0);
    const Said said = say({"compare", "first", "second", "-v"});
    EXPECT_EQ(said.code, 5);
    expect_in("case - study.replay.stage.settled.stress = [\"100 kPa\"", said.out); // as --set takes it
    expect_in("case + study.replay.stage.settled.stress = [\"101 kPa\"", said.out);
    expect_in("replay/settled: mean_stress", said.out);
    expect_in("state_hash", said.out);
    // The pressures differ by 1 %: within 2 % of each other, as the void ratios are; one can differ and the other not.
    const nlohmann::json near = say({"compare", "first", "second", "--tolerance", "2 %", "--json"}).json();
    for (const nlohmann::json& difference : near.at("differences")) {
        EXPECT_GT(difference.at("relative"), 0.02) << difference;
        EXPECT_NE(difference.at("where"), "replay/settled: mean_stress");
        EXPECT_NE(difference.at("where"), "replay/settled: void_ratio");
    }
    EXPECT_LT(
        near.at("differences").size(), say({"compare", "first", "second", "--json"}).json().at("differences").size()
    );
}

TEST_F(Compare, WhetherAndHowMuchRunsDifferIsSaidFirstAndResultsComeBeforeNoise) {
    ASSERT_EQ(run("second", {"--set", "study.replay.stage.settled.pressure=101 kPa"}).code, 0);
    const Said said = say({"compare", "first", "second", "-v"});
    EXPECT_EQ(said.out.rfind("the runs differ in ", 0), 0U) << said.out.substr(0, 200);
    const auto place = [&](const char* what) {
        const std::size_t at = said.out.find(what);
        EXPECT_NE(at, std::string::npos) << what;
        return at;
    };
    EXPECT_LT(place("case - "), place("results of stages:"));
    EXPECT_LT(place("replay/settled: mean_stress"), place("numbers behind figures:"));
    EXPECT_LT(place("numbers behind figures:"), place("how it was computed, which is no result:"));
    const std::size_t noise = place("how it was computed, which is no result:");
    for (const char* const what : {"state_hash", "unbalanced_force", "force_sum[1]", "force_sum_error", "residual"}) {
        EXPECT_GT(place(what), noise) << what;
    }
    expect_in("replay/settled: mean_stress   1.0001e+05 and 1.0101e+05   0.989 %", said.out);
}

TEST_F(Compare, AShearStressIsToldAgainstTheStressAndNotAgainstItsOwnChance) {
    std::filesystem::copy(folder / "first", folder / "second", std::filesystem::copy_options::recursive);
    const std::filesystem::path kept = folder / "second/studies/replay/settled/stage.json";
    nlohmann::json stage = nlohmann::json::parse(read_all(kept));
    stage["stress"][0][1] = stage.at("stress")[0][1].get<double>() + 1e3;
    record::seal_stage(kept.parent_path(), stage); // as a stage that ended with it
    const Said said = say({"compare", "first", "second", "--json"});
    const nlohmann::json differences = said.json().at("differences");
    ASSERT_EQ(differences.size(), 1U) << said.out;
    EXPECT_EQ(differences[0].at("where"), "replay/settled: stress[0][1]");
    EXPECT_NEAR(differences[0].at("relative").get<double>(), 0.01, 1e-4); // of 100 kPa, within the servo's tolerance
}

TEST_F(Compare, RunsThatDifferOnlyInHowTheyWereComputedHaveTheSameResults) {
    std::filesystem::copy(folder / "first", folder / "second", std::filesystem::copy_options::recursive);
    const std::filesystem::path kept = folder / "second/studies/replay/seep/stage.json";
    nlohmann::json stage = nlohmann::json::parse(read_all(kept));
    stage["residual"] = 2 * stage.at("residual").get<double>();
    record::seal_stage(kept.parent_path(), stage); // as a stage that computed it so
    const Said said = say({"compare", "first", "second"});
    EXPECT_EQ(said.code, 5);
    expect_in("the same results, with 1 difference in how they were computed", said.out);
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
    const Said refused = say({"compare", "first", "second"});
    EXPECT_EQ(refused.code, 74);
    expect_in("second/figures/own-throat-flux.csv was changed since the run ended", refused.error);
    std::filesystem::remove(folder / "second/SHA256SUMS"); // as of a report that wrote it so
    const Said said = say({"compare", "first", "second", "-v"});
    EXPECT_EQ(said.code, 5) << said.out;
    expect_in("figure own-throat-flux: ", said.out);
}

TEST_F(Compare, ARunThatLacksAStageDiffersInIt) {
    ASSERT_EQ(run("second", {"--until", "settled"}).code, 0);
    const Said said = say({"compare", "first", "second"});
    EXPECT_EQ(said.code, 5);
    expect_in("replay/seep   done and not there", said.out);
}

TEST_F(Compare, RunsWithoutACommonStageAreSaidToBeSoWithWhatIsInEach) {
    std::string text = read_all(folder / "soil/case.toml");
    for (std::size_t at = 0; (at = text.find("study.replay", at)) != std::string::npos;) {
        text.replace(at, 12, "study.second");
    }
    write_to(folder / "soil/case.toml", text);
    ASSERT_EQ(run("second", {"--until", "settled"}).code, 0);
    const Said said = say({"compare", "first", "second"});
    EXPECT_EQ(said.code, 5);
    expect_in("nothing to compare: no stage, by its study, sample and name, is in both", said.out);
    expect_in("first has replay/compressed, ", said.out);
    expect_in("second has second/settled, second/start", said.out);
    EXPECT_EQ(said.out.find("case - "), std::string::npos);
    EXPECT_EQ(say({"compare", "first", "second", "--json"}).json().at("only_second").size(), 2U);
}

TEST_F(Compare, WithThePaperEachFindingIsJudged) {
    const Said said = say({"compare", "first", "--paper", "--json"});
    EXPECT_EQ(said.code, 0) << said.error; // the replay holds nothing that the paper speaks of
    EXPECT_TRUE(said.json().at("findings").empty());
    nlohmann::json summary = nlohmann::json::parse(read_all(folder / "first/summary.json"));
    std::filesystem::remove(folder / "first/SHA256SUMS"); // as of a report that wrote it so
    const nlohmann::json claim = {{"claim", "c"}, {"paper", "30 %"}, {"ours", "31 %"}};
    summary["findings"] = {claim, claim};
    summary["findings"][0].update({{"id", "M1"}, {"met", true}});
    summary["findings"][1].update({{"id", "M2"}, {"met", nullptr}});
    write_to(folder / "first/summary.json", summary.dump());
    EXPECT_EQ(say({"compare", "first", "--paper"}).code, 0) << "what cannot be told is no difference";
    summary["findings"][1].update(
        {{"met", false},
         {"verdict", "not met by our number"},
         {"our_numbers", {"25 to 35 %"}},
         {"why", "The skeleton was kept."}}
    );
    write_to(folder / "first/summary.json", summary.dump());
    const Said other = say({"compare", "first", "--paper"});
    EXPECT_EQ(other.code, 5);
    expect_in("M1  met", other.out); // of a run that an earlier version reported
    expect_in("M2  not met by our number", other.out);
    expect_in("our number 25 to 35 %", other.out);
    expect_in("why        The skeleton was kept.", other.out);
    summary["findings"][1].update({{"met", nullptr}, {"verdict", "met by noise"}});
    write_to(folder / "first/summary.json", summary.dump());
    EXPECT_EQ(say({"compare", "first", "--paper"}).code, 5) << "agreement by noise is none";
}

TEST_F(Compare, WrongUseSaysWhatToGive) {
    EXPECT_EQ(say({"compare", "first"}).code, 2);
    EXPECT_EQ(say({"compare", "first", "first", "--paper"}).code, 2);
    EXPECT_EQ(say({"compare", "first", "first", "--tolerance", "much"}).code, 2);
    EXPECT_EQ(say({"compare", "first", "first", "--tolerance", "200 %"}).code, 2);
    const Said none = say({"compare", "first", "soil"});
    EXPECT_EQ(none.code, 74);
    expect_in("holds no run", none.error);
}

TEST_F(Compare, AWholeRunIsVerifiedAndSha256sumAgrees) {
    const Said said = say({"verify", "first", "--json"});
    EXPECT_EQ(said.code, 0) << said.out << said.error;
    EXPECT_GT(said.json().at("files"), 10);
    EXPECT_EQ(said.json().at("states"), 4);
    EXPECT_EQ(std::system(("cd '" + (folder / "first").string() + "' && sha256sum --quiet -c SHA256SUMS").c_str()), 0);
    ASSERT_EQ(say({"report", "first"}).code, 0);
    EXPECT_EQ(say({"verify", "first"}).code, 0) << "the report wrote its checksums anew";
}

TEST_F(Compare, WhatWasChangedLostOrAddedIsFound) {
    const std::string stage = "studies/replay/settled/";
    write_to(
        folder / ("first/" + stage + "history.csv"), read_all(folder / ("first/" + stage + "history.csv")) + "1\n"
    );
    ASSERT_TRUE(std::filesystem::remove(folder / "first/figures/own-throat-flux.csv"));
    std::filesystem::remove(folder / "first/summary.json");
    write_to(folder / "first/notes.txt", "mine");
    const Said said = say({"verify", "first", "-v"});
    EXPECT_EQ(said.code, 5);
    expect_in(stage + "history.csv was changed", said.out);
    expect_in("summary.json is missing", said.out);
    expect_in("own-throat-flux.csv is missing", said.out);
    expect_in("notes.txt", said.error);
    EXPECT_EQ(said.out.find("notes.txt"), std::string::npos) << "what came later is no damage";
}

TEST_F(Compare, AStateThatIsNotTheOneToldIsFound) {
    // As if someone had edited a number and then written the checksums of the stage and of the run anew.
    const std::string file = "studies/replay/settled/stage.json";
    nlohmann::json numbers = nlohmann::json::parse(read_all(folder / ("first/" + file)));
    numbers["state_hash"] = "0123456789abcdef";
    record::seal_stage((folder / ("first/" + file)).parent_path(), numbers);
    ASSERT_EQ(say({"report", "first"}).code, 0);
    const Said said = say({"verify", "first"});
    EXPECT_EQ(said.code, 5);
    expect_in(file + " tells the state 0123456789abcdef, and state.h5 holds", said.out);
}

TEST_F(Compare, ARunThatWasInterruptedIsSaidToBeWithWhatIsMissing) {
    std::filesystem::remove(folder / "first/SHA256SUMS");
    const Said ended = say({"verify", "first"});
    EXPECT_EQ(ended.code, 74);
    expect_in("suffuse report first writes them", ended.error);
    std::filesystem::remove(folder / "first/studies/replay/seep/stage.json");
    const Said said = say({"verify", "first"});
    EXPECT_EQ(said.code, 74);
    expect_in("1 of 4 stages are missing: replay/seep; suffuse resume first goes on", said.error);

    ASSERT_EQ(say({"report", "first"}).code, 0);
    expect_in(
        "<b>This run is not complete.</b> 1 of 4 stages are missing: replay/seep.",
        read_all(folder / "first/report.html")
    );
    const Said partial = say({"verify", "first"});
    EXPECT_EQ(partial.code, 5);
    expect_in("unchanged, but not complete", partial.out);
    expect_in("suffuse resume first goes on", partial.out);

    ASSERT_EQ(say({"resume", "first"}).code, 0);
    EXPECT_EQ(read_all(folder / "first/report.html").find("not complete"), std::string::npos);
    EXPECT_EQ(say({"verify", "first"}).code, 0);
    EXPECT_EQ(say({"verify", "soil"}).code, 74);
}

} // namespace
} // namespace suffuse
