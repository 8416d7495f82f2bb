#pragma once
// A case as text, run in a folder of its own: what scenarios that go through the whole program share.

#include "suffuse/casefile/load_case.hpp"
#include "suffuse/facts/by_key.hpp"
#include "suffuse/facts/every_fact.hpp"
#include "suffuse/figures/figure_guide.hpp"
#include "suffuse/job/run_case.hpp"
#include "suffuse/record/folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/reference.hpp"
#include "tests/support/temp_folder.hpp"
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>

namespace suffuse::test {

inline std::string text_of(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

/// Grain, contact, balance and fluid of the reference's section 4.
inline const std::string reference_constants = R"(
schema = 1
title  = "scenario"
[grain]
density = "2600 kg/m^3"
[contact]
law               = "linear-rolling"
modulus           = "356 MPa"
shear_ratio       = 0.42
friction          = "37 deg"
rolling_stiffness = 7.5
rolling_friction  = 0.22
damping           = 0.2
[balance]
unbalanced_force = 1e-3
stress_error     = "0.1 %"
patience         = 500
[fluid]
density   = "1000 kg/m^3"
viscosity = "1 mPa*s"
)";

/// The reference's Fontainebleau-like sand, fines below 0.26 mm.
inline std::string reference_soil() {
    return "[soil.sand]\npsd = \"" + in_checkout("examples/fontainebleau-2016/data/fontainebleau.csv") +
           "\"\nfines = { finer_than = \"0.26 mm\" }\n";
}

/// Two narrow fractions of size ratio 2, so that a few hundred grains are a sample.
inline const std::string mixed_soil = R"(
[soil.mixture]
coarse            = { psd = { d = ["0.28 mm", "0.32 mm"], passing = ["0 %", "100 %"] } }
fines             = { psd = { d = ["0.14 mm", "0.16 mm"], passing = ["0 %", "100 %"] } }
fines_content     = "0 %"
grading_tolerance = "10 %"
)";

/// The first two stages of a study of "sand": a cloud, and "initial" at 100 kPa.
inline const std::string cloud_and_initial = R"(
[[study.s.stage]]
name     = "cloud"
do       = "pack"
porosity = 0.62
[[study.s.stage]]
name     = "initial"
do       = "compact"
pressure = "100 kPa"
prepare  = { friction = "10 deg" }
)";

/// A study that starts from one of the reference's packings, settled at 100 kPa in the stage "settled".
inline std::string study_of_packing(const std::string& name) {
    const nlohmann::json about = record::read_json(in_checkout("tests/reference/" + name + ".json"));
    std::string edges;
    for (const double edge : about.at("cell")) {
        edges += (edges.empty() ? "\"" : ", \"") + fmt::format("{} m", edge) + "\"";
    }
    return "[study.s]\nsoil = \"sand\"\n[[study.s.stage]]\nname = \"start\"\ndo = \"import\"\npacking = \"" +
           in_checkout("tests/reference/" + name + ".csv.gz") + "\"\ncell = [" + edges +
           "]\n[[study.s.stage]]\nname = \"settled\"\ndo = \"settle\"\npressure = \"100 kPa\"\n";
}

/// Every key of an object of stage.json, and of those within it, has its row in suffuse/facts.
inline void expect_facts(const nlohmann::json& numbers, const std::string& within) {
    static const std::set<std::string> objects = [] {
        std::set<std::string> names{"probes"};
        for (const facts::Group& group : facts::every_group()) {
            names.insert(group.within);
        }
        return names;
    }();
    for (const auto& [key, value] : numbers.items()) {
        const std::string whole = within.empty() ? key : within + "." + key;
        const bool is_known = facts::is_fact(key) || facts::is_fact(whole) || within == "measured";
        const bool is_object = value.is_object() || (value.is_array() && !value.empty() && value.front().is_object());
        EXPECT_TRUE(is_known || is_object) << whole << " has no row in suffuse/facts";
        if (is_object && (!is_known || objects.contains(key) || within == "measured")) {
            for (const nlohmann::json& part : value.is_array() ? value : nlohmann::json::array({value})) {
                expect_facts(part, key);
            }
        }
    }
}

inline job::RunReport
run_text(const std::string& text, const std::filesystem::path& folder, run::RunOptions options = {}) {
    const casefile::LoadedCase loaded = casefile::load_case_text(text, "scenario.toml", folder.string());
    options.folder = folder / "run";
    const job::RunReport report = job::run_case(loaded.value, options);
    for (const auto& entry : std::filesystem::recursive_directory_iterator(options.folder)) {
        const std::filesystem::path& file = entry.path();
        if (file.filename() == "stage.json") {
            expect_facts(record::read_json(file), "");
        } else if (file.extension() == ".csv" && file.parent_path().filename() == "figures") {
            EXPECT_TRUE(figures::explain_figure(file.stem().string())) << file << " has no row in figure_guide.cpp";
        }
    }
    return report;
}

inline nlohmann::json stage_of(const std::filesystem::path& folder, const std::string& stage) {
    return record::read_json(folder / "run" / "studies" / "s" / stage / "stage.json");
}

} // namespace suffuse::test
