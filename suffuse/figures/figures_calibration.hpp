#pragma once
// What a calibration found: intervals in their ranges, fits of curves, the posterior of each pair, misfits of samples.

#include "suffuse/figures/figure.hpp"

#include <optional>
#include <string>
#include <vector>

namespace suffuse::figures {

struct CalibratedParameter {
    std::string name;                   ///< in words: "rolling friction"
    std::string field;                  ///< of a column: "contact_rolling_friction"
    std::string unit;                   ///< of the numbers; empty for a ratio
    double best = 0, low = 0, high = 0; ///< likeliest; 90 % interval
    double least = 0, most = 1;         ///< the range of the case
    bool is_log = false;                ///< all decades of it are as likely
    bool is_identified = true;

    /// Where a value is in the range [%]
    [[nodiscard]] double place(double value) const;
};

/// One quantity of one test.
struct CalibratedCurve {
    std::string target, quantity;                 ///< "low"; "q/p₀"
    std::string x_title;                          ///< "axial strain [%]"
    std::vector<double> x, measured, model, band; ///< in the units of the figure; half of a 90 % band, or missing
    double relative_misfit = 0;
};

struct CalibrationSampleFit {
    std::string target, round;
    double misfit = missing;    ///< [-]; missing: it failed
    std::vector<double> values; ///< one a parameter, in its unit
};

Figure calibration_intervals(const std::vector<CalibratedParameter>& parameters);

/// @param are_held_out tests that were predicted, not fitted
std::optional<Figure> calibration_fits(const std::vector<CalibratedCurve>& curves, bool are_held_out);

/// @param posterior a row a sample, a value a parameter in its unit; some of the rows are drawn
std::optional<Figure> calibration_corner(
    const std::vector<CalibratedParameter>& parameters, const std::vector<std::vector<double>>& posterior
);

std::optional<Figure> calibration_misfits(
    const std::vector<CalibratedParameter>& parameters, const std::vector<CalibrationSampleFit>& samples
);

} // namespace suffuse::figures
