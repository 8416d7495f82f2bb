// run, resume and report as a user calls them: where results go, stopping and going on.

#include "tests/support/program.hpp"

namespace suffuse {
namespace {

using namespace test;

/// A case that makes a cloud of so many grains and is done; `top` goes before its tables.
std::string cloud_of(const std::string& particles, const std::string& top = "") {
    return "schema = 1\n" + top + R"([soil.sand]
psd = { d = ["0.2 mm", "0.4 mm"], passing = ["0 %", "100 %"] }
[study.s]
soil      = "sand"
particles = )" +
           particles + R"(
[[study.s.stage]]
name     = "cloud"
do       = "pack"
porosity = 0.6
)";
}

TEST_F(Cli, ARunLeavesItsResultsOnStandardOutputAndItsTalkOnStandardError) {
    run_suffuse({"new", "soil", "--from", "replay"});
    const ProgramResult result = run_suffuse({"soil/case.toml"}); // a file alone is run
    ASSERT_EQ(result.code, 0) << result.error;
    expect_in("runs/soil-0001/report.html", result.out);
    expect_in("plan  1 study, 4 stages", result.error);
    expect_in("4/4 replay/seep", result.error);
    EXPECT_EQ(result.error.find('\x1b'), std::string::npos);
    const ProgramResult quiet = run_suffuse({"run", "soil/case.toml", "-q", "--json"});
    EXPECT_EQ(quiet.error, "");
    EXPECT_EQ(quiet.json().at("folder"), "runs/soil-0002");
    EXPECT_EQ(quiet.json().at("outcome"), "done");
    EXPECT_TRUE(std::filesystem::exists(folder / "runs/soil-0002/summary.json"));
}

using DrawingCli = Drawing<Cli>;

TEST_F(DrawingCli, ChartsOfAReportAreDrawnInAdvanceUnlessTheEnvironmentForbidsIt) {
    run_suffuse({"new", "soil", "--from", "replay"});
    for (const char* stills : {"yes", "no"}) {
        setenv("SUFFUSE_STILLS", stills, 1);
        ASSERT_EQ(run_suffuse({"run", "soil/case.toml", "-o", stills}).code, 0);
        const std::string page = read_all(folder / stills / "report.html");
        const std::size_t chart = page.find("<div class=\"chart\"");
        ASSERT_NE(chart, std::string::npos);
        EXPECT_EQ(page.substr(page.find('>', chart) + 1, 4) == "<svg", stills == std::string("yes"));
    }
}

TEST_F(Cli, ARunGoesOnlyWhereNothingIsOverwritten) {
    run_suffuse({"new", "soil", "--from", "replay"});
    write_to(folder / "mine/notes.txt", "mine");
    EXPECT_EQ(run_suffuse({"run", "soil/case.toml", "-o", "mine"}).code, 2);
    EXPECT_EQ(run_suffuse({"run", "soil/case.toml", "-o", "mine/notes.txt"}).code, 2);
    const ProgramResult first = run_suffuse({"run", "soil/case.toml", "-o", "here", "--until", "start"});
    ASSERT_EQ(first.code, 0) << first.error;
    expect_in("plan  1 study, 1 stage,", first.error); // what is requested
    EXPECT_FALSE(std::filesystem::exists(folder / "here/studies/replay/seep"));
    const nlohmann::json early = nlohmann::json::parse(read_all(folder / "here/summary.json"));
    EXPECT_EQ(early.at("until"), "start");
    EXPECT_EQ(early.at("samples").at("done"), 1);
    const std::string page = read_all(folder / "here/report.html");
    EXPECT_EQ(page.find("id=\"unfinished\""), std::string::npos) << "it was requested to end there";
    expect_in("The run ended with stage start, as requested", page);
    expect_in(
        "the run ended with stage start, as requested; 3 of 4 stages are missing", run_suffuse({"verify", "here"}).out
    );
    EXPECT_EQ(run_suffuse({"run", "soil/case.toml", "-o", "here"}).code, 0); // the same case goes on
    EXPECT_TRUE(nlohmann::json::parse(read_all(folder / "here/summary.json")).at("until").is_null());
    EXPECT_TRUE(std::filesystem::exists(folder / "here/studies/replay/seep/stage.json"));
    const ProgramResult another = run_suffuse({"run", "soil/case.toml", "-o", "here", "--set", "seed=7"});
    EXPECT_EQ(another.code, 3);
    expect_in("holds a run of another case", another.error);
    EXPECT_EQ(another.error.find("plan  "), std::string::npos) << "what is refused is not planned";
    const ProgramResult wrong = run_suffuse({"run", "soil/case.toml", "--until", "sepe"});
    EXPECT_EQ(wrong.code, 2);
    expect_in("seep", wrong.error);
    EXPECT_FALSE(std::filesystem::exists(folder / "runs")); // wrong use leaves nothing behind
}

TEST_F(Cli, AFolderInWhichARunCouldNotEvenBeginIsFree) {
    write_to(folder / "case.toml", cloud_of("200"));
    write_to(folder / "here/.lock", "");
    write_to(folder / "here/run_options.json.partial-123-1", "");
    EXPECT_EQ(run_suffuse({"run", "case.toml", "-o", "here", "-q"}).code, 0);
    EXPECT_TRUE(std::filesystem::exists(folder / "here/summary.json"));
}

TEST_F(Cli, ARunOfAnEarlierVersionWithAMeasureThatIsNoneNowSaysHowToGoOn) {
    run_suffuse({"new", "soil", "--from", "replay"});
    ASSERT_EQ(run_suffuse({"run", "soil/case.toml", "-o", "here", "--until", "start"}).code, 0);
    const std::filesystem::path resolved = folder / "here/case.resolved.toml";
    const std::string now = read_all(resolved), none = "measure = []";
    const std::size_t at = now.find(none);
    ASSERT_NE(at, std::string::npos) << now;
    std::string before = now;
    write_to(resolved, before.replace(at, none.size(), "measure = [\"flow\"]"));
    const ProgramResult refused = run_suffuse({"resume", "here"});
    EXPECT_EQ(refused.code, 3);
    expect_in("E407", refused.error);
    expect_in("remove the word from here/case.resolved.toml and call again", refused.error);
    write_to(resolved, now);
    EXPECT_EQ(run_suffuse({"resume", "here"}).code, 0);
}

TEST_F(Cli, APathThatIsNotUtf8IsAPathLikeAnyOther) {
    const std::string place = "caf\xe9";
    run_suffuse({"new", place, "--from", "replay"});
    const std::vector<std::string> request = {"-o", place + "/run", "--until", "start", "--cache", place + "/c"};
    std::vector<std::string> words = {"run", place + "/case.toml"};
    words.insert(words.end(), request.begin(), request.end());
    const ProgramResult refused = run_suffuse(words); // its packing lies there: a TOML file cannot say so
    EXPECT_EQ(refused.code, 3) << refused.error;
    expect_in("rename the folder", refused.error);
    const std::string text = read_all(folder / (place + "/case.toml"));
    write_to(
        folder / (place + "/case.toml"),
        replaced(text, "packing = \"packing.csv\"", "packing = \"" + examples + "replay/packing.csv\"")
    );
    const ProgramResult result = run_suffuse(words);
    ASSERT_EQ(result.code, 0) << result.error;
    // Begun and stopped before the case was kept: the case file and the cache are found where they are.
    std::filesystem::remove(folder / (place + "/run/case.resolved.toml"));
    std::filesystem::remove(folder / (place + "/run/SHA256SUMS")); // which a run has once it has ended
    const ProgramResult resumed = run_suffuse({"resume", place + "/run", "--trust"});
    EXPECT_EQ(resumed.code, 0) << resumed.error;
    EXPECT_TRUE(std::filesystem::exists(folder / (place + "/c/cache.json")));
    EXPECT_EQ(run_suffuse({"report", place + "/run"}).code, 0);
    EXPECT_EQ(run_suffuse({"verify", place + "/run"}).code, 0);
}

TEST_F(Cli, ATimeLimitThatIsNoneIsRefusedBeforeAnythingIsMade) {
    write_to(folder / "case.toml", cloud_of("200"));
    const std::vector<std::vector<std::string>> verbs = {
        {"run", "case.toml", "-o", "r"}, {"sweep", "case.toml", "--emit", "slurm", "-o", "r"}};
    for (std::vector<std::string> words : verbs) {
        for (const char* const limit : {"1e300 s", "101 years", "-5 min", "0 s", "nan s", "inf s", "1e999 s"}) {
            words.push_back(std::string("--time-limit=") + limit);
            const ProgramResult result = run_suffuse(words);
            EXPECT_EQ(result.code, 2) << words[0] << limit << result.error;
            expect_in("--time-limit", result.error);
            words.pop_back();
        }
    }
    EXPECT_FALSE(std::filesystem::exists(folder / "r"));
}

TEST_F(Cli, AnUnwritableOrUnreadablePlaceIsCode74) {
    run_suffuse({"new", "soil", "--from", "replay"});
    EXPECT_EQ(run_suffuse({"run", "soil/case.toml", "-o", "/proc/nothing"}).code, 74);
    EXPECT_EQ(run_suffuse({"report", "nowhere"}).code, 74);
    EXPECT_EQ(run_suffuse({"report", "soil"}).code, 74);
    EXPECT_FALSE(std::filesystem::exists(folder / "soil/.lock"));                   // no run: nothing of it is touched
    EXPECT_EQ(run_suffuse({"export", "soil/packing.csv", "-o", "x.csv"}).code, 74); // no state of a run
    EXPECT_EQ(run_suffuse({"new", "/proc/nothing", "--from", "replay"}).code, 74);
}

TEST_F(Cli, AFolderWithoutARunIsCode74ForEveryVerbThatReadsOne) {
    std::filesystem::create_directories(folder / "empty");
    write_to(folder / "sand.csv", "d [mm],passing [%]\n0.1,0\n0.2,40\n0.5,100\n");
    for (const std::string run : {"nowhere", "empty"}) {
        for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
                 {"report", run},
                 {"resume", run},
                 {"verify", run},
                 {"figures", run},
                 {"export", run, "-o", "grains.csv"},
                 {"compare", run, run},
                 {"watch", run},
                 {"open", run},
                 {"sweep", "--collect", run},
                 {"sweep", run, "--emit", "parallel"},
                 {"assess", "sand.csv", "--alpha-from", run}}) {
            const ProgramResult refused = run_suffuse(words);
            EXPECT_EQ(refused.code, 74) << words.front() << " " << run << ": " << refused.error;
            expect_in(run, refused.error);
        }
    }
    EXPECT_TRUE(std::filesystem::is_empty(folder / "empty"));
}

TEST_F(Cli, AStoppedRunGoesOnToTheSameBits) {
    run_suffuse({"new", "soil", "--from", "replay"});
    const std::vector<std::string> request = {"run", "soil/case.toml", "--no-cache"};
    std::vector<std::string> whole = request, cut = request;
    whole.insert(whole.end(), {"-o", "whole"});
    cut.insert(cut.end(), {"-o", "cut", "-j", "1"});
    ASSERT_EQ(run_suffuse(whole).code, 0);
    for (const auto& [signal, code] : {std::pair{SIGINT, 130}, std::pair{SIGTERM, 143}}) {
        HeldRun run = start_held("replay/compressed", cut);
        expect_in("plan  ", read_all(folder / "error"));
        expect_in("http-equiv=\"refresh\"", read_all(folder / "cut/report.html"));
        kill(run.child, signal);
        run.let_go();
        const ProgramResult result = wait_for(run.child);
        ASSERT_EQ(result.code, code) << result.error;
        expect_in("<code>suffuse resume cut</code>", read_all(folder / "cut/report.html"));
        EXPECT_EQ(read_all(folder / "cut/report.html").find("http-equiv=\"refresh\""), std::string::npos);
        expect_in("suffuse resume cut", result.out);
        EXPECT_FALSE(std::filesystem::exists(folder / "cut/studies/replay/compressed/stage.json"));
        cut = {"resume", "cut"};
    }
    const ProgramResult late = run_suffuse({"resume", "cut", "--time-limit", "1 ns"});
    EXPECT_EQ(late.code, 75) << late.error;
    ASSERT_EQ(run_suffuse({"resume", "cut"}).code, 0);
    expect_in("provenance-heading", read_all(folder / "cut/report.html")); // the report itself
    EXPECT_EQ(read_all(folder / "cut/report.html").find("http-equiv=\"refresh\""), std::string::npos);
    const auto hash = [&](const std::string& run) {
        return nlohmann::json::parse(read_all(folder / (run + "/studies/replay/compressed/stage.json")))
            .at("state_hash");
    };
    EXPECT_EQ(hash("cut"), hash("whole"));
    const ProgramResult again = run_suffuse({"resume", "cut"});
    expect_in("done before; nothing to do   cut/report.html", again.out);
    EXPECT_EQ(again.error.find("Planned "), std::string::npos) << "how good the plan was is said once";
    const auto progress = nlohmann::json::parse(read_all(folder / "cut/progress.json"));
    EXPECT_EQ(progress.at("latest").at("samples_done"), 1); // and none runs any more
    EXPECT_TRUE(progress.at("running").empty());
}

TEST_F(Cli, ASecondCtrlCQuitsAtOnceWithoutSaving) {
    run_suffuse({"new", "soil", "--from", "replay"});
    const HeldRun run = start_held("replay/compressed", {"run", "soil/case.toml", "-o", "cut", "--no-cache"});
    kill(run.child, SIGINT);
    wait_until("the farewell", [&] {
        return read_all(folder / "error").find("a second Ctrl-C quits at once") != std::string::npos;
    });
    kill(run.child, SIGINT);
    const ProgramResult result = wait_for(run.child); // which nobody lets go
    EXPECT_EQ(result.code, 130);
    EXPECT_EQ(result.out, "");
    EXPECT_FALSE(std::filesystem::exists(folder / "cut/studies/replay/compressed/partial.h5"));
}

TEST_F(Cli, TwoProgramsDoNotWorkInOneFolder) {
    run_suffuse({"new", "soil", "--from", "replay"});
    const HeldRun first = start_held("replay/compressed", {"run", "soil/case.toml", "-o", "here"});
    const ProgramResult second = run_suffuse({"resume", "here"});
    EXPECT_EQ(second.code, 2);
    expect_in("another suffuse", second.error);
    const ProgramResult report = run_suffuse({"report", "here"});
    EXPECT_EQ(report.code, 2);
    expect_in("another suffuse", report.error);
    EXPECT_FALSE(std::filesystem::exists(folder / "here/provenance.json")); // the run itself has yet to write it
}

TEST_F(Cli, ReportIsWrittenAgainWithoutComputing) {
    run_suffuse({"new", "soil", "--from", "replay"});
    ASSERT_EQ(run_suffuse({"run", "soil/case.toml", "-o", "my run"}).code, 0);
    std::filesystem::remove(folder / "my run/report.html");
    const auto command = [&] {
        return nlohmann::json::parse(read_all(folder / "my run/provenance.json")).at("command").get<std::string>();
    };
    ASSERT_EQ(command(), "suffuse run soil/case.toml -o 'my run'");
    const ProgramResult result = run_suffuse({"report", "my run"});
    EXPECT_EQ(result.code, 0) << result.error;
    EXPECT_TRUE(std::filesystem::exists(folder / "my run/report.html"));
    EXPECT_EQ(command(), "suffuse run soil/case.toml -o 'my run'") << "of the run, not of the report";
    std::filesystem::remove(folder / "my run/provenance.json"); // as after a sample alone, or a run that was killed
    EXPECT_EQ(run_suffuse({"report", "my run"}).code, 0);
    EXPECT_EQ(command(), "suffuse report 'my run'");
}

TEST_F(Cli, ASucceededRunStaysOneWhateverItsCaseHasBecomeMeanwhile) {
    write_to(
        folder / "case.toml", cloud_of("0", "paper = \"a paper\"\npreset = \"quick\"\npresets.quick.particles = 200\n")
    );
    const ProgramResult result = run_suffuse({"run", "case.toml", "-o", "here", "--json"});
    EXPECT_EQ(result.code, 0) << result.error;
    EXPECT_EQ(result.json().at("outcome"), "done"); // one document
    expect_in("next: your own soil", result.error);
}

} // namespace
} // namespace suffuse
