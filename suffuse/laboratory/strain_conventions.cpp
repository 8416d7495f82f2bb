#include "suffuse/laboratory/strain_conventions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace suffuse::laboratory {
namespace {

constexpr double same = 0.2;       // relative, of strains that differ by their definition, linear or logarithmic
constexpr double no_change = 1e-4; // of a volume, too small to decide anything

/// The factor, with its sign, by which a strain follows the void ratio e: (e0 - e) / (1 + e0). None where e does
/// not change.
std::optional<double> fit_to_void_ratio(const RecordReview& review, const TestColumn& strain) {
    const TestColumn* e = review.record.find(Quantity::VoidRatio);
    if (e == nullptr) {
        return std::nullopt;
    }
    const auto change = [&](std::size_t k, std::size_t first) {
        return (e->values[first] - e->values[k]) / (1 + e->values[first]);
    };
    const double size =
        std::sqrt(review.sum([&](std::size_t k, std::size_t first) { return std::pow(change(k, first), 2); }));
    if (!(size > no_change * std::sqrt(static_cast<double>(review.record.rows())))) {
        return std::nullopt;
    }
    for (const double factor : {1.0, 0.01, -1.0, -0.01}) {
        if (std::abs(factor) != 1 && !strain.unit.empty()) {
            continue;
        }
        const double off = std::sqrt(review.sum([&](std::size_t k, std::size_t first) {
            return std::pow(factor * (strain.values[k] - strain.values[first]) - change(k, first), 2);
        }));
        if (off <= same * size) {
            return factor;
        }
    }
    review.refuse(fmt::format(
        "columns \"{}\" and \"{}\" contradict one another: a strain is the change of e over 1 + e, with either sign; "
        "correct or remove one",
        strain.heading, e->heading
    ));
}

std::string unit_words(const std::string& unit) {
    return unit == "%" ? "percent" : "fractions";
}

/// @return whether the void ratio decides on unit and sign.
bool settle_by_void_ratio(const RecordReview& review, TestColumn& strain) {
    const auto factor = fit_to_void_ratio(review, strain);
    if (!factor) {
        return false;
    }
    if (strain.unit.empty()) {
        strain.unit = std::abs(*factor) == 1 ? "1" : "%";
        review.decided(
            fmt::format("\"{}\" is in {}: the void ratio changes as much", strain.heading, unit_words(strain.unit))
        );
    }
    review.decided(fmt::format(
        "\"{}\" is positive in {}: the void ratio falls where it {}", strain.heading,
        *factor > 0 ? "contraction" : "expansion", *factor > 0 ? "rises" : "falls"
    ));
    multiply(strain, *factor);
    return true;
}

/// Of a strain that the void ratio says nothing about.
void settle_unit(const RecordReview& review, TestColumn& strain) {
    if (!strain.unit.empty()) {
        return;
    }
    const double largest = std::abs(*std::ranges::max_element(strain.values, {}, [](double v) { return std::abs(v); }));
    if (!(largest > 1)) {
        review.refuse(fmt::format(
            "column \"{0}\" has no unit: it may be in percent or a fraction; write \"{0} [%]\" or \"{0} [-]\"",
            strain.heading
        ));
    }
    strain.unit = "%";
    review.decided(fmt::format("\"{}\" is in percent: it exceeds 1", strain.heading));
    multiply(strain, 0.01);
}

} // namespace

void settle_volumetric_strain(const RecordReview& review, std::optional<bool> contraction_is_positive) {
    TestColumn* strain = review.record.find(Quantity::VolumetricStrain);
    if (strain == nullptr || settle_by_void_ratio(review, *strain)) {
        return;
    }
    settle_unit(review, *strain);
    const bool is_named = strain->expands != strain->contracts;
    if (contraction_is_positive || is_named) {
        const bool contracts = contraction_is_positive.value_or(strain->contracts);
        review.decided(fmt::format(
            "\"{}\" is positive in {}: {}", strain->heading, contracts ? "contraction" : "expansion",
            contraction_is_positive ? "as specified" : "by its heading"
        ));
        multiply(*strain, contracts ? 1 : -1);
        return;
    }
    review.refuse(fmt::format(
        "column \"{}\" may be positive in contraction or in expansion, and no void ratio decides; give --contraction "
        "positive or --contraction negative",
        strain->heading
    ));
}

/// The deviator stress does work on it.
void settle_triaxial_axial_strain(const RecordReview& review) {
    TestColumn& strain = *review.record.find(Quantity::AxialStrain);
    settle_unit(review, strain);
    const TestColumn* q = review.record.find(Quantity::DeviatorStress);
    const TestColumn* axial = review.record.find(Quantity::AxialStress);
    const TestColumn& stress = q != nullptr ? *q : *axial;
    const double work = review.sum([&](std::size_t k, std::size_t first) {
        return (strain.values[k] - strain.values[first]) *
               (stress.values[k] - (q != nullptr ? 0 : stress.values[first]));
    });
    if (!(std::abs(work) > 0)) {
        review.refuse(fmt::format("columns \"{}\" and \"{}\" do not change", strain.heading, stress.heading));
    }
    review.decided(fmt::format(
        "\"{}\" is positive in {}: \"{}\" does work on it", strain.heading, work > 0 ? "compression" : "extension",
        stress.heading
    ));
    multiply(strain, work > 0 ? 1 : -1);
}

void settle_oedometer_strain(const RecordReview& review) {
    const TestColumn& stress = *review.record.find(Quantity::AxialStress);
    TestColumn* strain = review.record.find(Quantity::AxialStrain);
    if (strain == nullptr || settle_by_void_ratio(review, *strain)) {
        return;
    }
    settle_unit(review, *strain);
    const double rise = review.sum([&](std::size_t k, std::size_t first) {
        return (strain->values[k] - strain->values[first]) * (stress.values[k] - stress.values[first]);
    });
    if (!(std::abs(rise) > 0)) {
        review.refuse(fmt::format("columns \"{}\" and \"{}\" do not change", strain->heading, stress.heading));
    }
    review.decided(fmt::format(
        "\"{}\" is positive in {}: it {} with \"{}\"", strain->heading, rise > 0 ? "compression" : "extension",
        rise > 0 ? "rises" : "falls", stress.heading
    ));
    multiply(*strain, rise > 0 ? 1 : -1);
}

} // namespace suffuse::laboratory
