#include "suffuse/job/calibrate.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/student.hpp"
#include "suffuse/calibration/next_designs.hpp"
#include "suffuse/job/curve_knowledge.hpp"
#include "suffuse/record/folder.hpp"
#include "suffuse/record/samples.hpp"
#include "suffuse/record/stored_findings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace suffuse::job {
namespace {

using calibration::Point;
using casefile::CalibrationSample;

constexpr int rounds_after_first = 2;
constexpr double spread_of_designs = 0.5; // share of the log likelihood that counts where the next samples are sought
constexpr int held_out_samples = 8;
constexpr int designs_for_repeated = 8; // of so many of the first round one is simulated again, with other grains
constexpr int may_fail = 4;             // of a first round, however small
constexpr int samples_of_answer = 2000, samples_of_search = 500; // of the posterior

struct Design {
    int number = 0; ///< from 1
    Point point;
};

/// The curves of the samples of a round, from the folder of its run.
std::vector<SampleCurve> read_curves(
    const casefile::CalibrationCase& what, const std::vector<LaboratoryCurve>& laboratory,
    const CalibrationRound& round, const std::vector<CalibrationSample>& samples
) {
    std::map<std::string, std::string> failures; // study -> message
    for (const record::FailedSample& failure : record::read_failures(round.folder, round.samples)) {
        failures[failure.sample.substr(0, failure.sample.find('/'))] = failure.message;
    }
    std::vector<SampleCurve> curves;
    curves.reserve(samples.size());
    for (std::size_t k = 0; k < samples.size(); ++k) {
        SampleCurve one{samples[k], {}, {}};
        const casefile::Variant& variant = round.samples.studies.at(k).variants.at(0);
        const std::filesystem::path stage = record::stage_folder(round.folder, variant, variant.stages.back());
        if (const auto failed = failures.find(round.samples.studies[k].name); failed != failures.end()) {
            one.failure = failed->second;
        } else {
            const auto target = static_cast<std::size_t>(samples[k].target);
            one.curve =
                simulated_curve(record::read_findings(stage).curve, laboratory[target].form, what.spec.targets[target]);
        }
        curves.push_back(std::move(one));
    }
    return curves;
}

std::vector<CalibrationSample>
samples_of(const casefile::CalibrationCase& what, const std::vector<Design>& designs, bool held_out) {
    std::vector<CalibrationSample> samples;
    for (const Design& design : designs) {
        for (std::size_t t = 0; t < what.spec.targets.size(); ++t) {
            if (what.spec.targets[t].is_held_out == held_out) {
                samples.push_back({static_cast<int>(t), design.number, design.point});
            }
        }
    }
    return samples;
}

/// Half of them, and so many that a few may fail.
int designs_of_first(const casefile::CalibrateSpec& spec) {
    return std::min(spec.samples, std::max(least_successes + may_fail, (spec.samples + 1) / 2));
}

/// Even over the allowed part of the ranges. The last ones repeat some of the others: they differ by their grains
/// alone.
std::vector<Design> first_designs(const casefile::CalibrationCase& what, const CurveKnowledge& knowledge) {
    std::vector<Design> designs;
    const int dimensions = static_cast<int>(what.spec.unknowns.size());
    const int repeated = designs_of_first(what.spec) / designs_for_repeated;
    const int wanted = designs_of_first(what.spec) - repeated;
    constexpr std::uint32_t most_tries = 100'000;
    for (std::uint32_t k = 0; static_cast<int>(designs.size()) < wanted; ++k) {
        if (k == most_tries) {
            throw CaseError("[calibrate]: almost no point of the ranges meets `constraints`; widen the ranges");
        }
        Point point = calibration::design_points(k, 1, dimensions, what.seed).front();
        if (knowledge.is_allowed(point)) {
            designs.push_back({static_cast<int>(designs.size()) + 1, std::move(point)});
        }
    }
    for (int k = 0; k < repeated; ++k) {
        designs.push_back({wanted + k + 1, designs[static_cast<std::size_t>(k * wanted / repeated)].point});
    }
    return designs;
}

double mean_width(const std::vector<calibration::Interval>& intervals) {
    double sum = 0;
    for (const calibration::Interval& interval : intervals) {
        sum += interval.width;
    }
    return sum / static_cast<double>(intervals.size());
}

std::vector<LaboratoryCurve> read_targets(casefile::CalibrationCase& what) {
    std::vector<LaboratoryCurve> curves;
    for (casefile::CalibrateTarget& target : what.spec.targets) {
        curves.push_back(read_laboratory_curve(target));
        const std::vector<double>& grid = curves.back().form.grid;
        if (target.test == casefile::CalibrateTest::Oedometer) {
            target.largest_stress = grid.back();
        } else {
            target.strain = grid.back();
        }
    }
    return curves;
}

/// The work of one call.
class Calibration {
public:
    Calibration(const casefile::CalibrationCase& what, const CalibrationOptions& options)
        : what_(what), options_(options), laboratory_(read_targets(what_)), knowledge_(what_, laboratory_) {}

    CalibrationResult run() {
        std::vector<Design> designs = first_designs(what_, knowledge_);
        int left = what_.spec.samples - static_cast<int>(designs.size());
        for (int round = 1; round <= 1 + rounds_after_first && !designs.empty(); ++round) {
            if (!run_round(fmt::format("round-{}", round), round, designs, false)) {
                return result_; // of the rounds before
            }
            knowledge_.learn(curves_);
            const double width = judge();
            if (options_.on_round) {
                options_.on_round(result_);
            }
            const bool is_last = result_.rounds.size() > 1 &&
                                 calibration::has_settled(result_.rounds[result_.rounds.size() - 2].width, width);
            const int rounds_left = 1 + rounds_after_first - round;
            const int count = is_last || rounds_left == 0 ? 0 : left / rounds_left;
            designs = more_designs(count);
            left -= count;
        }
        result_.is_complete = predict_held_out();
        find_remedies();
        return std::move(result_);
    }

private:
    bool run_round(const std::string& name, int number, const std::vector<Design>& designs, bool held_out) {
        const std::vector<CalibrationSample> samples = samples_of(what_, designs, held_out);
        CalibrationRound round{
            name, number, 1 + rounds_after_first, casefile::case_of_samples(what_, samples), options_.folder / name};
        round.samples.title = fmt::format("{}: {}", what_.title.empty() ? "calibration" : what_.title, name);
        if (!options_.run(round)) {
            return false;
        }
        RoundResult done{static_cast<int>(designs.size()), static_cast<int>(samples.size())};
        std::vector<SampleCurve> curves = read_curves(what_, laboratory_, round, samples);
        done.failed = static_cast<int>(std::ranges::count_if(curves, [](const auto& c) { return c.curve.empty(); }));
        for (record::FailedSample& failure : record::read_failures(round.folder, round.samples)) {
            result_.failures.push_back(std::move(failure));
        }
        keep_fits(name, curves);
        for (const Design& design : designs) {
            known_points_.push_back(design.point);
        }
        (held_out ? held_out_ : curves_).insert((held_out ? held_out_ : curves_).end(), curves.begin(), curves.end());
        result_.rounds.push_back(done);
        return true;
    }

    void keep_fits(const std::string& round, const std::vector<SampleCurve>& curves) {
        for (const SampleCurve& one : curves) {
            const auto target = static_cast<std::size_t>(one.sample.target);
            SampleFit& fit = result_.samples.emplace_back();
            fit.round = round;
            fit.target = what_.spec.targets[target].name;
            fit.design = one.sample.number;
            fit.values = casefile::values_of(what_, one.sample);
            if (!one.curve.empty()) {
                fit.misfit = misfit_of(one.curve, laboratory_[target]);
            } else {
                fit.failure = one.failure.empty() ? "its curve ends before that of the test" : one.failure;
            }
        }
    }

    /// What the parameters are now. @return the mean width of their intervals
    double judge() {
        const calibration::Posterior posterior = knowledge_.posterior(1, samples_of_answer);
        const std::vector<calibration::Interval> intervals = knowledge_.intervals(posterior.samples);
        samples_ = posterior.samples;
        best_ = posterior.best;
        result_.parameters.clear();
        for (std::size_t k = 0; k < intervals.size(); ++k) {
            const casefile::CalibrateUnknown& unknown = what_.spec.unknowns[k];
            const auto at = [&](double share) { return casefile::value_at(unknown, share); };
            result_.parameters.push_back(
                {unknown, at(intervals[k].mean), at(intervals[k].low), at(intervals[k].high), at(best_[k]),
                 intervals[k]}
            );
        }
        result_.correlations = calibration::correlations_of(posterior.samples);
        result_.effective_samples = posterior.effective;
        result_.log_likelihood = posterior.best_log_likelihood;
        result_.posterior.clear();
        for (const Point& sample : posterior.samples) {
            std::vector<double>& row = result_.posterior.emplace_back();
            for (std::size_t k = 0; k < sample.size(); ++k) {
                row.push_back(casefile::value_at(what_.spec.unknowns[k], sample[k]));
            }
        }
        result_.fits = knowledge_.fits(best_);
        result_.rounds.back().width = mean_width(intervals);
        result_.rounds.back().parameters = result_.parameters;
        return result_.rounds.back().width;
    }

    std::vector<Design> more_designs(int count) {
        std::vector<Design> designs;
        if (count > 0) {
            const std::vector<Point> points = calibration::next_designs(
                knowledge_.posterior(spread_of_designs, samples_of_search).samples, count, known_points_,
                [&](const Point& point) { return knowledge_.uncertainty(point); }
            );
            for (const Point& point : points) {
                designs.push_back({static_cast<int>(known_points_.size() + designs.size()) + 1, point});
            }
        }
        return designs;
    }

    /// Runs the held-out tests with samples of the posterior. @return false where it was stopped
    bool predict_held_out() {
        std::vector<Design> designs;
        const std::size_t step = samples_.size() / held_out_samples;
        for (std::size_t k = 0; k < held_out_samples; ++k) {
            designs.push_back({static_cast<int>(k) + 1, samples_[k * step]});
        }
        if (samples_of(what_, designs, true).empty()) {
            return true;
        }
        if (!run_round("held-out", 1 + rounds_after_first, designs, true)) {
            return false;
        }
        result_.rounds.pop_back();
        for (std::size_t t = 0; t < what_.spec.targets.size(); ++t) {
            if (what_.spec.targets[t].is_held_out) {
                result_.fits.push_back(prediction_of(static_cast<int>(t)));
            }
        }
        return true;
    }

    [[nodiscard]] TargetFit prediction_of(int target) const {
        TargetFit fit{
            what_.spec.targets[static_cast<std::size_t>(target)], laboratory_[static_cast<std::size_t>(target)]};
        const std::vector<int>& rows = fit.laboratory.rows;
        std::vector<double> sum(rows.size(), 0), squares(rows.size(), 0);
        int count = 0;
        for (const SampleCurve& one : held_out_) {
            if (one.sample.target != target) {
                continue;
            }
            ++fit.samples;
            fit.failed += one.curve.empty() ? 1 : 0;
            count += one.curve.empty() ? 0 : 1;
            for (std::size_t k = 0; !one.curve.empty() && k < rows.size(); ++k) {
                const double value = one.curve[static_cast<std::size_t>(rows[k])];
                sum[k] += value;
                squares[k] += value * value;
            }
        }
        fit.band = next_sample_90(static_cast<std::size_t>(count));
        for (std::size_t k = 0; count > 0 && k < rows.size(); ++k) {
            const double mean = sum[k] / count;
            fit.model.push_back(mean);
            fit.model_deviation.push_back(
                count > 1 ? std::sqrt(std::max(0.0, (squares[k] - count * mean * mean) / (count - 1))) : 0.0
            );
        }
        return fit;
    }

    /// Whether samples of the same parameters differ by more than half of the variance of all errors.
    [[nodiscard]] bool samples_scatter() const {
        double balance = 0;
        for (const TargetFit& fit : result_.fits) {
            for (std::size_t k = 0; k < fit.seed_scatter.size(); ++k) { // no held-out test has it
                balance += std::pow(fit.seed_scatter[k] / fit.model_deviation[k], 2) - 0.5;
            }
        }
        return balance > 0;
    }

    /// For intervals that are wide: what a laboratory could measure. The strains of its tests are tried on the
    /// emulators; other tests follow what LABORATORY's table of the validation shows.
    void find_remedies() {
        const auto is_wide = [](const ParameterResult& p) { return !p.interval.is_identified(); };
        if (std::ranges::none_of(result_.parameters, is_wide)) {
            return;
        }
        std::vector<calibration::Interval> with_all;
        const bool lacks_parts = std::ranges::any_of(laboratory_, [](const LaboratoryCurve& curve) {
            return curve.form.measured.size() < curve.form.parts.size();
        });
        if (lacks_parts) {
            CurveKnowledge supposed = knowledge_;
            supposed.measure_all(best_);
            with_all = supposed.intervals(supposed.posterior(1, samples_of_search).samples);
        }
        const auto& targets = what_.spec.targets;
        const bool is_one_pressure = std::ranges::all_of(targets, [&](const casefile::CalibrateTarget& target) {
            return target.pressure == targets.front().pressure || target.is_held_out;
        });
        for (std::size_t k = 0; k < result_.parameters.size(); ++k) {
            ParameterResult& parameter = result_.parameters[k];
            if (is_wide(parameter)) {
                parameter.remedy = lacks_parts && with_all[k].is_identified() ? Remedy::VolumetricStrain
                                   : is_one_pressure                          ? Remedy::OtherPressure
                                   : samples_scatter()                        ? Remedy::LargerSamples
                                                                              : Remedy::Oedometer;
            }
        }
    }

    casefile::CalibrationCase what_;
    const CalibrationOptions& options_;
    std::vector<LaboratoryCurve> laboratory_;
    CurveKnowledge knowledge_;
    std::vector<SampleCurve> curves_, held_out_;
    std::vector<Point> known_points_, samples_;
    Point best_;
    CalibrationResult result_;
};

} // namespace

CalibrationResult calibrate(const casefile::CalibrationCase& what, const CalibrationOptions& options) {
    return Calibration(what, options).run();
}

std::vector<Diagnostic> warnings_of_records(const casefile::CalibrationCase& what) {
    Problems problems;
    std::set<std::string> texts;
    const auto warn = [&](const casefile::CalibrateTarget& target, const std::string& text, const char* help) {
        if (texts.insert(target.file + text).second) {
            const std::string name = std::filesystem::path(target.file).filename().string();
            problems.warning("W623", target.place, fmt::format("{}: {}", name, text), help);
        }
    };
    for (const casefile::CalibrateTarget& target : what.spec.targets) {
        const LaboratoryCurve curve = read_laboratory_curve(target);
        for (const laboratory::Finding& finding : curve.findings) {
            if (finding.is_assumed) {
                warn(target, "assumed: " + finding.text, "write it into the heading of the column if it is so");
            }
        }
        if (!curve.unread.empty()) {
            warn(
                target, fmt::format("not read: \"{}\"", fmt::join(curve.unread, "\", \"")),
                "docs/laboratory-tests.md has the words of headings; columns that say nothing of the test may stay"
            );
        }
    }
    return problems.sorted();
}

casefile::Case first_round(casefile::CalibrationCase what) {
    const std::vector<LaboratoryCurve> laboratory = read_targets(what);
    return casefile::case_of_samples(
        what, samples_of(what, first_designs(what, CurveKnowledge(what, laboratory)), false)
    );
}

} // namespace suffuse::job
