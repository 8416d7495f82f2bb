// The mean curve of the seeds of a test, and how far they lie apart, at the strains of the first of them.
#include "suffuse/study/response_curve.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace suffuse::study {
namespace {

using Member = double StressStrainRow::*;

constexpr std::array<Member, 6> members = {&StressStrainRow::axial_strain,    &StressStrainRow::volumetric_strain,
                                           &StressStrainRow::deviator_stress, &StressStrainRow::mean_stress,
                                           &StressStrainRow::void_ratio,      &StressStrainRow::excess_pore_pressure};

/// The row at a strain within the range of `rows`, along which `strain_of` increases.
template <class StrainOf>
StressStrainRow row_at(const std::vector<StressStrainRow>& rows, double strain, const StrainOf& strain_of) {
    const auto above =
        std::lower_bound(rows.begin(), rows.end(), strain, [&](const StressStrainRow& row, double value) {
            return strain_of(row) < value;
        });
    if (above == rows.begin() || above == rows.end()) {
        return above == rows.end() ? rows.back() : rows.front();
    }
    const StressStrainRow &b = *above, &a = *(above - 1);
    const double t = (strain - strain_of(a)) / (strain_of(b) - strain_of(a));
    StressStrainRow row;
    for (const Member m : members) {
        row.*m = a.*m + t * (b.*m - a.*m);
    }
    return row;
}

} // namespace

ResponseCurve average_response(
    const std::string& name, const std::vector<std::vector<StressStrainRow>>& of_sample, bool holds_deviator
) {
    std::vector<std::vector<StressStrainRow>> tests = of_sample;
    std::erase_if(tests, [](const auto& rows) { return rows.empty(); });
    const bool extends = !holds_deviator && !tests.empty() && tests[0].back().axial_strain < 0;
    const auto strain_of = [&](const StressStrainRow& row) {
        const double axial = extends ? -row.axial_strain : row.axial_strain;
        return holds_deviator ? std::max(axial, axial - row.volumetric_strain) : axial;
    };
    ResponseCurve mean{name, {}};
    mean.samples = static_cast<int>(tests.size());
    if (tests.empty()) {
        return mean;
    }
    double reach = strain_of(tests[0].back());
    for (const auto& rows : tests) {
        reach = std::min(reach, strain_of(rows.back()));
    }
    const double n = static_cast<double>(tests.size());
    for (const StressStrainRow& at : tests[0]) {
        if (strain_of(at) > reach) {
            break;
        }
        StressStrainRow sum, squares;
        for (const auto& rows : tests) {
            const StressStrainRow row = row_at(rows, strain_of(at), strain_of);
            for (const Member m : members) {
                sum.*m += row.*m / n;
            }
        }
        for (const auto& rows : tests) {
            const StressStrainRow row = row_at(rows, strain_of(at), strain_of);
            for (const Member m : members) {
                squares.*m += (row.*m - sum.*m) * (row.*m - sum.*m);
            }
        }
        mean.rows.push_back(sum);
        if (tests.size() > 1) {
            for (const Member m : members) {
                squares.*m = std::sqrt(squares.*m / (n - 1));
            }
            mean.deviation.push_back(squares);
        }
    }
    return mean;
}

} // namespace suffuse::study
