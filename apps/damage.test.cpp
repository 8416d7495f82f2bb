// Damaged files of runs as a user meets them: nothing is used, reported or signed, and the message says how to go on.

#include "suffuse/record/folder.hpp"
#include "suffuse/record/stage_sums.hpp"
#include "suffuse/record/sums.hpp"

#include "tests/support/program.hpp"
#include <algorithm>
#include <fstream>
#include <map>
#include <random>
#include <regex>

namespace suffuse {
namespace {

using namespace test;
namespace fs = std::filesystem;

class Damaged : public Cli {
protected:
    void SetUp() override {
        ASSERT_EQ(run_suffuse({"new", "soil", "--from", "replay"}).code, 0);
        ASSERT_EQ(run("here").code, 0);
    }

    ProgramResult run(const std::string& name, std::vector<std::string> more = {"--no-cache"}) {
        more.insert(more.begin(), {"run", "soil/case.toml", "-o", name});
        return run_suffuse(more);
    }

    [[nodiscard]] fs::path stage(const std::string& name, const std::string& of = "here") const {
        return folder / (of + "/studies/replay/" + name);
    }

    /// Another digit in the place of the last one.
    static void change_digit(const fs::path& file) {
        std::string text = read_all(file);
        const std::size_t at = text.find_last_of("0123456789");
        ASSERT_NE(at, std::string::npos) << file;
        text[at] = text[at] == '7' ? '3' : '7';
        write_to(file, text);
    }

    static void flip_bit(const fs::path& file, std::size_t at) {
        std::string bytes = read_all(file);
        bytes[at % bytes.size()] = static_cast<char>(bytes[at % bytes.size()] ^ 4);
        write_to(file, bytes);
    }

    /// Every file of a run by its name, but for the lock.
    [[nodiscard]] std::map<std::string, std::string> files_of(const std::string& name) const {
        std::map<std::string, std::string> files;
        for (const auto& entry : fs::recursive_directory_iterator(folder / name)) {
            if (entry.is_regular_file() && entry.path().filename() != ".lock") {
                files[fs::relative(entry.path(), folder / name)] = read_all(entry.path());
            }
        }
        return files;
    }

    [[nodiscard]] std::string hash_of(const std::string& name, const std::string& of = "here") const {
        return record::read_json(stage(name, of) / "stage.json").at("state_hash");
    }

    /// As a version before checksums of stages left it.
    void forget_checksums(const std::string& name) {
        for (const char* const each : {"start", "settled", "compressed", "seep"}) {
            fs::remove(stage(each, name) / "SHA256SUMS");
            nlohmann::json numbers = record::read_json(stage(each, name) / "stage.json");
            for (const char* const key : {"checksums", "sample", "start_state", "key", "commit"}) {
                numbers.erase(key);
            }
            record::write_json(stage(each, name) / "stage.json", numbers);
        }
        fs::remove(folder / (name + "/SHA256SUMS"));
    }
};

TEST_F(Damaged, AFinishedStageIsRefusedByEveryVerbAndSignedByNone) {
    for (const char* const file : {"stage.json", "history.csv", "state.h5", "SHA256SUMS"}) {
        fs::copy(folder / "here", folder / "damaged", fs::copy_options::recursive);
        const fs::path damaged = stage("settled", "damaged") / file;
        if (damaged.extension() == ".h5") {
            flip_bit(damaged, fs::file_size(damaged) / 2);
        } else {
            change_digit(damaged);
        }
        const auto before = files_of("damaged");
        for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
                 {"resume", "damaged"}, {"report", "damaged"}, {"sweep", "--collect", "damaged"}}) {
            const ProgramResult result = run_suffuse(words);
            EXPECT_EQ(result.code, 74) << words[0] << " " << file << result.out;
            expect_in("damaged/studies/replay/settled/", result.error);
            expect_in("remove damaged/studies/replay/settled and resume", result.error);
        }
        EXPECT_EQ(run("damaged").code, 74);
        EXPECT_EQ(run_suffuse({"verify", "damaged"}).code, 5) << file;
        EXPECT_EQ(files_of("damaged"), before) << "nothing is written over it";
        fs::remove_all(folder / "damaged");
    }
}

// Who changes a file can write checksums that fit it.
TEST_F(Damaged, AFileOfAnotherShapeIsRefusedByNameThoughItsChecksumsFit) {
    const std::vector<std::string> shapes = {
        "5", R"({"end_state": 1, "start_state": [], "stage": {}, "warnings": 7, "flaws": "x", "calls": 3})",
        std::string(100'000, '[') + std::string(100'000, ']')};
    for (const std::string file :
         {"studies/replay/settled/stage.json", "studies/replay/start/stage.json", "summary.json", "provenance.json",
          "run_options.json", "own_rules.json"}) {
        for (const std::string& shape : shapes) {
            fs::copy(folder / "here", folder / "other", fs::copy_options::recursive);
            write_to(folder / "other" / file, shape);
            const auto sign = [&](const fs::path& sums_file, const std::string& name) {
                if (fs::exists(sums_file)) {
                    record::Sums sums = record::read_sums(sums_file);
                    sums[name] = record::checksum_of_text(shape);
                    write_to(sums_file, record::sums_text(sums));
                }
            };
            if (file.starts_with("studies")) {
                sign((folder / "other" / file).parent_path() / "SHA256SUMS", "stage.json");
            }
            sign(folder / "other/SHA256SUMS", file);
            for (const char* const verb : {"verify", "resume", "report"}) {
                const ProgramResult result = run_suffuse({verb, "other"});
                EXPECT_NE(result.code, 70) << verb << " " << file << " " << shape.substr(0, 40) << result.error;
                if (result.code == 74) {
                    expect_in(fs::path(file).filename(), result.error);
                }
            }
            fs::remove_all(folder / "other");
        }
    }
}

TEST_F(Damaged, VerbsThatReadOneFileRefuseItWhereItIsDamaged) {
    flip_bit(stage("settled") / "state.h5", 5000);
    const ProgramResult state = run_suffuse({"export", "here/studies/replay/settled", "-o", "grains.csv"});
    EXPECT_EQ(state.code, 74);
    expect_in("state.h5 was changed since its stage ended", state.error);
    EXPECT_FALSE(fs::exists(folder / "grains.csv"));
    EXPECT_EQ(run_suffuse({"export", "here/studies/replay/seep", "-o", "grains.csv"}).code, 0)
        << "another one is whole";
    change_digit(stage("seep") / "stage.json");
    const ProgramResult numbers = run_suffuse({"compare", "here", "here"});
    EXPECT_EQ(numbers.code, 74);
    expect_in("seep/stage.json was changed since its stage ended", numbers.error);
    change_digit(folder / "here/summary.json");
    const ProgramResult paper = run_suffuse({"compare", "here", "--paper"});
    EXPECT_EQ(paper.code, 74);
    expect_in("suffuse report here writes it anew", paper.error);
}

TEST_F(Damaged, AFigureThatWasChangedIsNotDrawnUntilTheReportIsWrittenAnew) {
    const fs::path figure = folder / "here/figures/own-throat-flux.vl.json";
    change_digit(figure);
    const ProgramResult result = run_suffuse({"figures", "here", "--figure", "own-throat-flux"});
    EXPECT_EQ(result.code, 74);
    expect_in(
        "own-throat-flux.vl.json was changed since the run ended; suffuse report here writes it anew", result.error
    );
    ASSERT_EQ(run_suffuse({"report", "here"}).code, 0);
    EXPECT_EQ(run_suffuse({"verify", "here"}).code, 0);
}

TEST_F(Damaged, WhatTheMessageAdvisesGivesTheSameBits) {
    const std::string settled = hash_of("settled"), seep = hash_of("seep");
    change_digit(stage("settled") / "stage.json");
    ASSERT_EQ(run_suffuse({"resume", "here"}).code, 74);
    fs::remove_all(stage("settled")); // others were computed from it
    ASSERT_EQ(run_suffuse({"resume", "here", "--no-cache"}).code, 0);
    EXPECT_EQ(hash_of("settled"), settled);
    EXPECT_EQ(hash_of("seep"), seep);
    EXPECT_EQ(run_suffuse({"verify", "here"}).code, 0);
}

TEST_F(Damaged, AStageThatWasComputedFromAnotherStateIsRefused) {
    // As if another version of the program had computed the stage before it anew.
    nlohmann::json numbers = record::read_json(stage("compressed") / "stage.json");
    ASSERT_EQ(numbers.at("start_state"), record::read_json(stage("settled") / "stage.json").at("end_state"));
    numbers["start_state"] = "0123456789abcdef";
    numbers.erase("key"); // which has the start state in it: as an earlier version left the stage
    record::seal_stage(stage("compressed"), numbers);
    fs::remove(folder / "here/SHA256SUMS");
    for (const char* const verb : {"resume", "report"}) {
        const ProgramResult result = run_suffuse({verb, "here"});
        EXPECT_EQ(result.code, 74) << verb;
        expect_in(
            "compressed: was computed from the state 0123456789abcdef, and replay/settled now ends", result.error
        );
    }
    EXPECT_FALSE(fs::exists(folder / "here/SHA256SUMS"));
}

TEST_F(Damaged, ACacheEntryIsMadeAnewWithARemark) {
    ASSERT_EQ(run("first", {"--cache", "cache"}).code, 0);
    std::mt19937 chance(7);
    for (const char* const file : {"stage.json", "state.h5", "entry.json", "history.csv", "SHA256SUMS"}) {
        fs::path damaged;
        for (const auto& entry : fs::directory_iterator(folder / "cache")) {
            const std::string made_as =
                entry.is_directory() ? record::read_json(entry.path() / "entry.json").value("made_as", "") : "";
            damaged = made_as == "replay/settled" ? entry.path() / file : damaged;
        }
        ASSERT_TRUE(fs::exists(damaged)) << file;
        flip_bit(damaged, chance());
        const ProgramResult result = run("again", {"--cache", "cache"});
        ASSERT_EQ(result.code, 0) << file << result.error;
        expect_in("warning: replay/settled: its entry in the cache is damaged and was dropped", result.error);
        expect_in("damaged cache entry dropped", read_all(folder / "again/events.jsonl"));
        EXPECT_EQ(hash_of("settled", "again"), hash_of("settled"));
        EXPECT_EQ(run_suffuse({"verify", "again"}).code, 0);
        EXPECT_EQ(run_suffuse({"compare", "here", "again"}).code, 0);
        fs::remove_all(folder / "again");
    }
    const ProgramResult whole = run("again", {"--cache", "cache"});
    EXPECT_EQ(whole.error.find("damaged"), std::string::npos) << "it was kept anew";
    expect_in("from the cache", whole.error);
}

TEST_F(Damaged, ACacheThatCannotBeWrittenIsReportedAndCostsNoResult) {
    write_to(folder / "file", "no folder");
    const ProgramResult result = run("other", {"--cache", "file"});
    EXPECT_EQ(result.code, 0) << result.error;
    expect_in("warning: stages are not stored in the cache, so another run will compute them again: ", result.error);
    EXPECT_EQ(result.error.find("not stored", result.error.find("not stored") + 1), std::string::npos)
        << "once for all stages";
    EXPECT_EQ(hash_of("settled", "other"), hash_of("settled"));
    EXPECT_EQ(run_suffuse({"verify", "other"}).code, 0);
}

TEST_F(Damaged, AFolderThatIsNoCacheIsLeftAlone) {
    write_to(folder / "papers/thesis.tex", "mine");
    for (const std::vector<std::string>& words :
         std::vector<std::vector<std::string>>{{"cache", "papers", "--limit", "1"}, {"cache", "papers", "--clear"}}) {
        const ProgramResult result = run_suffuse(words);
        EXPECT_EQ(result.code, 2);
        expect_in("papers is not a cache", result.error);
    }
    EXPECT_FALSE(fs::exists(folder / "papers/cache.json"));
}

TEST_F(Damaged, ARunThatNeedsNothingIsLeftAlone) {
    const auto before = files_of("here");
    for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
             {"resume", "here"}, {"run", "soil/case.toml", "-o", "here"}, {"resume", "here", "--until", "settled"}}) {
        const ProgramResult result = run_suffuse(words);
        EXPECT_EQ(result.code, 0) << result.error;
        expect_in("done before; nothing to do   here/report.html", result.out);
        EXPECT_EQ(files_of("here"), before) << words[0];
    }
    EXPECT_EQ(run_suffuse({"resume", "here", "--json"}).json().at("outcome"), "done");
    fs::remove(folder / "here/report.html");
    expect_in("done before; written again   here/report.html", run_suffuse({"resume", "here"}).out);
    EXPECT_TRUE(fs::exists(folder / "here/report.html"));
    EXPECT_EQ(run_suffuse({"verify", "here"}).code, 0);
}

TEST_F(Damaged, WhatAKilledProgramLeftOfAnEndedRunGoesWithTheNextCall) {
    const auto before = files_of("here");
    std::ofstream(folder / "here/plan.json.partial-12-3") << "{";
    EXPECT_EQ(run_suffuse({"resume", "here"}).code, 0);
    EXPECT_EQ(files_of("here"), before);
}

TEST_F(Damaged, EveryCallOfARunStandsInItsProvenance) {
    ASSERT_EQ(run("cut", {"--no-cache", "--until", "settled"}).code, 0);
    const double first = record::read_json(folder / "cut/provenance.json").at("wall_seconds");
    ASSERT_EQ(run_suffuse({"resume", "cut", "--no-cache"}).code, 0);
    ASSERT_EQ(run_suffuse({"resume", "cut"}).code, 0); // which needs nothing
    const nlohmann::json provenance = record::read_json(folder / "cut/provenance.json");
    const nlohmann::json& calls = provenance.at("calls");
    ASSERT_EQ(calls.size(), 2U);
    EXPECT_EQ(calls[0].at("wall_seconds").get<double>(), first);
    EXPECT_EQ(calls[1].at("command"), "suffuse resume cut --no-cache");
    EXPECT_EQ(provenance.at("command"), calls[0].at("command"));
    EXPECT_DOUBLE_EQ(provenance.at("wall_seconds"), first + calls[1].at("wall_seconds").get<double>());
}

TEST_F(Damaged, ARunOfAnEarlierVersionContinuesAndWarnsThatItsIntegrityIsUnknown) {
    forget_checksums("here");
    fs::remove_all(stage("seep"));
    const ProgramResult result = run_suffuse({"resume", "here", "--no-cache"});
    EXPECT_EQ(result.code, 0) << result.error;
    expect_in("warning: an earlier version left no checksums of replay/compressed, replay/settled, ", result.error);
    const std::string sums = read_all(folder / "here/SHA256SUMS");
    expect_in("studies/replay/seep/state.h5", sums);
    EXPECT_EQ(sums.find("studies/replay/settled/"), std::string::npos) << "what was not checked is not signed";
    const ProgramResult verified = run_suffuse({"verify", "here"});
    EXPECT_EQ(verified.code, 0) << verified.out;
    expect_in("3 of 4 stages, of an earlier version, have no checksums from their end", verified.out);
}

TEST_F(Damaged, ARunOfAnEarlierVersionThatEndedIsCheckedAgainstItsOwnChecksums) {
    forget_checksums("here");
    std::string sums; // as that version signed it
    for (const auto& [name, text] : files_of("here")) {
        if (name != "events.jsonl" && name != "plan.json" && name != "progress.json") {
            sums += record::checksum_of_text(text) + "  " + name + "\n";
        }
    }
    write_to(folder / "here/SHA256SUMS", sums);
    ASSERT_EQ(run_suffuse({"report", "here"}).code, 0);
    expect_in("studies/replay/settled/state.h5", read_all(folder / "here/SHA256SUMS"));
    EXPECT_EQ(run_suffuse({"verify", "here"}).code, 0);
    change_digit(stage("settled") / "stage.json");
    EXPECT_EQ(run_suffuse({"report", "here"}).code, 74);
    EXPECT_EQ(run_suffuse({"resume", "here"}).code, 74);
    EXPECT_EQ(run_suffuse({"verify", "here"}).code, 5);
}

TEST_F(Damaged, WhatSaysWhatToComputeIsCheckedToo) {
    const fs::path resolved = folder / "here/case.resolved.toml";
    const std::string text = read_all(resolved), other = replaced(text, "\"100 kPa\"", "\"900 kPa\"");
    write_to(resolved, other);
    const ProgramResult result = run_suffuse({"resume", "here"});
    EXPECT_EQ(result.code, 74);
    expect_in("here/case.resolved.toml was changed since the run ended", result.error);
    EXPECT_EQ(run_suffuse({"report", "here"}).code, 74);
    write_to(resolved, text);
    EXPECT_EQ(run_suffuse({"resume", "here"}).code, 0);
}

TEST_F(Damaged, FiguresThatAReportHasNotAnyMoreGoAndThoseOfTheUserStayUnsigned) {
    for (const char* const name : {"own-paths.csv", "own-paths.vl.json", "own-paths.pdf", "mine.csv"}) {
        write_to(folder / ("here/figures/" + std::string(name)), "x\n1\n");
    }
    ASSERT_EQ(run_suffuse({"report", "here"}).code, 0);
    for (const char* const name : {"own-paths.csv", "own-paths.vl.json", "own-paths.pdf"}) {
        EXPECT_FALSE(fs::exists(folder / ("here/figures/" + std::string(name)))) << name;
    }
    EXPECT_TRUE(fs::exists(folder / "here/figures/mine.csv"));
    EXPECT_EQ(read_all(folder / "here/SHA256SUMS").find("mine.csv"), std::string::npos);
    EXPECT_EQ(run_suffuse({"verify", "here"}).code, 0);
}

TEST_F(Damaged, FilesOfTheUserInARunFolderStayUnsigned) {
    const std::vector<std::string> files = {
        "notes.txt", "own/notes.txt", "studies/notes.txt", "studies/replay/notes.txt",
        "studies/replay/settled/notes.txt"};
    for (const std::string& name : files) {
        fs::create_directories((folder / "here" / name).parent_path());
        write_to(folder / "here" / name, "first\n");
    }
    const std::string before = read_all(folder / "here/SHA256SUMS");
    ASSERT_EQ(run_suffuse({"report", "here"}).code, 0);
    EXPECT_EQ(std::ranges::count(read_all(folder / "here/SHA256SUMS"), '\n'), std::ranges::count(before, '\n'))
        << "the files of the run still have theirs";
    EXPECT_EQ(read_all(folder / "here/SHA256SUMS").find("notes.txt"), std::string::npos);
    for (const std::string& name : files) {
        write_to(folder / "here" / name, "second\n");
    }
    const ProgramResult verified = run_suffuse({"verify", "here", "--json"});
    EXPECT_EQ(verified.code, 0) << verified.out;
    EXPECT_EQ(verified.json().at("came_later").size(), files.size());
}

TEST_F(Damaged, OfAStageThatFailedOnlyItsMessageIsSigned) {
    const std::string text = read_all(examples + "replay/case.toml");
    write_to(
        folder / "soil/case.toml", text.substr(0, text.find("[[study.replay.stage]]\nname      = \"compressed\"")) +
                                       "[[study.replay.stage]]\nname = \"sheared\"\ndo = \"triaxial\"\n"
                                       "strain = \"0.0005 %\"\nstress_ratio = 0.9\n"
    );
    ASSERT_EQ(run_suffuse({"run", "soil/case.toml", "-o", "failed", "--no-cache"}).code, 1);
    const std::string sheared = "failed/studies/replay/sheared/";
    ASSERT_TRUE(fs::exists(folder / (sheared + "failed.json")));
    write_to(folder / (sheared + "history.csv"), "half of a ta");
    write_to(folder / (sheared + "notes.txt"), "the user's");
    EXPECT_EQ(run_suffuse({"report", "failed"}).code, 1) << "as the run";
    const std::string sums = read_all(folder / "failed/SHA256SUMS");
    expect_in("studies/replay/sheared/failed.json", sums);
    EXPECT_EQ(sums.find("studies/replay/sheared/history.csv"), std::string::npos) << sums;
    write_to(folder / (sheared + "notes.txt"), "the user's, later");
    const ProgramResult verified = run_suffuse({"verify", "failed", "--json"});
    EXPECT_EQ(verified.code, 5);
    EXPECT_EQ(verified.json().at("damages").size(), 0U) << verified.out;
    EXPECT_EQ(verified.json().at("came_later").size(), 2U) << verified.out;
    EXPECT_EQ(verified.json().at("missing_stages").at(0), "replay/sheared");
}

TEST_F(Damaged, WhatTasksSayAndHiddenFoldersAreNotSignedForTheyGoOnChanging) {
    for (const char* const name : {"tasks", ".snakemake"}) {
        fs::create_directories(folder / "here" / name);
        write_to(folder / "here" / name / "gather.txt", "half of it\n");
    }
    ASSERT_EQ(run_suffuse({"report", "here"}).code, 0);
    write_to(folder / "here/tasks/gather.txt", "half of it\nand the rest\n");
    write_to(folder / "here/.snakemake/gather.txt", "");
    const ProgramResult verified = run_suffuse({"verify", "here"});
    EXPECT_EQ(verified.code, 0) << verified.out;
    EXPECT_EQ(verified.out.find("gather.txt"), std::string::npos) << verified.out;
}

TEST_F(Damaged, AKillBeforeTheRemovalOfPartialH5LeavesNoneForGood) {
    fs::copy_file(stage("settled") / "state.h5", stage("settled") / "partial.h5");
    fs::remove(folder / "here/SHA256SUMS"); // the run had not ended
    ASSERT_EQ(run_suffuse({"resume", "here"}).code, 0);
    EXPECT_FALSE(fs::exists(stage("settled") / "partial.h5"));
}

TEST_F(Damaged, AKillBetweenTheChecksumsOfAStageAndItsNumbersLosesNothing) {
    const std::string seep = hash_of("seep");
    fs::remove(stage("seep") / "stage.json");
    ASSERT_TRUE(fs::exists(stage("seep") / "SHA256SUMS"));
    fs::remove(folder / "here/SHA256SUMS");
    ASSERT_EQ(run_suffuse({"resume", "here", "--no-cache"}).code, 0);
    EXPECT_EQ(hash_of("seep"), seep);
    EXPECT_EQ(run_suffuse({"verify", "here"}).code, 0);
}

} // namespace
} // namespace suffuse
