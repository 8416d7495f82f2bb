#include "suffuse/laboratory/strain_conventions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

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

std::string direction_words(bool contracts) {
    return contracts ? "contraction" : "expansion";
}

/// What the heading says of positive values.
std::optional<bool> named_contraction(const TestColumn& strain) {
    return strain.expands != strain.contracts ? std::optional(strain.contracts) : std::nullopt;
}

/// @return whether the void ratio decides on unit and sign.
bool settle_by_void_ratio(const RecordReview& review, TestColumn& strain) {
    const auto factor = fit_to_void_ratio(review, strain);
    if (!factor) {
        return false;
    }
    if (const auto named = named_contraction(strain); named && *named != (*factor > 0)) {
        review.refuse(fmt::format(
            "column \"{}\" is positive in {} by its heading, and in {} by the void ratio; correct one of them",
            strain.heading, direction_words(*named), direction_words(*factor > 0)
        ));
    }
    if (strain.unit.empty()) {
        strain.unit = std::abs(*factor) == 1 ? "1" : "%";
        review.decided(
            fmt::format("\"{}\" is in {}: the void ratio changes as much", strain.heading, unit_words(strain.unit))
        );
    }
    review.decided(fmt::format(
        "\"{}\" is positive in {}: the void ratio falls where it {}", strain.heading, direction_words(*factor > 0),
        *factor > 0 ? "rises" : "falls"
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

/// Of a triaxial test, with its columns as their headings call them.
struct Deviator {
    std::vector<double> values;
    std::string words;      ///< the columns, for messages
    bool is_change = false; ///< known but for a constant: axial stress under a radial stress that nobody gives
};

Deviator deviator_in(const RecordReview& review) {
    const auto find = [&](Quantity quantity) { return std::as_const(review.record).find(quantity); };
    if (const TestColumn* q = find(Quantity::DeviatorStress)) {
        return {q->values, fmt::format("\"{}\"", q->heading)};
    }
    const TestColumn &axial = *find(Quantity::AxialStress), *radial = find(Quantity::RadialStress),
                     *u = find(Quantity::PorePressure);
    Deviator q{axial.values, fmt::format("\"{}\"", axial.heading), radial == nullptr};
    int waters = 0; // how many times the pore pressure is missing
    if (u != nullptr && radial == nullptr) {
        waters = axial.is_effective.value_or(false) ? 1 : 0;
    } else if (u != nullptr && axial.is_effective && radial->is_effective) {
        waters = (*axial.is_effective ? 1 : 0) - (*radial->is_effective ? 1 : 0);
    }
    for (std::size_t k = 0; k < q.values.size(); ++k) {
        q.values[k] += (waters != 0 ? waters * u->values[k] : 0) - (radial != nullptr ? radial->values[k] : 0);
    }
    if (radial != nullptr) {
        q.words += fmt::format(" minus \"{}\"", radial->heading);
    }
    return q;
}

} // namespace

void settle_volumetric_strain(const RecordReview& review, std::optional<bool> contraction_is_positive) {
    TestColumn* strain = review.record.find(Quantity::VolumetricStrain);
    if (strain == nullptr) {
        return;
    }
    if (settle_by_void_ratio(review, *strain)) {
        if (contraction_is_positive.value_or(strain->factor > 0) != (strain->factor > 0)) {
            review.assumed(
                fmt::format("\"{}\" has the sign that the void ratio gives, not the specified one", strain->heading)
            );
        }
        return;
    }
    settle_unit(review, *strain);
    const auto contracts = contraction_is_positive ? contraction_is_positive : named_contraction(*strain);
    if (contracts) {
        review.decided(fmt::format(
            "\"{}\" is positive in {}: {}", strain->heading, direction_words(*contracts),
            contraction_is_positive ? "as specified" : "by its heading"
        ));
        multiply(*strain, *contracts ? 1 : -1);
        return;
    }
    review.refuse(fmt::format(
        "column \"{}\" may be positive in contraction or in expansion, and no void ratio decides; write \"contraction "
        "positive\" or \"expansion positive\" into its heading, or give --contraction, as a target of [calibrate] does "
        "with `contraction`",
        strain->heading
    ));
}

/// The deviator stress does work on it, and rises with it, unless a record begins under load: unloading has work
/// alone of the wrong sign, softening has the rise.
void settle_triaxial_axial_strain(const RecordReview& review) {
    TestColumn& strain = *review.record.find(Quantity::AxialStrain);
    settle_unit(review, strain);
    const Deviator q = deviator_in(review);
    double work = 0, rise = 0;
    review.for_each_row([&](std::size_t k, std::size_t first) {
        const double change = strain.values[k] - strain.values[first];
        work += change * q.values[k];
        rise += change * (q.values[k] - q.values[first]);
    });
    if (q.is_change) {
        work = rise;
    }
    if (work == 0 && rise == 0) {
        review.refuse(fmt::format("columns \"{}\" and {} do not change", strain.heading, q.words));
    }
    const auto named = named_contraction(strain);
    const bool is_open = work * rise < 0;
    const auto words = [](bool compresses) { return compresses ? "compression" : "extension"; };
    if (is_open && !named) {
        review.refuse(fmt::format(
            "column \"{0}\" may be positive in compression or in extension: {1} does work on it if it is positive in "
            "{2}, but rises with it if it is positive in {3}; write \"compression positive\" or \"extension positive\" "
            "into its heading",
            strain.heading, q.words, words(work > 0), words(rise > 0)
        ));
    }
    const bool compresses = is_open ? *named : work + rise > 0;
    if (named && compresses != *named) {
        review.refuse(fmt::format(
            "column \"{}\" is positive in {} by its heading, and in {} by the work of {}; correct one of them",
            strain.heading, words(*named), words(compresses), q.words
        ));
    }
    review.decided(fmt::format(
        "\"{}\" is positive in {}: {}", strain.heading, words(compresses),
        is_open ? "by its heading" : q.words + " does work on it"
    ));
    multiply(strain, compresses ? 1 : -1);
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
