// Folders made by somebody else, and the user's own files beside ours: nothing of either is written or removed.

#include "suffuse/record/folder.hpp"

#include "tests/support/program.hpp"
#include <filesystem>
#include <string>
#include <sys/stat.h>
#include <vector>

namespace suffuse {
namespace {

using namespace test;
namespace fs = std::filesystem;

class Strangers : public Cli {
protected:
    void SetUp() override { ASSERT_EQ(say({"new", "soil", "--from", "replay"}).code, 0); }

    Said run(const std::string& name, std::vector<std::string> more = {"--no-cache"}) {
        more.insert(more.begin(), {"run", "soil/case.toml", "-o", name});
        return say(more);
    }

    /// As an earlier call was stopped behind its first stage.
    void begin(const std::string& name) { ASSERT_EQ(run(name, {"--no-cache", "--until", "start"}).code, 0); }
};

TEST_F(Strangers, ALinkInARunFolderIsNeverWrittenThrough) {
    for (const char* const file : {"events.jsonl", ".lock", "studies/replay/settled", "report.html"}) {
        begin("here");
        write_to(folder / "home/bashrc", "# mine");
        fs::remove_all(folder / (std::string("here/") + file));
        fs::create_symlink(folder / "home/bashrc", folder / (std::string("here/") + file));
        const Said said = say({"resume", "here", "--no-cache"});
        EXPECT_EQ(said.code, 74) << file << said.error;
        expect_in(std::string("here/") + file + " is a link", said.error);
        EXPECT_EQ(read_all(folder / "home/bashrc"), "# mine");
        fs::remove_all(folder / "here");
    }
}

TEST_F(Strangers, AFileOfARunWithAnotherNameElsewhereIsNotAppendedTo) {
    begin("here");
    write_to(folder / "bashrc", "# mine");
    fs::remove(folder / "here/events.jsonl");
    fs::create_hard_link(folder / "bashrc", folder / "here/events.jsonl");
    const Said said = say({"resume", "here", "--no-cache"});
    EXPECT_EQ(said.code, 74) << said.error;
    expect_in("here/events.jsonl has another name elsewhere", said.error);
    EXPECT_EQ(read_all(folder / "bashrc"), "# mine");
}

TEST_F(Strangers, APipeInARunFolderIsRefusedAtOnceWithItsName) {
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
        const Said said = say(words);
        EXPECT_EQ(said.code, 74) << verb << said.error;
        expect_in("x/" + file + " is a pipe (FIFO)", said.error);
        fs::remove_all(folder / "x");
    }
}

TEST_F(Strangers, AFolderThatIsNoCacheIsRefusedBeforeAnythingIsMade) {
    write_to(folder / "data/new-2024/a.jpg", "photo");
    write_to(folder / "data/deadbeefdeadbeef/p", "mine");
    write_to(folder / "data/0123456789abcdef", "mine");
    begin("begun");
    for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
             {"run", "soil/case.toml", "-o", "r", "--cache", "data"},
             {"resume", "begun", "--cache", "data"},
             {"sweep", "soil/case.toml", "--emit", "parallel", "-o", "r", "--cache", "data"},
             {"cache", "data"}}) {
        const Said said = say(words);
        EXPECT_EQ(said.code, 2) << words[0] << said.error;
        expect_in("data is no cache", said.error);
    }
    EXPECT_FALSE(fs::exists(folder / "r"));
    EXPECT_TRUE(fs::exists(folder / "data/new-2024/a.jpg") && fs::exists(folder / "data/deadbeefdeadbeef/p"));
    EXPECT_TRUE(fs::exists(folder / "data/0123456789abcdef"));
    EXPECT_FALSE(fs::exists(folder / "data/cache.json"));
}

TEST_F(Strangers, HalfWrittenFilesOfTheUserAreNotTakenForOurs) {
    write_to(folder / "dl/movie.mkv.partial", "movie");
    write_to(folder / "dl/thesis.partial-2024-11", "draft");
    const Said said = run("dl");
    EXPECT_EQ(said.code, 2) << said.error;
    expect_in("dl is not empty and holds no run", said.error);
    begin("here");
    fs::copy(folder / "dl", folder / "here");
    write_to(folder / "here/report.html.partial-1-2", "<");
    EXPECT_EQ(say({"resume", "here", "--no-cache", "--until", "settled"}).code, 0);
    EXPECT_FALSE(fs::exists(folder / "here/report.html.partial-1-2")) << "that one is ours";
    for (const char* const place : {"dl", "here"}) {
        EXPECT_EQ(read_all(folder / place / "movie.mkv.partial"), "movie");
        EXPECT_EQ(read_all(folder / place / "thesis.partial-2024-11"), "draft");
    }
}

TEST_F(Strangers, APictureOfTheUserAmongTheFiguresStaysAndAnOldFigureGoes) {
    begin("here");
    write_to(folder / "here/figures/own-sketch.png", "mine");
    write_to(folder / "here/figures/fig03.csv", "x");
    write_to(folder / "here/figures/fig03.pdf", "x");
    ASSERT_EQ(say({"report", "here"}).code, 0);
    EXPECT_EQ(read_all(folder / "here/figures/own-sketch.png"), "mine");
    EXPECT_FALSE(fs::exists(folder / "here/figures/fig03.csv") || fs::exists(folder / "here/figures/fig03.pdf"));
}

TEST_F(Strangers, TheFolderOfARunChoosesNoCacheUnlessItIsTrusted) {
    begin("here");
    nlohmann::json asked = record::read_json(folder / "here/run_options.json");
    asked["cache"] = (folder / "else where").string();
    fs::remove(folder / "here/SHA256SUMS");
    write_to(folder / "here/run_options.json", asked.dump());
    const Said said = say({"resume", "here", "--until", "settled"});
    EXPECT_EQ(said.code, 0) << said.error;
    expect_in("--cache '" + (folder / "else where").string() + "'", said.error);
    EXPECT_FALSE(fs::exists(folder / "else where"));
    EXPECT_TRUE(fs::exists(folder / "suffuse-cache/cache.json"));
    const Said trusted = say({"resume", "here", "--trust"});
    EXPECT_EQ(trusted.code, 0) << trusted.error;
    EXPECT_TRUE(fs::exists(folder / "else where/cache.json"));
}

TEST_F(Strangers, WithoutAPlaceForTemporaryFilesARunStillHasItsReport) {
    const char* const before = std::getenv("TMPDIR");
    const std::string usual = before == nullptr ? "/tmp" : before;
    setenv("TMPDIR", "/nowhere", 1);
    const Said said = run("here");
    setenv("TMPDIR", usual.c_str(), 1);
    EXPECT_EQ(said.code, 0) << said.error;
    EXPECT_TRUE(fs::exists(folder / "here/summary.json"));
    expect_in("<title>", read_all(folder / "here/report.html"));
    EXPECT_EQ(say({"verify", "here"}).code, 0) << "nothing temporary is left";
}

} // namespace
} // namespace suffuse
