#include "suffuse/triaxial/laboratory_numbers.hpp"

#include "suffuse/triaxial/path_loading.hpp"
#include "suffuse/triaxial/response.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace suffuse::triaxial {
namespace {

constexpr double first_loading_span = 3.1622776601683795; // half a decade

/// Whether a stress grew by more than a test may be off.
bool has_grown(double from, double to) {
    return to > (1 + good_hold_error) * from;
}

using Branch = std::vector<const PathRow*>;

/// -de/dlog10 of the axial stress, by least squares: one slope of all branches, each about its own mean, for between
/// two of them the sample was compressed. Nothing where the stress is the same throughout each.
std::optional<double> index_of(const std::vector<Branch>& branches, int axis) {
    double spread = 0, together = 0;
    for (const Branch& branch : branches) {
        double x = 0, y = 0, xx = 0, xy = 0;
        double least = std::numeric_limits<double>::infinity(), most = 0;
        for (const PathRow* row : branch) {
            const double stress = std::log10(row->stress(axis, axis));
            least = std::min(least, row->stress(axis, axis)), most = std::max(most, row->stress(axis, axis));
            x += stress, y += row->void_ratio, xx += stress * stress, xy += stress * row->void_ratio;
        }
        const auto count = static_cast<double>(branch.size());
        if (has_grown(least, most)) {
            spread += xx - x * x / count;
            together += xy - x * y / count;
        }
    }
    return spread > 0 ? std::optional(-together / spread) : std::nullopt;
}

double ratio_of(const TriaxialSpec& spec, const PathRow& row) {
    const double normal = row.stress(spec.shear_axes.normal, spec.shear_axes.normal);
    return normal > 0 ? shear_stress(spec, row.stress) / normal : 0;
}

} // namespace

CompressionNumbers compression_numbers(const TriaxialSpec& spec, const std::vector<PathRow>& rows) {
    const auto axial = [&](const PathRow& row) { return row.stress(spec.axis, spec.axis); };
    const PathRow& highest = *std::ranges::max_element(rows, {}, axial);
    Branch loads;
    std::vector<Branch> unloads; // each from where it turns
    bool falls = false;
    double most = 0;
    for (std::size_t k = 0; k < rows.size(); ++k) {
        if (axial(rows[k]) > most && axial(rows[k]) * first_loading_span >= axial(highest)) {
            loads.push_back(&rows[k]); // reloading below the highest stress of before is none
        }
        most = std::max(most, axial(rows[k]));
        const bool fell = falls;
        falls = k > 0 && axial(rows[k]) < axial(rows[k - 1]);
        if (falls && !fell) {
            unloads.push_back({&rows[k - 1]});
        }
        if (falls) {
            unloads.back().push_back(&rows[k]);
        }
    }
    CompressionNumbers numbers;
    if (spec.path != Path::Isotropic && has_grown(axial(rows.front()), axial(highest))) {
        numbers.k0 = lateral_mean(highest.stress, spec.axis) / axial(highest);
    }
    numbers.compression_index = index_of({loads}, spec.axis);
    numbers.swelling_index = index_of(unloads, spec.axis);
    return numbers;
}

ShearNumbers shear_numbers(const TriaxialSpec& spec, const std::vector<PathRow>& rows) {
    constexpr double liquefied = 0.05; // of the mean stress of the start
    const auto carries = [&](const PathRow& row) { return row.mean_stress >= liquefied * rows.front().mean_stress; };
    const PathRow* peak = &rows.front();
    for (const PathRow& row : rows) {
        if (carries(row) && ratio_of(spec, row) > ratio_of(spec, *peak)) {
            peak = &row;
        }
    }
    const auto [normal, along] = spec.shear_axes;
    ShearNumbers numbers;
    numbers.shear_stress = shear_stress(spec, peak->stress);
    numbers.normal_stress = peak->stress(normal, normal);
    numbers.peak_stress_ratio = ratio_of(spec, *peak);
    numbers.peak_shear_strain = peak->shear_strain;
    numbers.final_stress_ratio = ratio_of(spec, rows.back());
    numbers.rotation = 0.5 * std::atan2(2 * numbers.shear_stress, numbers.normal_stress - peak->stress(along, along));
    return numbers;
}

CyclicNumbers cyclic_numbers(const TriaxialSpec& spec, const std::vector<PathRow>& rows) {
    CyclicNumbers numbers;
    const double lateral = lateral_mean(rows.front().stress, spec.axis);
    const PathRow* turn = &rows.front();
    for (std::size_t k = 1; k < rows.size(); ++k) {
        if (rows[k].leg != rows[k - 1].leg) {
            turn = &rows[k - 1];
        }
        numbers.pore_pressure_ratio = std::max(numbers.pore_pressure_ratio, rows[k].excess_pore_pressure / lateral);
        numbers.double_amplitude =
            std::max(numbers.double_amplitude, std::abs(rows[k].axial_strain - turn->axial_strain));
    }
    const bool liquefied = numbers.pore_pressure_ratio >= spec.cycles->pore_pressure_ratio ||
                           numbers.double_amplitude >= spec.cycles->double_amplitude;
    numbers.cycles = 0.5 * (rows.back().leg + 1);
    if (liquefied) {
        numbers.cycles_to_liquefaction = numbers.cycles;
    }
    return numbers;
}

} // namespace suffuse::triaxial
