#pragma once
// What the curves of a calibration's samples say after some rounds: an emulator of each target that is fitted, where
// its samples succeed, and how well it agrees with the laboratory.

#include "suffuse/calibration/curve_fit.hpp"
#include "suffuse/calibration/feasibility.hpp"
#include "suffuse/calibration/posterior.hpp"
#include "suffuse/job/calibrate.hpp"

#include <optional>
#include <vector>

namespace suffuse::job {

/// Curves of each target without which there is no fit.
inline constexpr int least_successes = 8;

class CurveKnowledge {
public:
    /// Refers to both as long as it lives.
    CurveKnowledge(const casefile::CalibrationCase& what, const std::vector<LaboratoryCurve>& laboratory)
        : what_(what), laboratory_(laboratory) {}

    /// From all curves that there are. @throws StateError where a target has too few
    void learn(const std::vector<SampleCurve>& curves);

    /// Of the fitted targets together, and of samples that succeed.
    [[nodiscard]] double log_likelihood(const calibration::Point& point) const;

    /// Deviation of the emulators over the scatter between samples.
    [[nodiscard]] double uncertainty(const calibration::Point& point) const;

    /// Whether the point meets the constraints.
    [[nodiscard]] bool is_allowed(const calibration::Point& point) const;

    /// @param share of the log likelihood that counts
    [[nodiscard]] calibration::Posterior posterior(double share, int samples) const;

    /// Of samples of the posterior. Their information is the smaller one of what the samples show and what the data say
    /// by themselves.
    [[nodiscard]] std::vector<calibration::Interval> intervals(const std::vector<calibration::Point>& samples) const;

    /// As if what no laboratory measured had been measured at `point`, with the scatter of the rest.
    void measure_all(const calibration::Point& point);

    /// Each fitted target at `best`.
    [[nodiscard]] std::vector<TargetFit> fits(const calibration::Point& best) const;

private:
    struct Known {
        int target;
        calibration::FittedTest test;
        calibration::Curve seed_scatter; ///< of each row, between runs of the same unknowns; empty without such runs
        calibration::Feasibility feasibility;
        int samples, failed;
    };

    [[nodiscard]] const casefile::CalibrateTarget& target_of(int target) const {
        return what_.spec.targets[static_cast<std::size_t>(target)];
    }

    [[nodiscard]] std::vector<int> unknowns_of(int target) const;
    [[nodiscard]] Known known_of(int target, const std::vector<SampleCurve>& curves) const;
    [[nodiscard]] calibration::Measurement all_parts(const Known& known, const calibration::Point& point) const;
    void fit_all();

    const casefile::CalibrationCase& what_;
    const std::vector<LaboratoryCurve>& laboratory_;
    std::vector<Known> targets_;
    std::optional<calibration::CurveFit> fit_; ///< of all targets
};

} // namespace suffuse::job
