#include "suffuse/record/stage_cache.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/record/folder.hpp"
#include "suffuse/record/stage_sums.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/temp_folder.hpp"
#include <chrono>
#include <fstream>
#include <unistd.h>

namespace suffuse::record {
namespace {

namespace fs = std::filesystem;

/// A cache, and a finished stage that may be kept in it.
class Cached : public testing::Test {
protected:
    Cached() : cache(folder / "cache") {
        variant.folder = "s";
        stage.name = "x";
        fs::create_directories(done());
        fs::create_directories(taken());
        write(done() / "state.h5", "grains");
        seal_stage(
            done(),
            {{"end_state", "1"}, {"wall_seconds", 2.0}, {"warnings", {"s/x: odd"}}, {"flaws", nlohmann::json::array()}}
        );
    }

    static void write(const fs::path& file, const std::string& text) { std::ofstream(file) << text; }

    [[nodiscard]] fs::path done() const { return folder / "run/studies/s/x"; }

    [[nodiscard]] fs::path taken() const { return folder / "again/studies/s/x"; }

    [[nodiscard]] CacheAnswer request() const { return cache.take("key", variant, stage, taken(), "its own"); }

    [[nodiscard]] bool take() const { return request().is_taken; }

    /// Of the one entry.
    [[nodiscard]] fs::path place() const { return cache.entries().at(0).folder; }

    test::TempFolder folder;
    StageCache cache;
    casefile::Variant variant;
    casefile::Stage stage;
};

TEST_F(Cached, AFinishedStageIsFoundAgain) {
    EXPECT_FALSE(take());
    cache.keep("key", done());
    EXPECT_TRUE(take());
    EXPECT_FALSE(fs::exists(place() / ".made-by-suffuse")) << "it is whole";
    EXPECT_EQ(test::read_all(taken() / "state.h5"), "grains");
    EXPECT_EQ(read_json(taken() / "stage.json").at("from_cache"), true);
    EXPECT_EQ(read_json(taken() / "stage.json").at("sample"), "s");
    EXPECT_EQ(read_json(taken() / "stage.json").at("key"), "its own");
    EXPECT_TRUE(check_stage(taken()).value().empty());
}

TEST_F(Cached, AnEntryOfAnotherUserIsTakenOnlyOnRequest) {
    if (geteuid() != 0) {
        GTEST_SKIP() << "only root can give a folder away";
    }
    constexpr uid_t another = 65534;
    cache.keep("key", done());
    ASSERT_EQ(chown(place().c_str(), another, another), 0);
    EXPECT_FALSE(take());
    EXPECT_FALSE(cache.find("key").has_value());
    EXPECT_TRUE(StageCache(cache.folder(), Owners::Anybody).take("key", variant, stage, taken(), "its own").is_taken);
}

TEST_F(Cached, AFolderIsACacheOnlyIfItsCacheJsonSaysSo) {
    EXPECT_FALSE(cache.is_one());
    EXPECT_NO_THROW(cache.require_one()) << "it is made";
    fs::create_directories(cache.folder());
    EXPECT_TRUE(cache.is_one()) << "it is empty";
    fs::create_directories(cache.folder() / "deadbeefdeadbeef");
    for (const char* const text : {"", "[]", "{}", "{\"about\": \"my caches\"}", "{\"limit_bytes\": 5}"}) {
        write(cache.folder() / "cache.json", text);
        EXPECT_FALSE(cache.is_one()) << text;
        EXPECT_THROW(cache.require_one(), UsageError) << text;
    }
    cache.set_limit(7);
    EXPECT_TRUE(cache.is_one());
    EXPECT_NO_THROW(cache.require_one());
    EXPECT_NO_THROW(StageCache({}).require_one());
}

TEST_F(Cached, ACacheThatAnotherProgramMakesJustNowIsFree) {
    fs::create_directories(cache.folder());
    write(cache.folder() / "cache.json.partial-12-3", "{");
    EXPECT_TRUE(cache.is_one());
}

TEST_F(Cached, FilesOfTheUserInACacheStayWhateverTheirNames) {
    cache.keep("key", done());
    const std::vector<fs::path> mine = {
        cache.folder() / "new-2024/a.jpg", cache.folder() / "deadbeefdeadbeef/p", cache.folder() / "0123456789abcdef",
        cache.folder() / "notes.txt"};
    for (const fs::path& file : mine) {
        fs::create_directories(file.parent_path());
        write(file, "mine");
    }
    fs::last_write_time(cache.folder() / "new-2024", fs::file_time_type::clock::now() - std::chrono::hours(72));
    EXPECT_EQ(cache.shrink(0), 1);
    EXPECT_EQ(cache.clear(), 0);
    for (const fs::path& file : mine) {
        EXPECT_EQ(test::read_all(file), "mine") << file;
    }
}

TEST_F(Cached, ADamagedEntryIsDroppedAndKeptAnew) {
    for (const char* const file : {"entry.json", "stage.json", "state.h5", "SHA256SUMS"}) {
        for (const char* const text : {"", "[]", "{\"made_as\": 3}", "null"}) {
            fs::remove_all(taken());
            fs::create_directories(taken());
            cache.keep("key", done());
            const fs::path damaged = place() / file;
            write(damaged, text);
            const CacheAnswer answer = request();
            EXPECT_FALSE(answer.is_taken) << file << " " << text;
            EXPECT_NE(answer.damage.find(damaged.string()), std::string::npos) << answer.damage;
            EXPECT_FALSE(fs::exists(damaged.parent_path()));
            EXPECT_TRUE(fs::is_empty(taken())) << "what was taken until then goes";
            EXPECT_TRUE(cache.entries().empty()) << file << " " << text;
            cache.keep("key", done());
            EXPECT_TRUE(take()) << file << " " << text;
        }
    }
}

TEST_F(Cached, ADigitThatWasChangedIsSeen) {
    for (const char* const file : {"entry.json", "stage.json", "state.h5"}) {
        cache.keep("key", done());
        std::string text = test::read_all(place() / file);
        const std::size_t at = text.find_first_of("12s");
        ASSERT_NE(at, std::string::npos);
        text[at] = text[at] == 's' ? 't' : '9'; // the same length
        write(place() / file, text);
        EXPECT_FALSE(take()) << file;
    }
}

TEST_F(Cached, AFileThatIsMissingOrExchangedIsSeen) {
    cache.keep("key", done());
    fs::remove(place() / "state.h5");
    EXPECT_NE(request().damage.find("state.h5 is missing"), std::string::npos);
    cache.keep("key", done());
    cache.keep("another key", done());
    const auto both = cache.entries();
    ASSERT_EQ(both.size(), 2U);
    fs::copy_file( // the entry would be taken for what it is not
        both[0].folder / "entry.json", both[1].folder / "entry.json", fs::copy_options::overwrite_existing
    );
    EXPECT_NE(take(), cache.take("another key", variant, stage, taken(), "its own").is_taken) << "one of them is whole";
}

TEST_F(Cached, ChecksumsThatNameAFileElsewhereAreRefused) {
    cache.keep("key", done());
    write(folder / "cache/mine", "mine");
    Sums sums = read_sums(place() / checksums_file);
    sums["../mine"] = checksum_of(folder / "cache/mine");
    nlohmann::json numbers = read_json(place() / "stage.json");
    numbers["checksums"] = sums.size() - 1; // but for entry.json
    write_json(place() / "stage.json", numbers);
    sums["stage.json"] = checksum_of(place() / "stage.json");
    write(place() / checksums_file, sums_text(sums));
    EXPECT_FALSE(take());
    EXPECT_FALSE(fs::exists(folder / "again/studies/s/mine"));
}

TEST_F(Cached, AnEntryStaysWhereTheStageCannotTakeIt) {
    cache.keep("key", done());
    fs::remove(taken());
    write(taken(), "a file where the folder should be");
    const CacheAnswer answer = request();
    EXPECT_FALSE(answer.is_taken);
    EXPECT_EQ(answer.damage, "");
    EXPECT_EQ(cache.entries().size(), 1U);
}

TEST_F(Cached, AStageThatWasDamagedIsNotKept) {
    write(done() / "state.h5", "grainy");
    EXPECT_THROW(cache.keep("key", done()), IoError);
    EXPECT_TRUE(cache.entries().empty());
}

TEST_F(Cached, AStageWhoseNumbersMentionFinesIsNotTakenForOneWithout) {
    const casefile::Case what;
    stage.spec = packing::CompactSpec{};
    variant.stages = {stage};
    variant.soil = grains::Soil{};
    const std::string plain = StageCache::key_of(what, variant, stage, "1");
    variant.soil->fines.emplace();
    EXPECT_NE(StageCache::key_of(what, variant, stage, "1"), plain);
}

TEST_F(Cached, SettingsOfAnotherShapeCountAsNone) {
    cache.keep("key", done());
    for (const char* const text : {"", "[]", "{\"limit_bytes\": \"much\"}"}) {
        write(folder / "cache/cache.json", text);
        EXPECT_EQ(cache.limit(), StageCache::usual_limit) << text;
    }
    cache.set_limit(7);
    EXPECT_EQ(cache.limit(), 7);
}

TEST_F(Cached, WhatAKilledProgramLeftIsRemovedAndNothingElse) {
    cache.keep("key", done());
    const fs::path young = folder / "cache/new-123-1", old = folder / "cache/new-123-2",
                   mine = folder / "cache/new-ideas";
    for (const fs::path& left : {young, old, mine}) {
        fs::create_directories(left);
        write(left / ".made-by-suffuse", "");
    }
    fs::create_directories(folder / "cache/new-123-3"); // nobody's mark
    fs::last_write_time(old, fs::file_time_type::clock::now() - std::chrono::hours(25));
    fs::last_write_time(mine, fs::file_time_type::clock::now() - std::chrono::hours(25));
    write(place() / "entry.json", "");
    EXPECT_EQ(cache.shrink(StageCache::usual_limit), 1); // the damaged one
    EXPECT_TRUE(fs::exists(young));                      // may be at work
    EXPECT_FALSE(fs::exists(old));
    cache.keep("key", done());
    EXPECT_EQ(cache.clear(), 1);
    EXPECT_FALSE(fs::exists(young));
    EXPECT_TRUE(fs::exists(mine));
    EXPECT_TRUE(fs::exists(folder / "cache/new-123-3"));
    EXPECT_TRUE(cache.entries().empty());
}

} // namespace
} // namespace suffuse::record
