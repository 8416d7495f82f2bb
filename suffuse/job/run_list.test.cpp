#include "suffuse/job/run_list.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/record/folder.hpp"

#include <gtest/gtest.h>

#include "tests/support/temp_folder.hpp"
#include <fstream>

namespace suffuse::job {
namespace {

void add_run(
    const test::TempFolder& folder, const std::string& name, const std::string& finished, double seconds,
    const nlohmann::json& more = nlohmann::json::object()
) {
    std::filesystem::create_directories(folder / name);
    std::ofstream(folder / (name + "/case.resolved.toml")) << "schema = 1\n";
    nlohmann::json summary = {
        {"title", "Of " + name},
        {"samples", {{"total", 3}, {"done", 2}}},
        {"answer", {{"verdict", {"Water carries out " + name + "."}}}}};
    summary.update(more);
    record::write_json(folder / (name + "/summary.json"), summary);
    record::write_json(
        folder / (name + "/provenance.json"), {{"finished", finished}, {"wall_seconds", seconds}, {"commit", "abc"}}
    );
}

std::vector<std::string> names_of(const std::vector<ListedRun>& runs) {
    std::vector<std::string> names;
    names.reserve(runs.size());
    for (const ListedRun& run : runs) {
        names.push_back(run.name);
    }
    return names;
}

TEST(RunList, HasTheRunsOfAFolderInTheRequestedOrder) {
    const test::TempFolder folder;
    add_run(folder, "a-0001", "2026-01-02T10:00:00Z", 5);
    add_run(folder, "b-0001", "2026-01-01T10:00:00Z", 50);
    std::filesystem::create_directories(folder / "suffuse-cache"); // no run
    using Names = std::vector<std::string>;
    EXPECT_EQ(names_of(list_runs(folder.path(), RunOrder::Finished)), (Names{"a-0001", "b-0001"}));
    EXPECT_EQ(names_of(list_runs(folder.path(), RunOrder::Time)), (Names{"b-0001", "a-0001"}));
    EXPECT_EQ(names_of(list_runs(folder.path(), RunOrder::Name)), (Names{"a-0001", "b-0001"}));
    EXPECT_THROW(list_runs(folder / "nowhere", RunOrder::Name), IoError);
}

TEST(RunList, SaysHowFarEachRunCame) {
    const test::TempFolder folder;
    add_run(folder, "whole", "2026-01-01T10:00:00Z", 5);
    add_run(folder, "flawed", "2026-01-01T10:00:00Z", 5, {{"flaws", {"not at rest"}}});
    add_run(folder, "cut", "2026-01-01T10:00:00Z", 5, {{"missing_stages", {"a/b"}}});
    add_run(folder, "failed", "2026-01-01T10:00:00Z", 5, {{"failures", {{{"sample", "a"}}}}});
    std::filesystem::create_directories(folder / "young"); // without a summary yet
    std::ofstream(folder / "young/case.resolved.toml") << "no case";
    std::map<std::string, std::string> state;
    for (const ListedRun& run : list_runs(folder.path(), RunOrder::Name)) {
        state[run.name] = run.state;
    }
    EXPECT_EQ(state["whole"], "done");
    EXPECT_EQ(state["flawed"], "flaws");
    EXPECT_EQ(state["cut"], "not complete");
    EXPECT_EQ(state["failed"], "failed in part");
    EXPECT_EQ(state["young"], "not complete");
}

TEST(RunList, IsATableThatKeepsToItsWidthAndADocumentThatKeepsAll) {
    const test::TempFolder folder;
    add_run(folder, "a-0001", "2026-01-02T10:00:00Z", 5);
    const std::vector<ListedRun> runs = list_runs(folder.path(), RunOrder::Name);
    const std::string text = text_of(runs, 200);
    EXPECT_NE(
        text.find("a-0001  done   2/3      5.0 s  2026-01-02 10:00  Water carries out a-0001."), std::string::npos
    ) << text;
    EXPECT_NE(text_of(runs, 60).find("…"), std::string::npos);
    EXPECT_EQ(json_of(runs).at(0).at("verdict").at(0), "Water carries out a-0001.");
    EXPECT_EQ(json_of(runs).at(0).at("samples").at("total"), 3);
    EXPECT_TRUE(json_of(runs).at(0).at("until").is_null());
}

TEST(RunList, SaysWithWhichStageARunWasToEnd) {
    const test::TempFolder folder;
    add_run(folder, "a", "2026-01-02T10:00:00Z", 5, {{"until", "initial"}, {"missing_stages", {"s/erosion"}}});
    const std::vector<ListedRun> runs = list_runs(folder.path(), RunOrder::Name);
    EXPECT_NE(text_of(runs, 200).find("a    done   2/3 until initial  5.0 s"), std::string::npos) << text_of(runs, 200);
    EXPECT_EQ(json_of(runs).at(0).at("until"), "initial");
}

} // namespace
} // namespace suffuse::job
