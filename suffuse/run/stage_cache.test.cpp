#include "suffuse/run/stage_cache.hpp"

#include "suffuse/run/folder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/temp_folder.hpp"
#include <chrono>
#include <fstream>

namespace suffuse::run {
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
        write_json(
            done() / "stage.json",
            {{"end_state", "1"}, {"wall_seconds", 2.0}, {"warnings", {"s/x: odd"}}, {"flaws", nlohmann::json::array()}}
        );
    }

    static void write(const fs::path& file, const std::string& text) { std::ofstream(file) << text; }

    [[nodiscard]] fs::path done() const { return folder / "run/studies/s/x"; }

    [[nodiscard]] fs::path taken() const { return folder / "again/studies/s/x"; }

    [[nodiscard]] bool take() const { return cache.take("key", variant, stage, taken()); }

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
    EXPECT_EQ(test::read_all(taken() / "state.h5"), "grains");
    EXPECT_EQ(read_json(taken() / "stage.json").at("from_cache"), true);
}

TEST_F(Cached, ADamagedEntryIsDroppedAndKeptAnew) {
    for (const char* const file : {"entry.json", "stage.json", "state.h5"}) {
        for (const char* const text : {"", "[]", "{\"made_as\": 3}", "null"}) {
            cache.keep("key", done());
            write(place() / file, text);
            EXPECT_FALSE(take()) << file << " " << text;
            EXPECT_TRUE(cache.entries().empty()) << file << " " << text;
            cache.keep("key", done());
            EXPECT_TRUE(take()) << file << " " << text;
        }
    }
}

TEST_F(Cached, AStageWhoseNumbersTellOfFinesIsNotTakenForOneWithout) {
    const casefile::Case what;
    stage.spec = packing::CompactSpec{};
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
    }
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
    EXPECT_TRUE(cache.entries().empty());
}

} // namespace
} // namespace suffuse::run
