#include "suffuse/job/curve_knowledge.hpp"

#include "suffuse/base/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace suffuse::job {
namespace {

using calibration::Curve;
using calibration::Point;

constexpr double range_of_errors = 3; // of a laboratory's, in rows of the grid

} // namespace

void CurveKnowledge::learn(const std::vector<SampleCurve>& curves) {
    targets_.clear();
    for (std::size_t t = 0; t < what_.spec.targets.size(); ++t) {
        if (!what_.spec.targets[t].is_held_out) {
            targets_.push_back(known_of(static_cast<int>(t), curves));
        }
    }
}

double CurveKnowledge::log_likelihood(const Point& point) const {
    double sum = 0;
    for (const Known& known : targets_) {
        const Point own = own_point(known.target, point);
        sum += known.fit.log_likelihood(own) + std::log(known.feasibility.chance(own));
    }
    return sum / static_cast<double>(targets_.size());
}

double CurveKnowledge::uncertainty(const Point& point) const {
    double sum = 0;
    for (const Known& known : targets_) {
        sum += known.emulator.variance(own_point(known.target, point)) - 1;
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
        known.fit = calibration::CurveFit(known.emulator, all_parts(known, point));
    }
}

std::vector<TargetFit> CurveKnowledge::fits(const Point& best) const {
    std::vector<TargetFit> fits;
    for (const Known& known : targets_) {
        const Point own = own_point(known.target, best);
        TargetFit fit{target_of(known.target),
                      laboratory_[static_cast<std::size_t>(known.target)],
                      {},
                      {},
                      known.samples,
                      known.failed};
        const Curve mean = known.emulator.mean(own);
        const double variance = known.emulator.variance(own);
        for (const int k : fit.laboratory.rows) {
            fit.model.push_back(mean[static_cast<std::size_t>(k)]);
            fit.model_deviation.push_back(std::sqrt(variance * known.emulator.row_covariance(k, k)));
        }
        fits.push_back(std::move(fit));
    }
    return fits;
}

/// The unknowns that this target depends on: not the void ratios of others.
Point CurveKnowledge::own_point(int target, const Point& point) const {
    const int own = casefile::void_ratio_of(what_.spec, target_of(target));
    Point chosen;
    for (std::size_t k = 0; k < point.size(); ++k) {
        if (static_cast<int>(k) == own || !casefile::is_void_ratio(what_.spec.unknowns[k].key)) {
            chosen.push_back(point[k]);
        }
    }
    return chosen;
}

CurveKnowledge::Known CurveKnowledge::known_of(int target, const std::vector<SampleCurve>& curves) const {
    std::vector<Point> succeeded, failed;
    std::vector<Curve> of_success;
    std::string failure;
    for (const SampleCurve& one : curves) {
        if (one.sample.target != target) {
            continue;
        }
        Point own = own_point(target, one.sample.shares);
        if (one.curve.empty()) {
            failed.push_back(std::move(own));
            failure = failure.empty() ? one.failure : failure;
        } else {
            succeeded.push_back(std::move(own));
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
    const calibration::CurveEmulator emulator(succeeded, of_success);
    const LaboratoryCurve& curve = laboratory_[static_cast<std::size_t>(target)];
    const calibration::Measurement measured{
        curve.rows, curve.values, calibration::correlated_errors(curve.deviations, curve.begins, range_of_errors),
        target_of(target).weight};
    return {
        target,
        emulator,
        calibration::CurveFit(emulator, measured),
        calibration::Feasibility(std::move(succeeded), std::move(failed)),
        all,
        lost};
}

calibration::Measurement CurveKnowledge::all_parts(const Known& known, const Point& point) const {
    const Curve mean = known.emulator.mean(own_point(known.target, point));
    const LaboratoryCurve& curve = laboratory_[static_cast<std::size_t>(known.target)];
    const auto n = curve.form.grid.size();
    const auto begin = [&](std::size_t part) { return mean.begin() + static_cast<std::ptrdiff_t>(part * n); };
    calibration::Measurement measurement{{}, mean, {}, target_of(known.target).weight};
    Curve deviations;
    std::vector<int> begins;
    for (std::size_t part = 0; part < curve.form.parts.size(); ++part) {
        const double deviation =
            deviation_of(curve.form.parts[part], {begin(part), begin(part + 1)}, target_of(known.target).scatter);
        deviations.insert(deviations.end(), n, deviation);
        begins.push_back(static_cast<int>(part * n));
        for (std::size_t k = 0; k < n; ++k) {
            measurement.rows.push_back(static_cast<int>(part * n + k));
        }
    }
    measurement.covariance = calibration::correlated_errors(deviations, begins, range_of_errors);
    return measurement;
}

} // namespace suffuse::job
