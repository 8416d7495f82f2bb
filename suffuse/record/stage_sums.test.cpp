#include "suffuse/record/stage_sums.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/record/finished_stages.hpp"
#include "suffuse/record/folder.hpp"

#include <gtest/gtest.h>

#include "tests/support/temp_folder.hpp"
#include <cstdlib>
#include <fstream>

namespace suffuse::record {
namespace {

namespace fs = std::filesystem;

/// A run with one finished stage.
class Sealed : public testing::Test {
protected:
    Sealed() {
        fs::create_directories(stage());
        write(stage() / "state.h5", "grains");
        write(stage() / "history.csv", "1,2,3\n");
        write(stage() / "partial.h5", "half of the way");
        seal_stage(stage(), {{"stage", "x"}, {"sample", "s"}, {"void_ratio", 0.6}});
    }

    static void write(const fs::path& file, const std::string& text) { std::ofstream(file) << text; }

    [[nodiscard]] fs::path run() const { return folder / "run"; }

    [[nodiscard]] fs::path stage() const { return run() / "studies/s/x"; }

    /// "" where the stage is taken for whole.
    [[nodiscard]] std::string complaint() const {
        try {
            require_whole_stages(run());
            return "";
        } catch (const IoError& error) {
            return error.what();
        }
    }

    void expect_complaint_of(const std::string& file) {
        const std::string found = complaint();
        EXPECT_NE(found.find((stage() / file).string()), std::string::npos) << file << ": " << found;
        EXPECT_NE(found.find("remove " + stage().string() + " and resume"), std::string::npos) << found;
    }

    test::TempFolder folder;
};

TEST_F(Sealed, WholeIsWhatTheStageLeftAndSha256sumAgrees) {
    EXPECT_EQ(complaint(), "");
    EXPECT_EQ(read_json(stage() / "stage.json").at("checksums"), 3);
    EXPECT_EQ(std::system(("cd '" + stage().string() + "' && sha256sum --quiet --strict -c SHA256SUMS").c_str()), 0);
    fs::remove(stage() / "partial.h5"); // goes when the stage has ended
    write(stage() / "notes.txt", "mine");
    EXPECT_EQ(complaint(), "");
    for (const char* const file : {"state.h5", "stage.json", "notes.txt"}) {
        EXPECT_NO_THROW(check_file(stage() / file)) << file;
    }
}

TEST_F(Sealed, EveryFileThatWasChangedLostOrCutIsNamedWithWhatToDo) {
    for (const char* const file : {"state.h5", "history.csv", "stage.json", "SHA256SUMS"}) {
        const std::string whole = test::read_all(stage() / file);
        std::string digit = whole;
        digit[digit.find_first_of("126r")] = '8';
        for (const std::string& text : {digit, whole.substr(0, whole.size() / 2), whole + "\n8", std::string()}) {
            write(stage() / file, text);
            expect_complaint_of(file == std::string("SHA256SUMS") ? "" : file);
        }
        if (file != std::string("stage.json")) { // without it the stage is not finished
            fs::remove(stage() / file);
            expect_complaint_of(file);
            EXPECT_THROW(check_file(stage() / file), IoError) << file;
        }
        write(stage() / file, whole);
        EXPECT_EQ(complaint(), "") << file;
    }
}

TEST_F(Sealed, ChecksumsThatLostALineAreDamaged) {
    Sums sums = read_sums(stage() / checksums_file);
    sums.erase("state.h5");
    write(stage() / checksums_file, sums_text(sums));
    write(stage() / "state.h5", "sand");
    expect_complaint_of("SHA256SUMS");
    EXPECT_THROW(check_file(stage() / "state.h5"), IoError);
}

TEST_F(Sealed, ChecksumsThatWereRemovedDoNotMakeItAStageOfAnEarlierVersion) {
    fs::remove(stage() / checksums_file);
    expect_complaint_of("SHA256SUMS");
}

TEST_F(Sealed, AStageOfAnEarlierVersionIsTakenAndNamed) {
    fs::remove(stage() / checksums_file);
    write_json(stage() / "stage.json", {{"stage", "x"}, {"void_ratio", 0.6}});
    EXPECT_NE(require_whole_stages(run()).find("no checksums of s/x"), std::string::npos);
    // The run that it ended with may have them.
    const std::string sum = checksum_of(stage() / "stage.json");
    write(run() / checksums_file, sums_text({{"studies/s/x/stage.json", sum}}));
    EXPECT_TRUE(require_whole_stages(run()).empty());
    write_json(stage() / "stage.json", {{"stage", "x"}, {"void_ratio", 0.7}});
    expect_complaint_of("stage.json");
}

TEST_F(Sealed, AFolderThatIsAnotherStagesIsNamed) {
    fs::copy(stage(), run() / "studies/s/y");
    EXPECT_NE(complaint().find("studies/s/y/stage.json is of the stage s/x"), std::string::npos) << complaint();
    fs::remove_all(run() / "studies/s/y");
    fs::create_directories(run() / "studies/t");
    fs::copy(stage(), run() / "studies/t/x");
    EXPECT_NE(complaint().find("studies/t/x/stage.json is of the stage s/x"), std::string::npos) << complaint();
}

TEST_F(Sealed, AStageThatIsUnderWayIsNotLookedAt) {
    fs::remove(stage() / "stage.json"); // as after a kill between the checksums and it
    write(stage() / "state.h5", "half of");
    EXPECT_EQ(complaint(), "");
    EXPECT_NO_THROW(check_file(stage() / "state.h5"));
}

} // namespace
} // namespace suffuse::record
