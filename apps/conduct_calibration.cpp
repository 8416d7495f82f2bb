#include "apps/conduct_calibration.hpp"

#include "suffuse/base/amounts.hpp"
#include "suffuse/base/error.hpp"
#include "suffuse/base/render_within.hpp"
#include "suffuse/base/shell_word.hpp"
#include "suffuse/base/stopwatch.hpp"
#include "suffuse/casefile/bind.hpp"
#include "suffuse/io/folders.hpp"
#include "suffuse/job/calibrate.hpp"
#include "suffuse/job/calibration_files.hpp"
#include "suffuse/job/calibration_folder.hpp"
#include "suffuse/job/calibration_report.hpp"
#include "suffuse/job/calibration_words.hpp"
#include "suffuse/job/run_folder.hpp"
#include "suffuse/job/verify_calibration.hpp"
#include "suffuse/plan/plan.hpp"
#include "suffuse/record/folder.hpp"

#include <fmt/format.h>

#include "apps/conduct_job.hpp"
#include "apps/exit_code.hpp"
#include "apps/json_text.hpp"
#include "apps/page_folder.hpp"
#include "apps/stop_signal.hpp"
#include <algorithm>

namespace suffuse::apps {
namespace {

namespace fs = std::filesystem;

Job job_of(const CalibrationJob& calibration, const casefile::Case& samples, const fs::path& folder) {
    Job job{.memory = calibration.memory, .command = calibration.command, .what = samples, .folder = folder};
    job.case_text = casefile::resolved_toml(samples);
    job.cache = calibration.cache;
    job.cache_owners = calibration.cache_owners;
    return job;
}

/// Runs a round, what is left of it. @return false where it was stopped
bool run_round(
    const CalibrationJob& calibration, const job::CalibrationRound& round, const Stopwatch& watch,
    const Console& console
) {
    record::open_folder(round.folder, round.samples, casefile::resolved_toml(round.samples));
    if (job::is_round_done(round)) {
        return true;
    }
    Job job = job_of(calibration, round.samples, round.folder);
    job.time_limit = calibration.time_limit - watch.seconds();
    if (!fs::exists(calibration.folder / job::calibration_file)) { // later its report shows the fit so far
        job.live = calibration.folder;
    }
    job.plan = plan_rest(job);
    console.talk(fmt::format(
        "{:10} {}: {}", round.name, plural(std::ssize(round.samples.studies), "sample"), plan::plan_sentence(job.plan)
    ));
    return conduct_samples(job, console);
}

std::string bound_text(const job::ParameterResult& p) {
    switch (p.interval.bound) {
    case calibration::Bound::None:
        return "";
    case calibration::Bound::Low:
        return fmt::format("at its lower bound {}: lower it", job::shown_value(p.unknown, p.unknown.least));
    case calibration::Bound::High:
        break;
    }
    return fmt::format("at its upper bound {}: raise it", job::shown_value(p.unknown, p.unknown.most));
}

void print_parameters(const job::CalibrationResult& result, const Console& console) {
    std::size_t width = 0;
    for (const job::ParameterResult& p : result.parameters) {
        width = std::max(width, p.unknown.key.size());
    }
    console.result(fmt::format("{:{}}  {:>12}  {:>12}  90 % interval", "parameter", width, "likeliest", "mean"));
    for (const job::ParameterResult& p : result.parameters) {
        std::string note = p.interval.is_identified() ? "" : "not identified";
        if (p.unknown.is_log) {
            note += std::string(note.empty() ? "" : ", ") + "geometric mean";
        }
        if (const std::string bound = bound_text(p); !bound.empty()) {
            note += (note.empty() ? "" : ", ") + bound;
        }
        console.result(fmt::format(
            "{:{}}  {:>12}  {:>12}  {} to {}{}", p.unknown.key, width, job::shown_value(p.unknown, p.best),
            job::shown_value(p.unknown, p.mean), job::shown_value(p.unknown, p.low),
            job::shown_value(p.unknown, p.high), note.empty() ? "" : "   " + note
        ));
    }
    for (const job::ParameterResult& p : result.parameters) {
        if (p.remedy != job::Remedy::None) {
            console.result(
                fmt::format("{} is not identified by these tests; add {}", p.unknown.key, job::words_of(p.remedy))
            );
        }
    }
    for (std::size_t a = 0; a < result.correlations.size(); ++a) {
        for (std::size_t b = a + 1; b < result.correlations.size(); ++b) {
            if (std::abs(result.correlations[a][b]) > 0.7) {
                console.result(fmt::format(
                    "{} and {} are correlated, {:.2f}: the tests fix their combination better than each of them",
                    result.parameters[a].unknown.key, result.parameters[b].unknown.key, result.correlations[a][b]
                ));
            }
        }
    }
}

void print_fits(const job::CalibrationResult& result, const Console& console) {
    for (const job::TargetFit& fit : result.fits) {
        std::string text;
        for (std::size_t part = 0; part < fit.laboratory.form.measured.size() && !fit.model.empty(); ++part) {
            text += fmt::format(
                "{}{} {:.1f} %", text.empty() ? "" : ", ", job::key_of(fit.laboratory.form.measured[part]),
                100 * job::relative_misfit(fit, part)
            );
        }
        console.result(fmt::format(
            "{} {}: misfit {}; {} of {} failed", fit.target.is_held_out ? "held out" : "fit", fit.target.name,
            text.empty() ? "unknown" : text + " of the largest value", fit.failed, plural(fit.samples, "sample")
        ));
    }
}

/// The files of the answer, and its report.
void write_answer(
    const CalibrationJob& calibration, const casefile::CalibrationCase& what, const job::CalibrationResult& result
) {
    job::write_calibration(calibration.folder, what, result);
    job::write_calibration_report(calibration.folder, page_folder());
}

int print_answer(const CalibrationJob& job, const job::CalibrationResult& result, const Console& console) {
    const int code = result.is_complete ? static_cast<int>(Done)
                     : stop_flag()      ? signal_exit_code()
                                        : static_cast<int>(OutOfTime);
    if (!result.is_complete) {
        console.talk(fmt::format(
            "stopped {}; suffuse resume {} continues",
            result.parameters.empty() ? "before its first round ended" : "early: this is the answer so far",
            shell_word(job.folder.string())
        ));
    }
    if (!result.parameters.empty()) {
        print_parameters(result, console);
        print_fits(result, console);
        console.result(fmt::format("{} ({})", job::calibration_caution, job::calibration_caution_page));
        console.result(fmt::format("for a case: {}", (job.folder / "contact.toml").string()));
        console.result(fmt::format("report: {}", (job.folder / "report.html").string()));
    }
    return code;
}

/// Of the samples and of the records.
std::vector<Diagnostic> all_warnings(const casefile::CalibrationCase& what) {
    std::vector<Diagnostic> all = what.warnings, of_records = job::warnings_of_records(what);
    all.insert(all.end(), of_records.begin(), of_records.end());
    return all;
}

} // namespace

int check_calibration(const CalibrationJob& calibration, const Console& console) {
    const casefile::CalibrationCase what =
        casefile::load_calibration(calibration.case_file, {{}, calibration.overrides, {}});
    job::first_round(what); // which reads the files
    const auto targets = std::ssize(what.spec.targets), unknowns = std::ssize(what.spec.unknowns);
    const std::vector<Diagnostic> warnings = all_warnings(what);
    nlohmann::json problems = nlohmann::json::array();
    for (const Diagnostic& warning : warnings) {
        problems.push_back(problem_json(warning));
    }
    if (!warnings.empty() && !console.wants_json()) {
        console.talk(render_within(warnings, console.has_color(), source_width()));
    }
    console.result(fmt::format(
        "{}: no errors; {}, {}; suffuse calibrate {} runs it", calibration.case_file, plural(targets, "target"),
        plural(unknowns, "unknown"), shell_word(calibration.case_file)
    ));
    console.document(json_text(
        {{"case", calibration.case_file},
         {"errors", 0},
         {"warnings", warnings.size()},
         {"problems", std::move(problems)},
         {"targets", targets},
         {"unknowns", unknowns}}
    ));
    return Done;
}

int price_calibration(const CalibrationJob& calibration, const Console& console) {
    const casefile::CalibrationCase what =
        casefile::load_calibration(calibration.case_file, {{}, calibration.overrides, {}});
    const casefile::Case samples = job::first_round(what);
    const plan::RunPlan plan = plan_rest(job_of(calibration, samples, {}));
    const auto fitted = std::ranges::count(what.spec.targets, false, &casefile::CalibrateTarget::is_held_out);
    const double share = static_cast<double>(what.spec.samples * fitted) / static_cast<double>(samples.studies.size());
    const Range all{plan.seconds.least * share, plan.seconds.most * share};
    console.result(fmt::format("first round: {}", plan::plan_sentence(plan)));
    console.result(fmt::format(
        "all rounds, at most {} of each target: {}", plural(what.spec.samples, "sample"), duration_range_text(all)
    ));
    console.document(
        json_text({{"first_round", plan}, {"seconds", {all.least, all.most}}, {"samples", what.spec.samples * fitted}})
    );
    return Done;
}

int conduct_calibration(const CalibrationJob& calibration, const Console& console) {
    const casefile::CalibrationCase what =
        casefile::load_calibration(calibration.case_file, {{}, calibration.overrides, {}});
    job::keep_calibration_case(calibration.case_file, what, calibration.folder);
    if (const std::vector<Diagnostic> warnings = all_warnings(what); !warnings.empty()) {
        console.talk(render_within(warnings, console.has_color(), source_width()));
    }
    const Stopwatch watch;
    const fs::path checksums = calibration.folder / record::checksums_file;
    job::CalibrationOptions options{calibration.folder, {}};
    options.run = [&](const job::CalibrationRound& round) { return run_round(calibration, round, watch, console); };
    if (!fs::exists(checksums)) { // else a whole answer is there, and stays until the same one is written again
        options.on_round = [&](const job::CalibrationResult& so_far) { write_answer(calibration, what, so_far); };
    }
    const job::CalibrationResult result = job::calibrate(what, options);
    io::remove_file(checksums); // true no more
    record::keep_provenance(calibration.folder, job::first_round(what), calibration.command, watch.seconds());
    if (!result.parameters.empty()) {
        write_answer(calibration, what, result);
        if (result.is_complete) {
            job::write_calibration_sums(calibration.folder);
        }
        console.document(json_text(job::calibration_json(what, result)));
    }
    return print_answer(calibration, result, console);
}

} // namespace suffuse::apps
