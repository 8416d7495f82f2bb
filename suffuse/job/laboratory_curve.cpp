#include "suffuse/job/laboratory_curve.hpp"

#include "suffuse/job/laboratory_readings.hpp"
#include "suffuse/laboratory/read_test.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace suffuse::job {
namespace {

using casefile::CalibrateTarget;
using casefile::CalibrateTest;
using laboratory::Quantity;

/// Of the largest strain: closer where curves bend.
constexpr std::array strain_shares = {0.025, 0.05, 0.075, 0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.6, 0.8, 1.0};
constexpr int stresses_of_grid = 10;
constexpr double unloading = 0.95;    // of the largest stress so far: below it a test is unloaded
constexpr double least_strain = 5e-4; // deviation of strains, however small they are
constexpr double least_ratio = 0.01;  // of stress ratios

/// The value of `y` where `x` first reaches `at`; the last one where it does not.
double first_at(const Values& x, const Values& y, double at) {
    for (std::size_t k = 0; k < x.size(); ++k) {
        if (x[k] >= at) {
            const double step = k == 0 ? 0 : x[k] - x[k - 1];
            return step > 0 ? y[k - 1] + (at - x[k - 1]) / step * (y[k] - y[k - 1]) : y[k];
        }
    }
    return y.back();
}

void append_part(Values& curve, const Values& grid, const Values& x, const Values& y) {
    for (const double at : grid) {
        curve.push_back(first_at(x, y, at));
    }
}

void divide(Values& values, double by) {
    for (double& value : values) {
        value /= by;
    }
}

CurveForm strain_form(const Readings& readings, const Values& strain, const CalibrateTarget& target) {
    CurveForm form;
    const double most = std::min(target.strain, *std::ranges::max_element(strain));
    if (most <= 0) {
        readings.complain("never has an axial strain above that of its start");
    }
    for (const double share : strain_shares) {
        form.grid.push_back(share * most);
    }
    const bool is_drained = target.test == CalibrateTest::Drained;
    form.parts = {
        CurveQuantity::StressRatio, is_drained ? CurveQuantity::VolumetricStrain : CurveQuantity::MeanStressRatio};
    form.measured = {CurveQuantity::StressRatio};
    const bool has_second =
        is_drained ? readings.find(Quantity::VolumetricStrain) != nullptr
                   : readings.find(Quantity::MeanStress) != nullptr || readings.find(Quantity::PorePressure) != nullptr;
    if (has_second) {
        form.measured.push_back(form.parts.back());
    }
    return form;
}

/// A drained test keeps its lateral stress, an undrained one begins at it.
void expect_lateral_stress(const Readings& readings, const CalibrateTarget& target) {
    constexpr double tolerance = 0.1; // of the pressure
    const auto lateral = lateral_stress_of(readings);
    if (!lateral) {
        return;
    }
    const Values strain = since_start(readings.of(Quantity::AxialStrain));
    for (std::size_t k = 0; k < strain.size(); ++k) {
        const bool counts = k == 0 || (target.test == CalibrateTest::Drained && strain[k] <= target.strain);
        if (counts && std::abs((*lateral)[k] - target.pressure) > tolerance * target.pressure) {
            readings.complain(fmt::format(
                "has an effective lateral stress of {:.4g} kPa at an axial strain of {:.2g} %, and the test that it is "
                "compared with has `pressure` = {:.4g} kPa there: write the lateral stress as `pressure`, or take a "
                "record "
                "that keeps it",
                (*lateral)[k] / 1e3, 100 * strain[k], target.pressure / 1e3
            ));
        }
    }
}

/// That the record is one of such a test under such a pressure. @throws CaseError
void expect_its_test(const Readings& readings, const CalibrateTarget& target) {
    constexpr double no_volume = 2e-3; // of strain, where water can neither enter nor leave
    constexpr double steepest = 20;    // q over the lateral stress: a friction angle of 65 degrees
    constexpr double isotropic = 0.1;  // q at the start over that stress, of seating
    if (const double first = deviator_of(readings).front(); std::abs(first) > isotropic * target.pressure) {
        readings.complain(fmt::format(
            "begins at q = {:.4g} kPa, and the test that it is compared with begins at rest under `pressure` = {:.4g} "
            "kPa alone: take a record that does, or leave out what is before",
            first / 1e3, target.pressure / 1e3
        ));
    }
    expect_lateral_stress(readings, target);
    if (target.test == CalibrateTest::Undrained) {
        if (readings.find(Quantity::VolumetricStrain) == nullptr) {
            return;
        }
        double largest = 0;
        for (const double strain : since_start(readings.of(Quantity::VolumetricStrain))) {
            largest = std::max(largest, std::abs(strain));
        }
        if (largest > no_volume) {
            readings.complain(fmt::format(
                "has volumetric strains of up to {:.2g} %, and an undrained test has none: write test = \"drained\"",
                100 * largest
            ));
        }
    } else {
        const double most = std::ranges::max(deviator_of(readings));
        if (most > steepest * target.pressure) {
            readings.complain(fmt::format(
                "reaches q = {:.4g} kPa, {:.3g} times the `pressure` of {:.4g} kPa: no soil without cohesion bears "
                "that; write the lateral stress of this test",
                most / 1e3, most / target.pressure, target.pressure / 1e3
            ));
        }
    }
}

LaboratoryCurve triaxial_curve(const Readings& readings, const CalibrateTarget& target) {
    expect_its_test(readings, target);
    LaboratoryCurve curve;
    const Values strain = since_start(readings.of(Quantity::AxialStrain));
    curve.form = strain_form(readings, strain, target);
    for (const CurveQuantity part : curve.form.measured) {
        Values values = part == CurveQuantity::StressRatio        ? deviator_of(readings)
                        : part == CurveQuantity::VolumetricStrain ? since_start(readings.of(Quantity::VolumetricStrain))
                                                                  : mean_of(readings, target.pressure);
        if (part != CurveQuantity::VolumetricStrain) {
            divide(values, target.pressure);
        }
        append_part(curve.values, curve.form.grid, strain, values);
    }
    return curve;
}

Values logarithms(Values values) {
    for (double& value : values) {
        value = std::log(std::max(value, 1e-3)); // the first reading of an oedometer may be 0
    }
    return values;
}

/// From the start of the grid on.
void append_compression(Values& curve, const Values& grid, const Values& stress, const Values& strain) {
    append_part(curve, logarithms(grid), logarithms(stress), strain);
    const double start = curve.front();
    for (double& value : curve) {
        value -= start;
    }
}

LaboratoryCurve oedometer_curve(const Readings& readings, const CalibrateTarget& target) {
    Values stress = stress_of(readings, Quantity::AxialStress, true), strain;
    if (readings.find(Quantity::AxialStrain) != nullptr) {
        strain = readings.of(Quantity::AxialStrain);
    } else {
        strain = readings.of(Quantity::VoidRatio);
        const double start = strain.front();
        for (double& e : strain) {
            e = (start - e) / (1 + start);
        }
    }
    double most = 0; // of the first loading
    std::size_t count = 0;
    for (; count < stress.size() && stress[count] >= unloading * most; ++count) {
        most = std::max(most, stress[count]);
    }
    stress.resize(count), strain.resize(count);
    if (most <= 1.2 * target.pressure) {
        readings.complain("has no axial stress well above `pressure`, where its curve is to begin");
    }
    constexpr double seating = 1.02;
    if (stress.front() > seating * target.pressure) {
        readings.complain(fmt::format(
            "begins at {:.4g} kPa, above the `pressure` of {:.4g} kPa where its curve is to begin: what it strained "
            "before is not known; write the stress of its first reading as `pressure`",
            stress.front() / 1e3, target.pressure / 1e3
        ));
    }
    LaboratoryCurve curve;
    for (int k = 0; k < stresses_of_grid; ++k) {
        curve.form.grid.push_back(target.pressure * std::pow(most / target.pressure, k / (stresses_of_grid - 1.0)));
    }
    curve.form.parts = curve.form.measured = {CurveQuantity::AxialStrain};
    append_compression(curve.values, curve.form.grid, stress, strain);
    return curve;
}

/// Misfits are over the largest value of a part.
void expect_values(const Readings& readings, CurveQuantity quantity, const Values& values) {
    if (std::ranges::any_of(values, [](double value) { return value != 0; })) {
        return;
    }
    std::string words(key_of(quantity));
    std::ranges::replace(words, '_', ' ');
    readings.complain(fmt::format(
        "has only zeros as {} where it is compared, as if that was not measured: {}", words,
        quantity == CurveQuantity::VolumetricStrain ? "leave its column out, or write test = \"undrained\""
                                                    : "correct the numbers of its column"
    ));
}

/// Deviations, and where each part is in a simulated curve.
void complete(LaboratoryCurve& curve, const Readings& readings, double scatter) {
    const std::size_t n = curve.form.grid.size();
    for (std::size_t m = 0; m < curve.form.measured.size(); ++m) {
        const CurveQuantity quantity = curve.form.measured[m];
        const auto part = std::ranges::find(curve.form.parts, quantity) - curve.form.parts.begin();
        const auto begin = curve.values.begin() + static_cast<std::ptrdiff_t>(m * n);
        const Values values(begin, begin + static_cast<std::ptrdiff_t>(n));
        expect_values(readings, quantity, values);
        const double deviation = deviation_of(quantity, values, scatter);
        for (std::size_t k = 0; k < n; ++k) {
            curve.rows.push_back(static_cast<int>(static_cast<std::size_t>(part) * n + k));
        }
        if (m > 0) {
            curve.begins.push_back(static_cast<int>(m * n));
        }
        curve.deviations.insert(curve.deviations.end(), n, deviation);
    }
}

} // namespace

std::string_view key_of(CurveQuantity quantity) {
    constexpr std::array<std::string_view, 4> keys = {
        "stress_ratio", "volumetric_strain", "mean_stress_ratio", "axial_strain"};
    return keys[static_cast<std::size_t>(quantity)];
}

double deviation_of(CurveQuantity quantity, const std::vector<double>& values, double scatter) {
    const bool is_ratio = quantity == CurveQuantity::StressRatio || quantity == CurveQuantity::MeanStressRatio;
    double largest = 0;
    for (const double value : values) {
        largest = std::max(largest, std::abs(value));
    }
    return std::max(scatter * largest, is_ratio ? least_ratio : least_strain);
}

LaboratoryCurve laboratory_curve(const laboratory::TestRecord& record, const CalibrateTarget& target) {
    const Readings readings(record, target);
    LaboratoryCurve curve =
        target.test == CalibrateTest::Oedometer ? oedometer_curve(readings, target) : triaxial_curve(readings, target);
    complete(curve, readings, target.scatter);
    curve.findings = record.findings;
    curve.unread = record.unread;
    return curve;
}

LaboratoryCurve read_laboratory_curve(const CalibrateTarget& target) {
    const bool is_oedometer = target.test == CalibrateTest::Oedometer;
    return laboratory_curve(
        laboratory::read_test(
            target.file, {.kind = is_oedometer ? laboratory::TestKind::Oedometer : laboratory::TestKind::Triaxial,
                          .contraction_is_positive = target.contraction_is_positive}
        ),
        target
    );
}

std::vector<double>
simulated_curve(const std::vector<triaxial::PathRow>& rows, const CurveForm& form, const CalibrateTarget& target) {
    constexpr int axis = 2; // which tests compress
    Values strain, volume, ratio, mean, stress;
    for (const triaxial::PathRow& row : rows) {
        strain.push_back(-std::expm1(-row.axial_strain));
        volume.push_back(-std::expm1(-row.volumetric_strain));
        ratio.push_back(row.deviator_stress / target.pressure);
        mean.push_back(row.mean_stress / target.pressure);
        stress.push_back(row.stress(axis, axis));
    }
    Values curve;
    for (const CurveQuantity part : form.parts) {
        switch (part) {
        case CurveQuantity::StressRatio:
            append_part(curve, form.grid, strain, ratio);
            break;
        case CurveQuantity::VolumetricStrain:
            append_part(curve, form.grid, strain, volume);
            break;
        case CurveQuantity::MeanStressRatio:
            append_part(curve, form.grid, strain, mean);
            break;
        case CurveQuantity::AxialStrain:
            append_compression(curve, form.grid, stress, strain);
            break;
        }
    }
    return curve;
}

} // namespace suffuse::job
