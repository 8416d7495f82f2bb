// The report of whole runs: Figures 1 to 6 from a small study over the fines content, and the same files from the same
// case.

#include <gtest/gtest.h>

#include "tests/support/run_text.hpp"
#include <algorithm>
#include <map>
#include <regex>
#include <sstream>

namespace suffuse::test {
namespace {

using nlohmann::json;

const std::string fines_sweep = mixed_soil + R"(
[study.s]
soil       = "mixture"
particles  = 250
sweep      = { fines_content = ["0 %", "20 %", "100 %"] }
replicates = 2
[[study.s.stage]]
name     = "cloud"
do       = "pack"
porosity = 0.62
[[study.s.stage]]
name     = "loose"
do       = "compact"
protocol = "swift"
pressure = "100 kPa" #~
prepare  = { adhesion = { normal = "1 MPa", shear = "1 MPa" } }
[[study.s.stage]]
name     = "dense"
from     = "cloud"
do       = "compact"
protocol = "swift"
pressure = "100 kPa"
prepare  = { friction = "10 deg" }
[[study.s.stage]]
name   = "Shear_dense"
do     = "triaxial"
strain = "1 %"
only   = { fines_content = ["20 %"] }
[[study.s.stage]]
name   = "shear"
from   = "loose"
do     = "triaxial"
strain = "1 %"
only   = { fines_content = ["0 %", "20 %"] }
)";

/// Rows of a figure's CSV, by column name without unit.
std::vector<std::map<std::string, std::string>> rows_of(const std::filesystem::path& csv) {
    std::ifstream file(csv);
    std::vector<std::string> names;
    std::vector<std::map<std::string, std::string>> rows;
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with('#')) {
            continue;
        }
        std::vector<std::string> fields;
        std::stringstream all(line);
        for (std::string field; std::getline(all, field, ',');) {
            fields.push_back(field);
        }
        fields.resize(std::max(fields.size(), names.size()));
        if (names.empty()) {
            for (const std::string& heading : fields) {
                names.push_back(heading.substr(0, heading.find(" [")));
            }
            continue;
        }
        auto& row = rows.emplace_back();
        for (std::size_t c = 0; c < names.size(); ++c) {
            row[names[c]] = fields[c];
        }
    }
    return rows;
}

TEST(StudyReport, FiguresOneToSixHoldTheNumbersOfTheStages) {
    const TempFolder folder;
    run::RunOptions options;
    options.case_text = reference_constants + fines_sweep;
    run_text(options.case_text, folder.path(), options);
    const std::filesystem::path figures = folder / "run/figures";
    for (const char* id : {"fig01", "fig02", "fig03", "fig04", "fig05", "fig06", "own-triaxial-s-shear-dense"}) {
        EXPECT_TRUE(std::filesystem::exists(figures / (std::string(id) + ".vl.json"))) << id;
    }
    double e_g = 0, e_min = 0, active = 0, mixed = 0, strong = 0;
    for (const int seed : {1, 2}) {
        const std::string sample = fmt::format("fc=20/rep={}/", seed);
        const json loose = stage_of(folder.path(), sample + "loose");
        e_g += loose.at("intergranular_void_ratio").get<double>() / 2;
        e_min += stage_of(folder.path(), sample + "dense").at("void_ratio").get<double>() / 2;
        active += loose.at("active_fines_fraction").get<double>() / 2;
        mixed += loose.at("contact_share").at("LS").get<double>() / 2;
        strong += loose.at("strong_contact_share").at("LS").get<double>() / 2;
    }
    const auto shown = [&](const char* id, const char* column, const char* quantity) {
        for (const auto& row : rows_of(figures / (std::string(id) + ".csv"))) {
            if (row.at("fines_content") == "20" && row.at("quantity").find(quantity) != std::string::npos) {
                EXPECT_EQ(row.at("samples"), "2");
                return std::stod(row.at(column));
            }
        }
        return std::nan("");
    };
    EXPECT_NEAR(shown("fig03", "void_ratio", "e_g"), e_g, 1e-12); // rounding, here and below
    EXPECT_NEAR(shown("fig03", "void_ratio", "e_min"), e_min, 1e-12);
    EXPECT_NEAR(shown("fig04", "active_fines", "b"), active, 1e-12);
    EXPECT_NEAR(shown("fig05", "share_of_contacts", "LS"), 100 * mixed, 1e-10);
    EXPECT_NEAR(shown("fig06", "strong_share", "LS"), 100 * strong, 1e-10);
    std::map<std::string, double> last_strain;
    for (const auto& row : rows_of(figures / "fig02.csv")) {
        last_strain[row.at("test")] = std::stod(row.at("axial_strain"));
    }
    ASSERT_EQ(last_strain.size(), 2U) << "fines contents that were sheared";
    for (const auto& [test, strain] : last_strain) {
        EXPECT_NEAR(strain, 1, 0.05) << test; // rows stand up to a burst of steps apart
    }
    const std::string page = read_all(folder / "run/report.html");
    for (const char* words :
         {"id=\"fines-and-structure\"", "Question: from which fines content", "study.s, stage loose: pressure",
          "Strength and deformation", "Equilibrium of each stage"}) {
        EXPECT_NE(page.find(words), std::string::npos) << words;
    }
    // The case follows no paper: what the paper found is for those who ask the summary.
    const json summary = record::read_json(folder / "run/summary.json");
    EXPECT_FALSE(summary.at("findings").empty());
    EXPECT_EQ(page.find("he paper"), std::string::npos);
    EXPECT_TRUE(summary.at("missing_stages").empty());
    EXPECT_EQ(page.find("not complete"), std::string::npos);
    // 250 grains make a narrow cell, of which only the terminal spoke.
    ASSERT_FALSE(summary.at("case_warnings").empty());
    EXPECT_EQ(summary.at("case_warnings").at(0).at("code"), "W602");
    EXPECT_GT(page.find("W602: "), page.find("<section id=\"quality\""));
}

TEST(StudyReport, OfGrainsThatJustTouchAndCarryNothingIsWritten) {
    const TempFolder folder;
    std::ofstream packing(folder / "lattice.csv");
    packing << "x,y,z,r\n";
    for (int k = 0; k < 64; ++k) {
        packing << fmt::format("{},{},{},0.001\n", 0.002 * (k % 4), 0.002 * (k / 4 % 4), 0.002 * (k / 16));
    }
    packing.close();
    run_text(
        reference_constants + "[study.s]\n[[study.s.stage]]\nname = \"start\"\ndo = \"import\"\n" +
            "packing = \"lattice.csv\"\ncell = [\"8 mm\", \"8 mm\", \"8 mm\"]\n" +
            "[[study.s.stage]]\nname = \"flow\"\ndo = \"flow\"\ngradient = 0.01\n",
        folder.path()
    );
    const json start = stage_of(folder.path(), "start");
    ASSERT_GT(start.at("contacts"), 0);
    ASSERT_EQ(start.at("mean_stress"), 0);
    EXPECT_EQ(start.at("unbalanced_force"), 0);
    for (const char* made : {"summary.json", "report.html", "SHA256SUMS"}) {
        EXPECT_TRUE(std::filesystem::exists(folder / "run" / made)) << made;
    }
}

TEST(StudyReport, OfARunThatWasToEndEarlySaysThatItDidAndTheSummaryWhichStagesAreMissing) {
    const TempFolder folder;
    run::RunOptions options;
    options.until = "cloud";
    run_text(reference_constants + fines_sweep, folder.path(), options);
    const json missing = record::read_json(folder / "run/summary.json").at("missing_stages");
    EXPECT_EQ(missing.size(), 2U * (3 + 4 + 2)) << missing; // of two seeds at 0, 20 and 100 %
    EXPECT_EQ(missing.at(0), "s/fc=0/rep=1/loose");
    const std::string page = read_all(folder / "run/report.html");
    EXPECT_NE(page.find("The run ended with stage cloud, as requested"), std::string::npos);
    EXPECT_EQ(page.find("<b>This run is not complete.</b> "), std::string::npos);
}

/// What may differ between two runs of one case: times, and where the run lies.
std::string without_times(std::string text) {
    for (const char* section : {"quality", "provenance"}) {
        const std::size_t begin = text.find(std::string("<section id=\"") + section + "\"");
        if (begin != std::string::npos) {
            text.erase(begin, text.find("</section>", begin) - begin);
        }
    }
    static const std::regex times(
        "# (wall_seconds|finished|command)[^\n]*|<dt>Date</dt><dd>[^<]*|<p class=\"kick\">[^<]*"
    );
    return std::regex_replace(text, times, "# time");
}

TEST(StudyReport, TwoRunsOfOneCaseDifferInTimesOnly) {
    const TempFolder first, second;
    for (const TempFolder* folder : {&first, &second}) {
        run::RunOptions options;
        options.folder = *folder / "run";
        job::run_case(casefile::load_case_text(reference_constants + fines_sweep, "case.toml", "/").value, options);
    }
    std::size_t compared = 0;
    for (const auto& entry : std::filesystem::directory_iterator(first / "run/figures")) {
        const std::filesystem::path other = second / "run/figures" / entry.path().filename();
        EXPECT_EQ(without_times(read_all(entry.path())), without_times(read_all(other))) << other.filename();
        ++compared;
    }
    EXPECT_GE(compared, 12U);
    const auto page = [](const TempFolder& folder) {
        const std::string own = folder.path().string();
        std::string html = without_times(read_all(folder / "run/report.html"));
        for (std::size_t at = html.find(own); at != std::string::npos; at = html.find(own)) {
            html.erase(at, own.size());
        }
        return html;
    };
    EXPECT_EQ(page(first), page(second));
}

TEST(StudyReport, SamplesThatDifferInTheirSeedAreReportedTogether) {
    const std::string study = mixed_soil + R"(
[study.s]
soil       = "mixture"
particles  = 250
replicates = 2
[[study.s.stage]]
name     = "cloud"
do       = "pack"
[[study.s.stage]]
name     = "dense"
do       = "compact"
protocol = "swift"
pressure = "100 kPa"
[[study.s.stage]]
name   = "shear"
do     = "triaxial"
strain = "0.5 %"
[[study.s.stage]]
name   = "pressed"
do     = "triaxial"
path   = "constant-deviator"
strain = "0.2 %"
[[study.s.stage]]
name       = "probed"
from       = "dense"
do         = "stress-probe"
directions = 4
)";
    const TempFolder folder;
    run_text(reference_constants + study, folder.path());
    double work = 0;
    std::vector<double> peak;
    for (const int seed : {1, 2}) {
        const std::string sample = fmt::format("rep={}/", seed);
        work += stage_of(folder.path(), sample + "probed").at("stress_probes")[1].at("normalized").get<double>() / 2;
        peak.push_back(
            stage_of(folder.path(), sample + "shear").at("response").at("peak_deviator").get<double>() / 1e3
        );
    }
    const auto rows = rows_of(folder / "run/figures/own-stress-probes.csv");
    ASSERT_EQ(rows.size(), 5U); // four directions, and the first again
    EXPECT_EQ(rows[1].at("samples"), "2");
    EXPECT_NEAR(std::stod(rows[1].at("normalized_work")), work, 1e-12); // rounding
    const std::string page = read_all(folder / "run/report.html");
    EXPECT_NE(page.find("probed: stable in all 4 directions of load"), std::string::npos);
    EXPECT_NE(page.find("“pressed”: with the deviator stress held, an excess pore pressure of"), std::string::npos);
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "run/figures/own-pore-pressure.csv"));
    std::sort(peak.begin(), peak.end());
    const std::size_t begin = page.find("triaxial compression: "),
                      end = page.find("\u00a0kPa (2 samples) in “shear”.", begin);
    ASSERT_NE(end, std::string::npos);
    std::istringstream reported(page.substr(begin, end - begin));
    double lowest = 0, highest = 0;
    std::string word;
    reported >> word >> word >> lowest >> word >> highest;
    EXPECT_NEAR(lowest, peak[0], 0.1) << reported.str(); // the text has four digits
    EXPECT_NEAR(highest, peak[1], 0.1) << reported.str();
}

} // namespace
} // namespace suffuse::test
