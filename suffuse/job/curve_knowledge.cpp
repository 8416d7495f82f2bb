#include "suffuse/job/curve_knowledge.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/student.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace suffuse::job {
namespace {

using calibration::Curve;
using calibration::Point;

constexpr std::size_t points_of_information = 100; // of the posterior

Point own_point(const std::vector<int>& unknowns, const Point& point) {
    Point chosen;
    chosen.reserve(unknowns.size());
    for (const int k : unknowns) {
        chosen.push_back(point[static_cast<std::size_t>(k)]);
    }
    return chosen;
}

/// Root mean square of half the differences between runs of the same unknowns.
Curve scatter_between(const std::vector<Point>& points, const std::vector<Curve>& curves) {
    Curve squares(curves.front().size(), 0.0);
    int pairs = 0;
    for (std::size_t a = 0; a < points.size(); ++a) {
        for (std::size_t b = a + 1; b < points.size(); ++b) {
            pairs += points[a] == points[b] ? 1 : 0;
            for (std::size_t k = 0; points[a] == points[b] && k < squares.size(); ++k) {
                squares[k] += 0.5 * std::pow(curves[a][k] - curves[b][k], 2);
            }
        }
    }
    for (double& value : squares) {
        value = std::sqrt(value / std::max(pairs, 1));
    }
    return pairs > 0 ? squares : Curve{};
}

} // namespace

void CurveKnowledge::learn(const std::vector<SampleCurve>& curves) {
    targets_.clear();
    for (std::size_t t = 0; t < what_.spec.targets.size(); ++t) {
        if (!what_.spec.targets[t].is_held_out) {
            targets_.push_back(known_of(static_cast<int>(t), curves));
        }
    }
    fit_all();
}

void CurveKnowledge::fit_all() {
    std::vector<calibration::FittedTest> tests;
    for (const Known& known : targets_) {
        tests.push_back(known.test);
    }
    fit_.emplace(tests);
}

double CurveKnowledge::log_likelihood(const Point& point) const {
    double sum = fit_->log_likelihood(point);
    for (const Known& known : targets_) {
        sum += std::log(known.feasibility.chance(own_point(known.test.unknowns, point)));
    }
    return sum;
}

double CurveKnowledge::uncertainty(const Point& point) const {
    double sum = 0;
    for (const Known& known : targets_) {
        sum += known.test.emulator.variance(own_point(known.test.unknowns, point)) - 1;
    }
    return std::sqrt(sum);
}

bool CurveKnowledge::is_allowed(const Point& point) const {
    std::vector<double> values;
    for (std::size_t k = 0; k < point.size(); ++k) {
        values.push_back(casefile::value_at(what_.spec.unknowns[k], point[k]));
    }
    return std::ranges::all_of(what_.spec.constraints, [&](const casefile::CalibrateConstraint& constraint) {
        return casefile::meets(constraint, what_.spec, values);
    });
}

calibration::Posterior CurveKnowledge::posterior(double share, int samples) const {
    return calibration::sample_posterior(
        {.dimensions = static_cast<int>(what_.spec.unknowns.size()),
         .log_likelihood = [this](const Point& point) { return log_likelihood(point); },
         .is_allowed = [this](const Point& point) { return is_allowed(point); },
         .share = share,
         .seed = what_.seed,
         .samples = samples}
    );
}

void CurveKnowledge::measure_all(const Point& point) {
    for (Known& known : targets_) {
        known.test.measured = all_parts(known, point);
    }
    fit_all();
}

std::vector<calibration::Interval> CurveKnowledge::intervals(const std::vector<Point>& samples) const {
    std::vector<calibration::Interval> intervals = calibration::intervals_of(samples);
    std::vector<Point> some;
    const std::size_t step = std::max<std::size_t>(1, samples.size() / points_of_information);
    for (std::size_t k = 0; k < samples.size(); k += step) {
        some.push_back(samples[k]);
    }
    const std::vector<double> of_data =
        calibration::information_of_data(some, [this](const Point& point) { return fit_->information(point); });
    for (std::size_t k = 0; k < intervals.size(); ++k) {
        intervals[k].information = std::min(intervals[k].information, of_data[k]);
    }
    return intervals;
}

std::vector<TargetFit> CurveKnowledge::fits(const Point& best) const {
    std::vector<TargetFit> fits;
    for (const Known& known : targets_) {
        const Point own = own_point(known.test.unknowns, best);
        TargetFit fit{target_of(known.target),
                      laboratory_[static_cast<std::size_t>(known.target)],
                      {},
                      {},
                      {},
                      known.samples,
                      known.failed};
        const calibration::CurveEmulator& emulator = known.test.emulator;
        fit.band = student_90(static_cast<std::size_t>(emulator.degrees_of_freedom()));
        const Curve mean = emulator.mean(own);
        const double variance = emulator.variance(own);
        for (const int k : fit.laboratory.rows) {
            fit.model.push_back(mean[static_cast<std::size_t>(k)]);
            fit.model_deviation.push_back(std::sqrt(variance * emulator.row_variance(k)));
            if (!known.seed_scatter.empty()) {
                fit.seed_scatter.push_back(known.seed_scatter[static_cast<std::size_t>(k)]);
            }
        }
        fits.push_back(std::move(fit));
    }
    return fits;
}

/// Those that this target depends on: not the void ratios of others.
std::vector<int> CurveKnowledge::unknowns_of(int target) const {
    const int own = casefile::void_ratio_of(what_.spec, target_of(target));
    std::vector<int> chosen;
    for (int k = 0; k < std::ssize(what_.spec.unknowns); ++k) {
        if (k == own || !casefile::is_void_ratio(what_.spec.unknowns[static_cast<std::size_t>(k)].key)) {
            chosen.push_back(k);
        }
    }
    return chosen;
}

CurveKnowledge::Known CurveKnowledge::known_of(int target, const std::vector<SampleCurve>& curves) const {
    const std::vector<int> unknowns = unknowns_of(target);
    std::vector<Point> succeeded, failed;
    std::vector<Curve> of_success;
    std::vector<int> runs;
    std::string failure;
    for (const SampleCurve& one : curves) {
        if (one.sample.target != target) {
            continue;
        }
        Point own = own_point(unknowns, one.sample.shares);
        if (one.curve.empty()) {
            failed.push_back(std::move(own));
            failure = failure.empty() ? one.failure : failure;
        } else {
            succeeded.push_back(std::move(own));
            runs.push_back(one.sample.number);
            of_success.push_back(one.curve);
        }
    }
    const auto all = static_cast<int>(succeeded.size() + failed.size()), lost = static_cast<int>(failed.size());
    if (all - lost < least_successes) {
        throw StateError(fmt::format(
            "target \"{}\": {} of {} samples succeeded, and a fit needs {}; change the ranges of `unknowns`, or give "
            "more `samples`. The first that failed: {}",
            target_of(target).name, all - lost, all, least_successes, failure
        ));
    }
    const LaboratoryCurve& curve = laboratory_[static_cast<std::size_t>(target)];
    calibration::FittedTest test{
        calibration::CurveEmulator(succeeded, of_success),
        std::move(runs),
        unknowns,
        {curve.rows, curve.values, curve.deviations, curve.begins, target_of(target).weight}};
    Curve scatter = scatter_between(succeeded, of_success);
    return {target,
            std::move(test),
            std::move(scatter),
            calibration::Feasibility(std::move(succeeded), std::move(failed)),
            all,
            lost};
}

calibration::Measurement CurveKnowledge::all_parts(const Known& known, const Point& point) const {
    const Curve mean = known.test.emulator.mean(own_point(known.test.unknowns, point));
    const LaboratoryCurve& curve = laboratory_[static_cast<std::size_t>(known.target)];
    const auto n = curve.form.grid.size();
    const auto begin = [&](std::size_t part) { return mean.begin() + static_cast<std::ptrdiff_t>(part * n); };
    calibration::Measurement measurement{{}, mean, {}, {}, target_of(known.target).weight};
    for (std::size_t part = 0; part < curve.form.parts.size(); ++part) {
        const double deviation =
            deviation_of(curve.form.parts[part], {begin(part), begin(part + 1)}, target_of(known.target).scatter);
        measurement.deviations.insert(measurement.deviations.end(), n, deviation);
        if (part > 0) {
            measurement.begins.push_back(static_cast<int>(part * n));
        }
        for (std::size_t k = 0; k < n; ++k) {
            measurement.rows.push_back(static_cast<int>(part * n + k));
        }
    }
    return measurement;
}

} // namespace suffuse::job
