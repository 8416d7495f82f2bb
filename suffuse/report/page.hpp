#pragma once
// The report of a run: one HTML file that opens offline from `file:` and makes no request. With the page's script
// (built from the report/ folder by npm) its figures are charts; without it the report is plain and says what is
// missing. Next to it, `figures/` holds each figure's numbers as CSV and its chart as a Vega-Lite specification.

#include "suffuse/answer/opening.hpp"
#include "suffuse/figures/figure.hpp"
#include "suffuse/figures/page_table.hpp"
#include "suffuse/report/quality.hpp"
#include "suffuse/report/scene.hpp"
#include "suffuse/study/finding.hpp"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace suffuse::report {

/// A value that the paper does not give, or the soil's investigation: a choice, marked `#~` in the case.
struct AssumedValue {
    std::string key, value, note;
};

/// What the run lacks: it was interrupted, failed in part, was to end early, or is still under way.
struct Unfinished {
    std::string missing; ///< in words, with the names of stages; empty: nothing
    std::string command; ///< with which it goes on
};

/// What a citation names besides the paper.
struct CitedProgram {
    std::string version, commit;
    bool names_run = false; ///< seed and hash of a case stand in the provenance
};

/// One call of the program that computed something for the run, or wrote its report.
struct Call {
    std::string command, finished, program; ///< program: version and commit
    double seconds = 0;
};

/// Lines to copy, such as a block for a case.
struct TextBlock {
    std::string section, title;
    std::string text;
};

struct ReportData {
    std::string title;           ///< of the case
    std::string project, author; ///< as the case gives them; may be empty
    std::string run;             ///< name of the run folder
    std::string request;         ///< soil, pressure and gradient of the case, for who reads it on paper; may be empty
    std::string paper;           ///< that the case follows; empty: none, and the page speaks of none
    Unfinished unfinished;
    answer::Opening opening;         ///< the answer in one look
    std::vector<std::string> answer; ///< in sentences with all numbers, folded
    std::vector<study::Finding> findings;
    std::vector<std::string> flaws; ///< what makes a result worth less: stated in the opening
    std::vector<std::string> warnings;
    std::vector<std::string> case_warnings; ///< of the check of the case, before anything ran
    std::vector<AssumedValue> assumed;
    /// Each stands before the figures of its section.
    std::vector<figures::PageTable> tables;
    std::vector<TextBlock> texts;         ///< each after the figures of its section
    std::vector<figures::Figure> figures; ///< in the order in which they are shown
    Scene scene;                          ///< without states: no section "In 3D"
    std::vector<StageRow> stages;
    std::vector<std::pair<std::string, std::string>> provenance; ///< version, commit, seed, threads, hashes, times
    std::vector<Call> calls;                                     ///< oldest first
    CitedProgram cited;
    std::string redraw; ///< the command that builds this report again
};

struct WrittenReport {
    std::filesystem::path file;
    bool has_charts = false;          ///< false: plain, for want of the page's script
    std::vector<std::string> figures; ///< names of the files in figures/
};

/// Writes `figures/ID.csv` and `figures/ID.vl.json` (or `ID.svg`), and the scene's still pictures,
/// `figures/own-grains-K.png`. @return their names. Throws IoError, naming the file.
std::vector<std::string> write_figures(const std::filesystem::path& run_folder, const ReportData& report);

/// Writes `run_folder/report.html`. `page_folder` is where page/build.sh left the page's script; empty or without it,
/// the report is plain. Throws IoError, naming the file.
WrittenReport write_page(
    const std::filesystem::path& run_folder, const ReportData& report, const std::filesystem::path& page_folder = {}
);

/// Both.
WrittenReport write_report(
    const std::filesystem::path& run_folder, const ReportData& report, const std::filesystem::path& page_folder = {}
);

/// A page of the scene alone, for a notebook: its view in 3D where the page's script is there, else still pictures.
std::string scene_page(const std::string& title, const Scene& scene, const std::filesystem::path& page_folder);

} // namespace suffuse::report
