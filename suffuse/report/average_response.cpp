// The mean curve of the seeds of a test, and how far they lie apart, at the strains of the first of them.
#include "suffuse/report/responses.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace suffuse::report {
namespace {

using Member = double StressStrainRow::*;

constexpr std::array<Member, 5> members = {
    &StressStrainRow::axial_strain, &StressStrainRow::volumetric_strain, &StressStrainRow::deviator_stress,
    &StressStrainRow::mean_stress, &StressStrainRow::void_ratio};

/// The row at an axial strain within the range of `rows`, which it increases along.
StressStrainRow row_at(const std::vector<StressStrainRow>& rows, double strain) {
    const auto above = std::lower_bound(rows.begin(), rows.end(), strain, [](const StressStrainRow& row, double value) {
        return row.axial_strain < value;
    });
    if (above == rows.begin() || above == rows.end()) {
        return above == rows.end() ? rows.back() : rows.front();
    }
    const StressStrainRow &b = *above, &a = *(above - 1);
    const double t = (strain - a.axial_strain) / (b.axial_strain - a.axial_strain);
    StressStrainRow row;
    for (const Member m : members) {
        row.*m = a.*m + t * (b.*m - a.*m);
    }
    return row;
}

} // namespace

ResponseCurve average_response(const std::string& name, const std::vector<std::vector<StressStrainRow>>& of_sample) {
    std::vector<std::vector<StressStrainRow>> tests = of_sample;
    std::erase_if(tests, [](const auto& rows) { return rows.empty(); });
    ResponseCurve mean{name, {}};
    mean.samples = static_cast<int>(tests.size());
    if (tests.empty()) {
        return mean;
    }
    double reach = tests[0].back().axial_strain;
    for (const auto& rows : tests) {
        reach = std::min(reach, rows.back().axial_strain);
    }
    const double n = static_cast<double>(tests.size());
    for (const StressStrainRow& at : tests[0]) {
        if (at.axial_strain > reach) {
            break;
        }
        StressStrainRow sum, squares;
        for (const auto& rows : tests) {
            const StressStrainRow row = row_at(rows, at.axial_strain);
            for (const Member m : members) {
                sum.*m += row.*m / n;
            }
        }
        for (const auto& rows : tests) {
            const StressStrainRow row = row_at(rows, at.axial_strain);
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

} // namespace suffuse::report
