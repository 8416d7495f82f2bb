// Fines that migrate, through the whole program: what the stage leaves to be read, and a stop in the middle of it.

#include "suffuse/base/parallel.hpp"
#include "suffuse/record/folder.hpp"

#include <gtest/gtest.h>

#include "tests/support/run_text.hpp"
#include <atomic>
#include <cmath>
#include <set>
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

/// Lines of a table, the header included.
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
        rows.front(), "time,gradient,sample_gradient,base_gradient,filter_gradient,permeability,eroded_mass,"
                      "eroded_mass_share,moving_mass_share,lodged_mass_share,energy,fed_mass"
    );
    EXPECT_EQ(rows.size() - 1, away.at("flows").get<std::size_t>());
    EXPECT_EQ(
        ledger.front(), "id,d,mass,entered,x0,y0,z0,departed,gradient,left,x,y,z,travel,throats,narrowest,fate,holders"
    );
    const std::vector<std::string> slices = lines_of_table(stage / "profile.csv");
    EXPECT_EQ(slices.front(), "gradient,from,to,porosity,fines,permeability");
    EXPECT_EQ(slices.size() % 3, 1U) << "before, and at the end of each gradient";
    std::size_t gone = 0, lost = initial.at("grains").get<std::size_t>() - away.at("grains").get<std::size_t>();
    for (const std::string& line : ledger) {
        gone += line.find(",eroded,") != std::string::npos ? 1 : 0;
    }
    EXPECT_EQ(gone, lost);
    EXPECT_TRUE(std::filesystem::exists(stage / "frame-0.h5"));
    const std::string page = text_of(folder.path() / "run/report.html");
    EXPECT_NE(page.find("at rest, before the flow"), std::string::npos) << "the view in 3D is over time";
    EXPECT_NE(page.find("own-migration-time"), std::string::npos);
    EXPECT_NE(page.find("own-migration"), std::string::npos);
    EXPECT_NE(page.find("own-migration-power"), std::string::npos);
    EXPECT_NE(page.find("own-migration-profile"), std::string::npos);
}

/// A base of a third of its filter's size, above it.
const std::string base_on_filter = R"(
[gravity]
down = "z"
[output]
formats = ["csv"]
[soil.base]
psd = { d = ["0.18 mm", "0.22 mm"], passing = ["0 %", "100 %"] }
grading_tolerance = "10 %"
[soil.filter]
psd = { d = ["0.54 mm", "0.66 mm"], passing = ["0 %", "100 %"] }
grading_tolerance = "10 %"
[study.s]
[[study.s.stage]]
name   = "cloud"
do     = "pack"
layers = [{ soil = "base", thickness = "0.9 mm" }, { soil = "filter", thickness = "2.2 mm" }]
width  = "2.2 mm"
[[study.s.stage]]
name     = "initial"
do       = "compact"
pressure = "100 kPa"
protocol = "wide"
[[study.s.stage]]
name         = "flow"
do           = "migrate"
gradients    = [1]
hold_at_most = "500 ms"
direction    = "z"
)";

TEST(Migration, OfABaseIntoItsFilterLeavesLayersAndAProfile) {
    const TempFolder folder;
    run_text(reference_constants + base_on_filter, folder.path());
    const json cloud = stage_of(folder.path(), "cloud"), flow = stage_of(folder.path(), "flow");
    ASSERT_EQ(cloud.at("layers").size(), 2U);
    EXPECT_EQ(cloud.at("layers")[0].at("soil"), "base");
    const json& stack = flow.at("stack");
    EXPECT_NEAR(stack.at("base_thickness").get<double>(), 0.9e-3, 0.15e-3);
    EXPECT_LT(stack.at("screen_mass_share"), 0.4);
    EXPECT_LT(stack.at("base_permeability"), stack.at("filter_permeability"));
    EXPECT_NEAR(stack.at("size_ratio").get<double>(), 2.6, 0.3);
    EXPECT_GT(stack.at("controlling_constriction"), 0.1547 * 0.54e-3) << "of three grains that touch";
    EXPECT_LT(stack.at("controlling_constriction"), 0.5 * stack.at("filter_d15").get<double>());
    EXPECT_LT(std::abs(stack.at("interface_head_share").get<double>()), 0.4);
    EXPECT_LT(flow.at("eroded_mass_share"), 0.01) << "a filter of this ratio holds all but single grains";
    const json& hold = flow.at("holds")[0];
    EXPECT_EQ(stack.at("ended"), hold.at("ended"));
    EXPECT_LT(hold.at("moving_mass_share"), 0.05) << "single grains in open holes";
    EXPECT_LT(hold.at("sample_gradient"), hold.at("gradient"));
    EXPECT_LT(hold.at("depth"), 2 * 0.66e-3) << "two grains of the filter stop it";
    const std::vector<std::string> profile = lines_of_table(folder.path() / "run/studies/s/flow/profile.csv");
    EXPECT_EQ(profile.front(), "gradient,from,to,base,filter");
    EXPECT_EQ(profile.size() % 2, 1U) << "before and after";
    const std::string page = text_of(folder.path() / "run/report.html");
    EXPECT_NE(page.find("Whether the filter holds"), std::string::npos);
    for (const char* figure : {"own-filter-profile", "own-filter-cut", "own-filter-sizes"}) {
        EXPECT_NE(page.find(figure), std::string::npos) << figure;
    }
}

TEST(Migration, JudgesABaseByTheGapOfItsCurveThoughSomeOfItsGrainsLieInIt) {
    const TempFolder folder;
    std::string text = base_on_filter;
    const auto replace = [&](const std::string& what, const std::string& with) {
        text.replace(text.find(what), what.size(), with);
    };
    replace(
        R"(d = ["0.18 mm", "0.22 mm"], passing = ["0 %", "100 %"])",
        R"(d = ["0.14 mm", "0.16 mm", "0.26 mm", "0.3 mm"], passing = ["0 %", "40 %", "41 %", "100 %"])"
    );
    replace("500 ms", "1 ms");
    run_text(reference_constants + text, folder.path());
    const json stack = stage_of(folder.path(), "flow").at("stack");
    EXPECT_NEAR(stack.at("base_gap").get<double>(), 0.16e-3, 1e-12);
    EXPECT_LT(stack.at("base_d85"), 0.16e-3);
}

/// Runs a case in pieces: stops it after so many beats of its motion, and at the first beat of each other part of the
/// stage. @return how often it was stopped
int run_in_pieces(
    const std::string& text, const std::string& stage, const std::filesystem::path& folder, int beats_at_most
) {
    std::set<std::string> seen;
    int stops = 0;
    for (bool is_over = false; !is_over; ++stops) {
        std::atomic<bool> stop{false};
        run::RunOptions options;
        options.stop = &stop;
        options.progress_interval = 0;
        int beats = 0;
        options.on_progress = [&](const run::Progress& progress) {
            if (progress.stage == stage) {
                const bool is_new = progress.part != "migrate" && seen.insert(progress.part).second;
                beats += progress.part == "migrate" ? 1 : 0;
                stop = stop || is_new || beats >= beats_at_most;
            }
        };
        is_over = run_text(text, folder, options).outcome != record::Outcome::Stopped;
        if (stops > 200) {
            ADD_FAILURE() << "it does not get on";
            break;
        }
    }
    return stops;
}

void expect_same_stage(const std::filesystem::path& one, const std::filesystem::path& other, const std::string& stage) {
    for (const char* const table : {"migration.csv", "ledger.csv", "profile.csv"}) {
        const std::filesystem::path file = "run/studies/s/" + stage + "/" + table;
        EXPECT_EQ(text_of(one / file), text_of(other / file)) << table;
    }
    const json after = stage_of(one, stage), before = stage_of(other, stage);
    EXPECT_EQ(after.at("state_hash"), before.at("state_hash"));
    EXPECT_EQ(after.value("stack", json()), before.value("stack", json()));
}

TEST(Migration, GoesOnAfterStopsToTheSameBitsAlsoWhereFinesEnter) {
    std::string text = reference_constants + gap_graded;
    text.replace(text.find("exit         ="), 0, "feed = \"10 kg/m^3\"\n");
    const TempFolder straight, broken;
    run_text(text, straight.path());
    EXPECT_GE(run_in_pieces(text, "away", broken.path(), 40), 3);
    expect_same_stage(broken.path(), straight.path(), "away");
    EXPECT_GT(stage_of(straight.path(), "away").at("fed_mass_share"), 0);
}

TEST(Migration, OfABaseIntoItsFilterGoesOnAfterStopsToTheSameBits) {
    const TempFolder straight, broken;
    run_text(reference_constants + base_on_filter, straight.path());
    EXPECT_GE(run_in_pieces(reference_constants + base_on_filter, "flow", broken.path(), 40), 3);
    expect_same_stage(broken.path(), straight.path(), "flow");
}

TEST(Migration, WhoseSkeletonMovesGoesOnAfterStopsToTheSameBitsWithOneThreadAndTwo) {
    std::string text = reference_constants + gap_graded;
    const std::string held = "exit         = \"1 mm\"\nhold_at_most = \"150 ms\"\n";
    text.replace(text.find(held), held.size(), "exit = \"1 mm\"\nhold_at_most = \"100 ms\"\nskeleton = \"moves\"\n");
    const int threads = thread_count();
    const TempFolder straight, one, two;
    set_thread_count(1);
    run_text(text, straight.path());
    EXPECT_GE(run_in_pieces(text, "away", one.path(), 40), 5) << "fines rest, migrate, and the skeleton moves twice";
    set_thread_count(2);
    EXPECT_GE(run_in_pieces(text, "away", two.path(), 60), 5);
    set_thread_count(threads);
    expect_same_stage(one.path(), straight.path(), "away");
    expect_same_stage(two.path(), straight.path(), "away");
    const json away = stage_of(straight.path(), "away");
    EXPECT_NE(away.at("holds")[0].at("volumetric_strain"), 0);
}

} // namespace
} // namespace suffuse::test
