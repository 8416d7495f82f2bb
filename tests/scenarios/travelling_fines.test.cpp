// Fines that follow the water: a whole erosion of them, from the case to its files.

#include "suffuse/base/parallel.hpp"
#include "suffuse/io/checkpoint.hpp"

#include <gtest/gtest.h>

#include "tests/support/run_text.hpp"

namespace suffuse::test {
namespace {

using nlohmann::json;

std::string two_passes() {
    return reference_constants + reference_soil() + study_of_packing("packing2000") +
           "[[study.s.stage]]\nname = \"travelled\"\ndo = \"erode\"\npasses = 2\nramp = 100\nwatch = 100\n"
           "relax_limit = 20000\ngradient = 0.5\npasses_constriction = { size = \"flow-path\", distance = \"0.1 mm\" "
           "}\n";
}

TEST(TravellingFines, LeaveLodgeOrStayAndAreAllAccountedFor) {
    const TempFolder folder;
    run_text(two_passes(), folder.path());
    const json stage = stage_of(folder.path(), "travelled");
    EXPECT_EQ(stage.at("passes").size(), 2U) << stage.at("passes").back().at("verdict");
    std::int64_t removed = 0, detached = 0, lodged = 0;
    for (const json& pass : stage.at("passes")) {
        const json& transport = pass.at("transport");
        EXPECT_EQ(transport.at("distance"), 1e-4);
        EXPECT_EQ(transport.at("left"), pass.at("removed"));
        const auto held = transport.at("lodged").get<std::int64_t>() + transport.at("stayed").get<std::int64_t>();
        EXPECT_EQ(pass.at("held_back"), held);
        removed += pass.at("removed").get<std::int64_t>();
        detached += pass.at("detachable").get<std::int64_t>();
        lodged += transport.at("lodged").get<std::int64_t>();
        EXPECT_GT(transport.at("filter_coefficient").get<double>(), 0);
    }
    EXPECT_GT(removed, 0);
    EXPECT_GT(lodged, 0);
    const std::filesystem::path results = folder.path() / "run/studies/s/travelled";
    const std::string table = text_of(results / "transport.csv");
    EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 1 + detached);
    EXPECT_EQ(io::load_world(results / "state.h5").world.grains.size(), static_cast<std::size_t>(2000 - removed));
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "run/figures/own-transport.csv"));
}

TEST(TravellingFines, GoTheSameWayOnAnyNumberOfThreads) {
    std::vector<std::string> tables, hashes;
    for (const int threads : {1, 2}) {
        set_thread_count(threads);
        const TempFolder folder;
        run_text(two_passes(), folder.path());
        tables.push_back(text_of(folder.path() / "run/studies/s/travelled/transport.csv"));
        hashes.push_back(stage_of(folder.path(), "travelled").at("state_hash"));
    }
    set_thread_count(1);
    EXPECT_EQ(tables[0], tables[1]);
    EXPECT_EQ(hashes[0], hashes[1]);
}

} // namespace
} // namespace suffuse::test
