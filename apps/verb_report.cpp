// report: the report of a run once more, without computing.

#include "suffuse/job/calibration_files.hpp"
#include "suffuse/job/calibration_folder.hpp"
#include "suffuse/job/calibration_report.hpp"
#include "suffuse/job/print_report.hpp"
#include "suffuse/job/run_case.hpp"
#include "suffuse/job/run_folder.hpp"
#include "suffuse/job/verify_calibration.hpp"
#include "suffuse/record/checksums.hpp"
#include "suffuse/record/finished_stages.hpp"
#include "suffuse/record/folder.hpp"

#include "apps/exit_code.hpp"
#include "apps/json_text.hpp"
#include "apps/page_folder.hpp"
#include "apps/run_ending.hpp"
#include "apps/shared_options.hpp"
#include "apps/verb.hpp"
#include "apps/verbs.hpp"
#include <filesystem>
#include <memory>

namespace suffuse::apps {
namespace {

namespace fs = std::filesystem;

struct ReportVerb final : Verb {
    ReportVerb()
        : Verb("report", "write the report of a run again, without computing", "suffuse report runs/dyke-0001") {}

    std::string run;
    bool prints = false;

    void add_to(Options& options) override {
        options.argument("DIR", run, folder_text).required();
        options.flag("--pdf", prints, "also print it, to report.pdf next to it; needs Chromium");
    }

    [[nodiscard]] int act(const CommandLine& line, const Console& console) const override;
};

/// Prints the report where that is requested, and names it in the document.
void print_pdf(const fs::path& report, nlohmann::json& document, const Console& console) {
    const fs::path pdf = fs::path(report).replace_extension(".pdf");
    job::print_report(report, pdf);
    console.result(pdf.string());
    document["pdf"] = pdf.string();
}

int report_calibration(const ReportVerb& verb, const Console& console) {
    const job::FolderLock lock(verb.run, console.warner());
    const fs::path folder = verb.run;
    for (const char* read : {job::calibration_file, job::posterior_file}) {
        record::require_same_result(folder, read);
    }
    const fs::path report = job::write_calibration_report(folder, page_folder());
    if (fs::exists(folder / record::checksums_file)) {
        job::write_calibration_sums(folder);
    }
    console.result("written: " + report.string());
    nlohmann::json document = {{"report", report.string()}};
    if (verb.prints) {
        print_pdf(report, document, console);
    }
    console.document(json_text(document));
    return Done;
}

int ReportVerb::act(const CommandLine& line, const Console& console) const {
    const fs::path folder = run;
    if (job::is_calibration(folder)) {
        return report_calibration(*this, console);
    }
    record::check_is_run(folder); // before the lock, which would leave a file there
    const job::FolderLock lock(folder, console.warner());
    const std::string doubts = record::require_whole_run(folder);
    if (!doubts.empty()) {
        console.talk("warning: " + doubts);
    }
    const job::RunReport report = job::rebuild_report(folder, page_folder(), line.typed);
    print_results(report, "written", console);
    nlohmann::json document = {
        {"report", report.report.string()},
        {"warnings", report.warnings},
        {"flaws", report.flaws},
        {"findings", report.findings}};
    if (prints) {
        print_pdf(report.report, document, console);
    }
    console.document(json_text(document));
    return exit_code_of(report);
}

} // namespace

MadeVerb make_report_verb() {
    return std::make_unique<ReportVerb>();
}

} // namespace suffuse::apps
