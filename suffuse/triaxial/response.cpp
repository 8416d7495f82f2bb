#include "suffuse/triaxial/response.hpp"

#include "suffuse/triaxial/path_loading.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace suffuse::triaxial {

namespace {

constexpr double smoothed_span = 1e-3;   // axial strain over which rows are averaged before their work is looked at [-]
constexpr double least_smoothed = 2;     // rows
constexpr double liquefied_share = 0.05; // of the mean stress at the start [-]
constexpr double lost_hold_share = 0.2;  // of a held stress: servos of small samples let go of a tenth for a moment [-]
constexpr double lost_share = 0.05;      // of the deviator stress held: more of it is missing than a servo lets go [-]

/// Strains and stresses only.
PathRow mean_row(std::span<const PathRow> rows) {
    const double share = 1 / static_cast<double>(rows.size());
    PathRow mean;
    for (const PathRow& row : rows) {
        mean.axial_strain += share * row.axial_strain;
        mean.volumetric_strain += share * row.volumetric_strain;
        mean.mean_stress += share * row.mean_stress;
        mean.deviator_stress += share * row.deviator_stress;
    }
    return mean;
}

/// From the mean of some rows to that of as many after them, so that the noise of single rows is no instability.
std::optional<Instability> find_instability(std::span<const PathRow> rows) {
    const double strain = std::abs(rows.back().axial_strain - rows.front().axial_strain);
    const double wanted = std::ceil(smoothed_span / strain * static_cast<double>(rows.size() - 1));
    if (!(strain > 0) || 2 * wanted > static_cast<double>(rows.size())) {
        return {};
    }
    const auto span = static_cast<std::size_t>(std::max(least_smoothed, wanted));
    for (std::size_t k = span; k + span <= rows.size(); ++k) {
        if (second_order_work(mean_row(rows.subspan(k - span, span)), mean_row(rows.subspan(k, span))) <= 0) {
            const PathRow here = mean_row(rows.subspan(k - span, 2 * span));
            return Instability{here.deviator_stress, here.mean_stress, here.axial_strain};
        }
    }
    return {};
}

/// Highest q. Where q is held: the highest pore pressure until it is lost, since loads that stay would not come back.
const PathRow& peak_of(const std::vector<PathRow>& rows, Path path) {
    if (path != Path::ConstantDeviator) {
        return *std::max_element(rows.begin(), rows.end(), [](const PathRow& a, const PathRow& b) {
            return a.deviator_stress < b.deviator_stress;
        });
    }
    const double held = (1 - lost_share) * rows.front().deviator_stress;
    const auto lost =
        std::find_if(rows.begin() + 1, rows.end(), [&](const PathRow& row) { return row.deviator_stress < held; });
    return *std::max_element(rows.begin(), lost, [](const PathRow& a, const PathRow& b) {
        return a.excess_pore_pressure < b.excess_pore_pressure;
    });
}

bool holds_a_stress(Path path) {
    return path == Path::Drained || path == Path::ConstantMean || path == Path::Isotropic ||
           path == Path::PlaneStrain || path == Path::ShearAtStress;
}

/// sin = (s1 - s3)/(s1 + s3), of stresses along the axes [rad].
double mobilized_angle(const Mat3& stress) {
    const auto [least, most] = std::minmax({stress(0, 0), stress(1, 1), stress(2, 2)});
    return std::asin((most - least) / (most + least));
}

/// Extension as compression: q and the axial strain with the other sign.
std::vector<PathRow> mirrored(std::vector<PathRow> rows) {
    for (PathRow& row : rows) {
        row.axial_strain = -row.axial_strain;
        row.deviator_stress = -row.deviator_stress;
    }
    return rows;
}

/// That is held: the lateral one, or the mean [Pa].
double held_stress(const PathRow& row, Path path) {
    return path == Path::Drained ? row.mean_stress - row.deviator_stress / 3 : row.mean_stress;
}

/// Axial strain of the first row at which the stress that the path holds is lost.
std::optional<double> loss_of_hold(const std::vector<PathRow>& rows, const TriaxialSpec& spec) {
    const Path path = spec.path;
    if (!holds_a_stress(path)) {
        return {};
    }
    const bool is_one_stress = !spec.b && (path == Path::Drained || path == Path::ConstantMean);
    const double least = (1 - lost_hold_share) * held_stress(rows.front(), path);
    const auto lost = std::find_if(rows.begin(), rows.end(), [&](const PathRow& row) {
        return is_one_stress ? held_stress(row, path) < least : row.hold_error > lost_hold_share;
    });
    return lost == rows.end() ? std::nullopt : std::optional(lost->axial_strain);
}

/// Secant from the start to half of the increase of q [Pa]; nothing where there is none.
std::optional<double> stiffness_until(const std::vector<PathRow>& rows, double peak) {
    const double start = rows.front().deviator_stress, half = start + 0.5 * (peak - start);
    for (std::size_t k = 1; k < rows.size(); ++k) {
        const PathRow &a = rows[k - 1], &b = rows[k];
        if (!(half > start) || b.deviator_stress < half) {
            continue;
        }
        const double share = (half - a.deviator_stress) / (b.deviator_stress - a.deviator_stress);
        const double strain = a.axial_strain + share * (b.axial_strain - a.axial_strain);
        if (strain > 0) {
            return (half - start) / strain;
        }
    }
    return {};
}

/// Largest -d eps_v / d eps_1 [-], over one percent of strain or the next row beyond: the noise of single rows is no
/// dilatancy. Nothing of a shorter test; 0 where it only contracts.
std::optional<double> largest_dilatancy(const std::vector<PathRow>& rows) {
    constexpr double slope_span = 0.01 * (1 - 1e-9);
    std::optional<double> dilatancy;
    for (std::size_t k = 0, first = 0; k < rows.size(); ++k) {
        while (first + 1 < k && rows[k].axial_strain - rows[first + 1].axial_strain >= slope_span) {
            ++first;
        }
        const double run = rows[k].axial_strain - rows[first].axial_strain;
        if (run >= slope_span) {
            const double slope = -(rows[k].volumetric_strain - rows[first].volumetric_strain) / run;
            dilatancy = std::max(dilatancy.value_or(0), slope);
        }
    }
    return dilatancy;
}

} // namespace

std::optional<double> find_hold_error(const std::vector<PathRow>& rows, Path path) {
    if (!holds_a_stress(path) || rows.empty()) {
        return {};
    }
    return std::ranges::max(rows, {}, &PathRow::hold_error).hold_error;
}

Response summarize(const std::vector<PathRow>& rows, const TriaxialSpec& spec) {
    const Path path = spec.path;
    Response response;
    if (rows.empty()) {
        return response;
    }
    if (spec.direction == Direction::Extension) {
        TriaxialSpec compression = spec;
        compression.direction = Direction::Compression;
        response = summarize(mirrored(rows), compression);
        for (double* const number :
             {&response.peak_deviator, &response.final_deviator, &response.peak_strain, &response.peak_ratio}) {
            *number = -*number;
        }
        const auto peak = std::ranges::min_element(rows, {}, &PathRow::deviator_stress);
        response.friction_angle = mobilized_angle(peak->stress);
        response.lost_at = loss_of_hold(rows, spec);
        response.instability = is_axisymmetric(spec) ? find_instability(rows) : std::nullopt;
        return response;
    }
    const PathRow& peak = peak_of(rows, path);
    if (peak.mean_stress > 0) {
        response.peak_deviator = peak.deviator_stress;
        response.peak_strain = peak.axial_strain;
        response.peak_ratio = peak.deviator_stress / peak.mean_stress;
    }
    if (peak.deviator_stress > 0) {
        const double lateral = peak.mean_stress - peak.deviator_stress / 3;
        response.friction_angle = is_axisymmetric(spec)
                                      ? std::asin(peak.deviator_stress / (peak.deviator_stress + 2 * lateral))
                                      : mobilized_angle(peak.stress);
    }
    for (const PathRow& row : rows) {
        response.largest_contraction = std::max(response.largest_contraction, row.volumetric_strain);
    }
    if (path != Path::ConstantDeviator) {
        response.stiffness = stiffness_until(rows, response.peak_deviator);
    }
    response.dilatancy = largest_dilatancy(rows);
    response.final_deviator = rows.back().deviator_stress;
    response.final_volumetric_strain = rows.back().volumetric_strain;
    response.energy = rows.back().energy;
    response.lost_at = loss_of_hold(rows, spec);
    if (is_axisymmetric(spec) && count_legs(spec) == 1) {
        response.instability = find_instability(rows);
    }
    if (path == Path::Undrained || path == Path::ConstantDeviator) {
        response.liquefied = std::any_of(rows.begin(), rows.end(), [&](const PathRow& row) {
            return row.mean_stress < liquefied_share * rows.front().mean_stress;
        });
        response.excess_pore_pressure = path == Path::Undrained ? rows.back().excess_pore_pressure //
                                                                : peak.excess_pore_pressure;
    }
    return response;
}

} // namespace suffuse::triaxial
