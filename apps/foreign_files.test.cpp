// Folders made by somebody else, and the user's own files next to ours: nothing of either is written or removed.

#include "suffuse/io/checkpoint.hpp"
#include "suffuse/record/folder.hpp"
#include "suffuse/record/stage_cache.hpp"
#include "suffuse/record/stage_sums.hpp"

#include "tests/support/program.hpp"
#include <filesystem>
#include <string>
#include <sys/stat.h>
#include <vector>

namespace suffuse {
namespace {

using namespace test;
namespace fs = std::filesystem;

class ForeignFiles : public Cli {
protected:
    void SetUp() override { ASSERT_EQ(run_suffuse({"new", "soil", "--from", "replay"}).code, 0); }

    ProgramResult run(const std::string& name, std::vector<std::string> more = {"--no-cache"}) {
        more.insert(more.begin(), {"run", "soil/case.toml", "-o", name});
        return run_suffuse(more);
    }

    /// As an earlier call was stopped behind its first stage.
    void begin(const std::string& name) { ASSERT_EQ(run(name, {"--no-cache", "--until", "start"}).code, 0); }
};

TEST_F(ForeignFiles, ALinkInARunFolderIsNeverWrittenThrough) {
    for (const char* const file : {"events.jsonl", ".lock", "studies/replay/settled", "report.html"}) {
        begin("here");
        write_to(folder / "home/bashrc", "# mine");
        fs::remove_all(folder / (std::string("here/") + file));
        fs::create_symlink(folder / "home/bashrc", folder / (std::string("here/") + file));
        const ProgramResult result = run_suffuse({"resume", "here", "--no-cache"});
        EXPECT_EQ(result.code, 74) << file << result.error;
        expect_in(std::string("here/") + file + " is a link", result.error);
        EXPECT_EQ(read_all(folder / "home/bashrc"), "# mine");
        fs::remove_all(folder / "here");
    }
}

TEST_F(ForeignFiles, AFileOfARunWithAnotherNameElsewhereIsNotAppendedTo) {
    begin("here");
    write_to(folder / "bashrc", "# mine");
    fs::remove(folder / "here/events.jsonl");
    fs::create_hard_link(folder / "bashrc", folder / "here/events.jsonl");
    const ProgramResult result = run_suffuse({"resume", "here", "--no-cache"});
    EXPECT_EQ(result.code, 74) << result.error;
    expect_in("here/events.jsonl has another name elsewhere", result.error);
    EXPECT_EQ(read_all(folder / "bashrc"), "# mine");
}

TEST_F(ForeignFiles, APipeInARunFolderIsRefusedAtOnceWithItsName) {
    ASSERT_EQ(run("here").code, 0);
    for (const auto& [file, verb] : std::vector<std::pair<std::string, std::string>>{
             {"run_options.json", "resume"},
             {"events.jsonl", "resume"},
             {"studies/replay/settled/partial.h5", "resume"},
             {"summary.json", "report"},
             {"SHA256SUMS", "verify"},
             {"events.jsonl", "watch"},
             {"summary.json", "compare"},
             {"figures/own-x.vl.json", "figures"}}) {
        fs::copy(folder / "here", folder / "x", fs::copy_options::recursive);
        fs::remove(folder / ("x/" + file));
        fs::remove(folder / "x/SHA256SUMS");
        ASSERT_EQ(mkfifo((folder / ("x/" + file)).c_str(), 0600), 0);
        std::vector<std::string> words = {verb, "x"};
        if (verb == "compare") {
            words.emplace_back("here");
        }
        const ProgramResult result = run_suffuse(words);
        EXPECT_EQ(result.code, 74) << verb << result.error;
        expect_in("x/" + file + " is a pipe (FIFO)", result.error);
        fs::remove_all(folder / "x");
    }
}

TEST_F(ForeignFiles, AFolderThatIsNoCacheIsRefusedBeforeAnythingIsMade) {
    write_to(folder / "data/new-2024/a.jpg", "photo");
    write_to(folder / "data/deadbeefdeadbeef/p", "mine");
    write_to(folder / "data/0123456789abcdef", "mine");
    begin("begun");
    for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
             {"run", "soil/case.toml", "-o", "r", "--cache", "data"},
             {"resume", "begun", "--cache", "data"},
             {"sweep", "soil/case.toml", "--emit", "parallel", "-o", "r", "--cache", "data"},
             {"cache", "data"}}) {
        const ProgramResult result = run_suffuse(words);
        EXPECT_EQ(result.code, 2) << words[0] << result.error;
        expect_in("data is not a cache", result.error);
    }
    EXPECT_FALSE(fs::exists(folder / "r"));
    EXPECT_TRUE(fs::exists(folder / "data/new-2024/a.jpg") && fs::exists(folder / "data/deadbeefdeadbeef/p"));
    EXPECT_TRUE(fs::exists(folder / "data/0123456789abcdef"));
    EXPECT_FALSE(fs::exists(folder / "data/cache.json"));
}

TEST_F(ForeignFiles, HalfWrittenFilesOfTheUserAreNotTakenForOurs) {
    write_to(folder / "dl/movie.mkv.partial", "movie");
    write_to(folder / "dl/thesis.partial-2024-11", "draft");
    const ProgramResult result = run("dl");
    EXPECT_EQ(result.code, 2) << result.error;
    expect_in("dl is not empty and holds no run", result.error);
    begin("here");
    fs::copy(folder / "dl", folder / "here");
    write_to(folder / "here/report.html.partial-1-2", "<");
    EXPECT_EQ(run_suffuse({"resume", "here", "--no-cache", "--until", "settled"}).code, 0);
    EXPECT_FALSE(fs::exists(folder / "here/report.html.partial-1-2")) << "that one is ours";
    for (const char* const place : {"dl", "here"}) {
        EXPECT_EQ(read_all(folder / place / "movie.mkv.partial"), "movie");
        EXPECT_EQ(read_all(folder / place / "thesis.partial-2024-11"), "draft");
    }
}

TEST_F(ForeignFiles, APictureOfTheUserAmongTheFiguresStaysAndAnOldFigureGoes) {
    begin("here");
    write_to(folder / "here/figures/own-sketch.png", "mine");
    write_to(folder / "here/figures/fig03.csv", "x");
    write_to(folder / "here/figures/fig03.pdf", "x");
    ASSERT_EQ(run_suffuse({"report", "here"}).code, 0);
    EXPECT_EQ(read_all(folder / "here/figures/own-sketch.png"), "mine");
    EXPECT_FALSE(fs::exists(folder / "here/figures/fig03.csv") || fs::exists(folder / "here/figures/fig03.pdf"));
}

TEST_F(ForeignFiles, TheFolderOfARunChoosesNoCacheUnlessItIsTrusted) {
    begin("here");
    nlohmann::json request = record::read_json(folder / "here/run_options.json");
    request["cache"] = (folder / "else where").string();
    fs::remove(folder / "here/SHA256SUMS");
    write_to(folder / "here/run_options.json", request.dump());
    const ProgramResult result = run_suffuse({"resume", "here", "--until", "settled"});
    EXPECT_EQ(result.code, 0) << result.error;
    expect_in("--cache '" + (folder / "else where").string() + "'", result.error);
    EXPECT_FALSE(fs::exists(folder / "else where"));
    EXPECT_TRUE(fs::exists(folder / "suffuse-cache/cache.json"));
    const ProgramResult trusted = run_suffuse({"resume", "here", "--trust"});
    EXPECT_EQ(trusted.code, 0) << trusted.error;
    EXPECT_TRUE(fs::exists(folder / "else where/cache.json"));
}

TEST_F(ForeignFiles, WithoutAPlaceForTemporaryFilesARunStillHasItsReport) {
    const char* const before = std::getenv("TMPDIR");
    const std::string usual = before == nullptr ? "/tmp" : before;
    setenv("TMPDIR", "/nowhere", 1);
    const ProgramResult result = run("here");
    setenv("TMPDIR", usual.c_str(), 1);
    EXPECT_EQ(result.code, 0) << result.error;
    EXPECT_TRUE(fs::exists(folder / "here/summary.json"));
    expect_in("<title>", read_all(folder / "here/report.html"));
    EXPECT_EQ(run_suffuse({"verify", "here"}).code, 0) << "nothing temporary is left";
}

TEST_F(ForeignFiles, AFileThatTheCaseOfARunNamesAndThatIsGoneIsSoughtInTheUsersOwnCase) {
    begin("here");
    fs::rename(folder / "soil", folder / "moved");
    const ProgramResult result = run_suffuse({"resume", "here", "--no-cache"});
    EXPECT_EQ(result.code, 3) << result.error;
    expect_in("the run began with " + (folder / "soil/case.toml").string(), result.error);
}

// ---- parts of another run, or of another case, among those of a run

constexpr const char* eroded_case = R"(schema = 1
seed = 5
[balance]
unbalanced_force = 1e-2
patience         = 50
[soil.sand]
coarse = { psd = { d = ["0.28 mm", "0.32 mm"], passing = ["0 %", "100 %"] } }
fines  = { psd = { d = ["0.14 mm", "0.16 mm"], passing = ["0 %", "100 %"] } }
fines_content = "18 %"
grading_tolerance = "30 %"
[study.e]
soil = "sand"
particles = 150
[[study.e.stage]]
name = "cloud"
do   = "pack"
[[study.e.stage]]
name     = "initial"
do       = "compact"
pressure = "100 kPa"
protocol = "swift"
[[study.e.stage]]
name     = "er"
do       = "erode"
gradient = 0.5
passes   = 2
ramp     = 60
watch    = 60
[output]
formats = ["csv"]
)";

/// Whole runs "a" and "b" of two cases that differ in one value; of the second, so many stages.
class Swapped : public Cli {
protected:
    ProgramResult run(const std::string& name, std::vector<std::string> more = {}) {
        write_to(folder / "case.toml", eroded_case);
        more.insert(more.begin(), {"run", "case.toml", "-o", name, "--no-cache"});
        return run_suffuse(more);
    }

    void take(const std::string& file) {
        fs::remove_all(folder / "a/studies" / file);
        fs::copy(folder / "b/studies" / file, folder / "a/studies" / file, fs::copy_options::recursive);
    }

    /// What every verb that works in a run says of "a", and that none of them signs it.
    void expect_refused(const std::string& words) {
        for (const char* const verb : {"resume", "report"}) {
            const ProgramResult result = run_suffuse({verb, "a"});
            EXPECT_EQ(result.code, 74) << verb << result.error;
            expect_in(words, result.error);
        }
        EXPECT_NE(run_suffuse({"verify", "a"}).code, 0);
    }
};

TEST_F(Swapped, AStageOfAnotherCaseOrSeedIsRefusedByEveryVerbThoughItIsWhole) {
    for (const char* const change : {"study.e.stage.er.gradient=0.2", "seed=77"}) {
        ASSERT_EQ(run("a").code, 0);
        ASSERT_EQ(run("b", {"--set", change}).code, 0);
        take("e/er");
        fs::remove(folder / "a/SHA256SUMS"); // of the run: those of its stages are whole
        expect_refused("e/er/stage.json is of another case");
        fs::remove_all(folder / "a/studies/e/er"); // as the message advises
        EXPECT_EQ(run_suffuse({"resume", "a", "--no-cache"}).code, 0) << change;
        EXPECT_EQ(run_suffuse({"verify", "a"}).code, 0) << change;
        fs::remove_all(folder / "a");
        fs::remove_all(folder / "b");
    }
}

TEST_F(Swapped, ACaseThatWasChangedInAStoppedRunIsNoticedAndTheUsersOwnIsNamed) {
    ASSERT_EQ(run("a", {"--until", "initial"}).code, 0);
    fs::remove(folder / "a/SHA256SUMS");
    std::string resolved = read_all(folder / "a/case.resolved.toml");
    const std::size_t digit = resolved.find("modulus");
    resolved[resolved.find('3', digit)] = '1';
    write_to(folder / "a/case.resolved.toml", resolved);
    const ProgramResult result = run_suffuse({"resume", "a", "--no-cache"});
    EXPECT_EQ(result.code, 74) << result.error;
    expect_in("a/case.resolved.toml was changed since the run began with", result.error);
    fs::remove(folder / "a/events.jsonl"); // as of a version that did not note it there
    const ProgramResult older = run_suffuse({"resume", "a", "--no-cache"});
    EXPECT_EQ(older.code, 74) << older.error;
    expect_in("a/case.resolved.toml was changed, restore it (the run began with", older.error);
}

TEST_F(Swapped, AHalfDoneStageOfAnotherSeedIsRefused) {
    ASSERT_EQ(run("a", {"--until", "cloud"}).code, 0);
    ASSERT_EQ(run("b", {"--set", "seed=77"}).code, 0);
    fs::create_directories(folder / "a/studies/e/initial");
    dem::World half = io::load_world(folder / "b/studies/e/cloud/state.h5").world;
    const std::string key = record::read_json(folder / "b/studies/e/initial/stage.json").at("key");
    const nlohmann::json saved{{"key", key}, {"world", record::describe_state(half)}};
    io::save_world(folder / "a/studies/e/initial/partial.h5", half, {}, {}, nlohmann::json::to_cbor(saved));
    const ProgramResult result = run_suffuse({"resume", "a", "--no-cache"});
    EXPECT_EQ(result.code, 74) << result.error;
    expect_in("initial/partial.h5: is of another case, sample, stage or seed", result.error);
}

TEST_F(Swapped, AStageThatTheCaseDoesNotHaveIsNotSigned) {
    ASSERT_EQ(run("a").code, 0);
    fs::copy(folder / "a/studies/e/er", folder / "a/studies/e/er2", fs::copy_options::recursive);
    nlohmann::json numbers = record::read_json(folder / "a/studies/e/er2/stage.json");
    numbers["stage"] = "er2";
    fs::remove(folder / "a/studies/e/er2/SHA256SUMS");
    record::seal_stage(folder / "a/studies/e/er2", numbers);
    fs::remove(folder / "a/SHA256SUMS");
    expect_refused("er2/stage.json is of a stage that case.resolved.toml does not have");
}

TEST_F(Swapped, AStateOfAPassThatTheStageDidNotLeaveGetsNoChecksum) {
    ASSERT_EQ(run("b").code, 0);
    ASSERT_EQ(run("a", {"--until", "initial"}).code, 0);
    const fs::path stage = folder / "a/studies/e/er";
    fs::create_directories(stage);
    fs::copy(folder / "b/studies/e/initial/state.h5", stage / "pass-9.h5");
    write_to(stage / "transport.csv", "pass,id\n1,2\n");
    const ProgramResult result = run_suffuse({"resume", "a", "--no-cache"});
    EXPECT_NE(result.code, 74) << result.error;
    expect_in(
        "pass-9.h5, transport.csv lay in its folder before and are not of this stage",
        record::read_json(stage / "stage.json").at("warnings").dump()
    );
    for (const char* const sums : {"studies/e/er/SHA256SUMS", "SHA256SUMS"}) {
        const std::string signed_files = read_all(folder / "a" / sums);
        EXPECT_EQ(signed_files.find("pass-9.h5"), std::string::npos) << sums;
        EXPECT_EQ(signed_files.find("transport.csv"), std::string::npos) << sums;
        EXPECT_NE(signed_files.find("eroded.csv"), std::string::npos) << sums;
    }
}

TEST_F(Swapped, AReportThatFailsLeavesTheChecksumsOfTheRun) {
    ASSERT_EQ(run("a").code, 0);
    const std::string before = read_all(folder / "a/SHA256SUMS");
    fs::remove(folder / "a/summary.json");
    fs::create_directories(folder / "a/summary.json/in-the-way");
    EXPECT_EQ(run_suffuse({"report", "a"}).code, 74);
    EXPECT_EQ(read_all(folder / "a/SHA256SUMS"), before);
}

TEST_F(Swapped, ARunOfBeforeThereWereKeysOpensAsUnverified) {
    ASSERT_EQ(run("a").code, 0);
    for (const char* const stage : {"cloud", "initial", "er"}) {
        const fs::path place = folder / "a/studies/e" / stage;
        nlohmann::json numbers = record::read_json(place / "stage.json");
        numbers.erase("key");
        record::seal_stage(place, numbers);
    }
    fs::remove(folder / "a/SHA256SUMS");
    const ProgramResult result = run_suffuse({"report", "a"});
    EXPECT_EQ(result.code, 0) << result.error;
    expect_in("unverified: an earlier version left no key of e/cloud, e/er, e/initial", result.error);
    expect_in("unverified: 3 of 3 stages", run_suffuse({"verify", "a"}).out);
    EXPECT_EQ(run_suffuse({"resume", "a", "--no-cache"}).code, 0);
}

} // namespace
} // namespace suffuse
