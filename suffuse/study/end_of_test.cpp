#include "suffuse/study/end_of_test.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace suffuse::study {
namespace {

// Samples of 2,500 grains scatter as much by chance over a tenth of strain in their critical state. Before it dense
// ones dilate by 0.2 and more, and loose ones contract.
constexpr double most_dilation = 0.1;
constexpr double most_drift = 0.25;

using triaxial::PathRow;

/// Mean, and slope over the axial strain by least squares.
struct Line {
    double mean = 0, slope = 0;
};

Line fit_line(const std::vector<PathRow>& rows, std::size_t first, const auto& number) {
    const auto count = static_cast<double>(rows.size() - first);
    double x = 0, y = 0, xx = 0, xy = 0;
    for (std::size_t k = first; k < rows.size(); ++k) {
        const double strain = rows[k].axial_strain - rows[first].axial_strain, value = number(rows[k]);
        x += strain, y += value, xx += strain * strain, xy += strain * value;
    }
    const double spread = count * xx - x * x;
    return {y / count, spread > 0 ? (count * xy - x * y) / spread : 0};
}

} // namespace

bool EndOfTest::is_critical() const {
    return std::abs(dilation) <= most_dilation && std::abs(drift) <= most_drift;
}

std::optional<EndOfTest> end_of_test(const std::vector<PathRow>& rows) {
    if (rows.empty() || rows.back().axial_strain < 2 * critical_window) {
        return std::nullopt;
    }
    const double begin = rows.back().axial_strain - critical_window;
    const auto at = std::ranges::find_if(rows, [begin](const PathRow& row) { return row.axial_strain >= begin; });
    const auto first = static_cast<std::size_t>(at - rows.begin());
    const Line q = fit_line(rows, first, [](const PathRow& row) { return row.deviator_stress; });
    const Line volume = fit_line(rows, first, [](const PathRow& row) { return row.volumetric_strain; });
    const Line ratio = fit_line(rows, first, [](const PathRow& row) {
        return row.mean_stress > 0 ? row.deviator_stress / row.mean_stress : 0;
    });
    EndOfTest end;
    end.deviator = q.mean;
    end.mean_ratio = ratio.mean;
    end.void_ratio = fit_line(rows, first, [](const PathRow& row) { return row.void_ratio; }).mean;
    end.dilation = -volume.slope;
    end.drift = q.mean > 0 ? q.slope * critical_window / q.mean : 0;
    return end;
}

double deviator_at(const std::vector<PathRow>& rows, double axial_strain) {
    const auto after = std::ranges::find_if(rows, [&](const PathRow& row) { return row.axial_strain >= axial_strain; });
    if (after == rows.end() || after == rows.begin()) {
        return after == rows.end() ? std::numeric_limits<double>::quiet_NaN() : after->deviator_stress;
    }
    const PathRow &a = *(after - 1), &b = *after;
    const double share = (axial_strain - a.axial_strain) / (b.axial_strain - a.axial_strain);
    return (1 - share) * a.deviator_stress + share * b.deviator_stress;
}

} // namespace suffuse::study
