// Fines that migrate, through the whole program: what the stage leaves to be read, and a stop in the middle of it.

#include "suffuse/record/folder.hpp"

#include <gtest/gtest.h>

#include "tests/support/run_text.hpp"
#include <atomic>
#include <cmath>
#include <sstream>

namespace suffuse::test {
namespace {

using nlohmann::json;

/// Fines of a fifth of the coarse diameter: some are small enough for the holes between coarse grains.
const std::string gap_graded = R"(
[gravity]
down = "-z"
[output]
formats = ["csv"]
[soil.gap]
coarse        = { psd = { d = ["0.9 mm", "1.1 mm"], passing = ["0 %", "100 %"] } }
fines         = { psd = { d = ["0.13 mm", "0.23 mm"], passing = ["0 %", "100 %"] } }
fines_content = "4 %"
grading_tolerance = "10 %"
[study.s]
soil      = "gap"
particles = 500
[[study.s.stage]]
name     = "cloud"
do       = "pack"
[[study.s.stage]]
name     = "initial"
do       = "compact"
pressure = "100 kPa"
protocol = "swift"
[[study.s.stage]]
name         = "away"
do           = "migrate"
gradients    = [0.2, 0.9]
exit         = "1 mm"
hold_at_most = "150 ms"
direction    = "z"
[[study.s.stage]]
name     = "settled"
do       = "settle"
pressure = "100 kPa"
)";

/// Lines of a table, header first.
std::vector<std::string> lines_of_table(const std::filesystem::path& file) {
    std::vector<std::string> lines;
    std::istringstream text(text_of(file));
    for (std::string line; std::getline(text, line);) {
        lines.push_back(line);
    }
    return lines;
}

TEST(Migration, LeavesItsRowsItsLedgerAndASampleThatSettles) {
    const TempFolder folder;
    run_text(reference_constants + gap_graded, folder.path());
    const std::filesystem::path stage = folder.path() / "run/studies/s/away";
    const json away = stage_of(folder.path(), "away"), initial = stage_of(folder.path(), "initial");
    const double eroded = away.at("eroded_mass_share"), lodged = away.at("lodged_mass_share");
    EXPECT_GT(eroded, 0.01);
    EXPECT_LT(eroded + lodged, 1);
    ASSERT_EQ(away.at("holds").size(), 2U);
    EXPECT_LE(away.at("holds")[0].at("eroded_mass_share"), away.at("holds")[1].at("eroded_mass_share"));
    EXPECT_LT(away.at("largest_overlap"), 0.05);
    EXPECT_EQ(away.at("model"), "with weight");
    EXPECT_LT(away.at("grains"), initial.at("grains"));
    // Grains of the skeleton do not move, and it carries what it did; fines press no more than nothing.
    const double before = initial.at("mean_stress"), after = away.at("mean_stress");
    EXPECT_NEAR(after / before, 1, 0.02);
    EXPECT_NEAR(stage_of(folder.path(), "settled").at("mean_stress").get<double>() / 100e3, 1, 0.01);

    const std::vector<std::string> rows = lines_of_table(stage / "migration.csv"),
                                   ledger = lines_of_table(stage / "ledger.csv");
    EXPECT_EQ(
        rows.front(), "time,gradient,permeability,eroded_mass,eroded_mass_share,moving_mass_share,"
                      "lodged_mass_share,energy"
    );
    EXPECT_EQ(rows.size() - 1, away.at("flows").get<std::size_t>());
    EXPECT_EQ(ledger.front(), "id,d,mass,x0,y0,z0,departed,gradient,left,x,y,z,travel,fate,holders");
    std::size_t gone = 0, lost = initial.at("grains").get<std::size_t>() - away.at("grains").get<std::size_t>();
    for (const std::string& line : ledger) {
        gone += line.find(",eroded,") != std::string::npos ? 1 : 0;
    }
    EXPECT_EQ(gone, lost);
    const std::string page = text_of(folder.path() / "run/report.html");
    EXPECT_NE(page.find("own-migration-time"), std::string::npos);
    EXPECT_NE(page.find("own-migration"), std::string::npos);
}

TEST(Migration, GoesOnAfterStopsToTheSameBits) {
    const TempFolder straight, broken;
    run_text(reference_constants + gap_graded, straight.path());
    int stops = 0;
    for (bool is_over = false; !is_over; ++stops) {
        std::atomic<bool> stop{false};
        run::RunOptions options;
        options.stop = &stop;
        options.progress_interval = 0;
        int beats = 0;
        options.on_progress = [&](const run::Progress& progress) {
            beats += progress.stage == "away" && progress.part == "migrate" ? 1 : 0;
            stop = stop || beats >= 40;
        };
        is_over =
            run_text(reference_constants + gap_graded, broken.path(), options).outcome != record::Outcome::Stopped;
        ASSERT_LT(stops, 200);
    }
    EXPECT_GE(stops, 3);
    const char* const rows = "run/studies/s/away/migration.csv";
    const char* const ledger = "run/studies/s/away/ledger.csv";
    EXPECT_EQ(text_of(broken.path() / rows), text_of(straight.path() / rows));
    EXPECT_EQ(text_of(broken.path() / ledger), text_of(straight.path() / ledger));
    EXPECT_EQ(stage_of(broken.path(), "away").at("state_hash"), stage_of(straight.path(), "away").at("state_hash"));
}

} // namespace
} // namespace suffuse::test
