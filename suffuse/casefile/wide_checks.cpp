#include "suffuse/casefile/wide_checks.hpp"

#include "suffuse/base/units.hpp"
#include "suffuse/casefile/sample_checks.hpp"
#include "suffuse/contact/springs.hpp"
#include "suffuse/grains/grading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace suffuse::casefile {
namespace {

using packing::Protocol;

constexpr double large_squeezed = 0.1; ///< of the finest radius: what a run warns of when it is seen [-]
constexpr double too_wide = 12;        ///< the same, above which samples of `faithful` and `slow` are off
constexpr double too_wide_to_push = 9; ///< the same, above which those of `swift` may fail

/// To two digits, for advice.
double round_up(double value) {
    const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1);
    return std::ceil(value / unit) * unit;
}

/// Coarsest over finest grain; 1 without a grading.
double size_ratio_of(const Variant& variant) {
    const auto grading = variant.soil ? whole_grading(*variant.soil) : std::nullopt;
    return grading ? largest_grain(*grading) / grains::size_at(*grading, 0) : 1;
}

/// The same where both fractions are there: the ends of a sweep over the fines content have one of them only.
double size_ratio_with_fines(const Variant& variant) {
    if (!variant.soil || !variant.soil->coarse || !variant.soil->fines) {
        return size_ratio_of(variant);
    }
    Variant mixed = variant;
    mixed.soil->fines_content = 0.5;
    return size_ratio_of(mixed);
}

/// What was seen of a protocol in gradings wider than it is made for; empty for `wide`.
std::string_view seen_of(Protocol protocol) {
    switch (protocol) {
    case Protocol::Faithful:
        return "its plain samples came out looser by 0.07 in void ratio than grains with their own inertia leave them, "
               "and most of its steps follow fine grains that roll on coarse ones";
    case Protocol::Slow:
        return "its servo rings, and two million steps did not settle a sample";
    case Protocol::Swift:
        return "one of six loose samples did not reach its pressure, and dense ones may take hours";
    case Protocol::Wide:
        break;
    }
    return "";
}

} // namespace

double squeezed_overlap_at(double pressure, const grains::Material& material, double size_ratio) {
    constexpr double of_chains = 4; // over the pressure: stress of the strongest chains
    return contact::spring_of(material).overlap_under(material, of_chains * pressure * size_ratio * size_ratio);
}

double stiffer_modulus(const grains::Material& material, double times) {
    return round_up(material.modulus * std::pow(times, contact::spring_of(material).exponent(material)));
}

void check_squeezed(
    Problems& problems, const Place& place, double pressure, const Variant& variant, std::optional<Protocol> protocol
) {
    const double ratio = size_ratio_of(variant);
    const double overlap = squeezed_overlap_at(pressure, variant.material, ratio);
    const bool promises = protocol == Protocol::Wide;
    const double good = promises ? good_squeezed / strongest_of_wide : good_squeezed;
    if (overlap <= (promises ? good : large_squeezed) || ratio < wide_grading) {
        return;
    }
    problems.warning(
        "W609", place,
        fmt::format(
            "at {} the finest grains, {:.3g} times smaller than the coarsest, overlap by some {:.0f} % of their radius "
            "where they are caught between those",
            print_quantity(pressure, dimension::pressure), ratio, 100 * overlap
        ),
        fmt::format(
            "a contact modulus = \"{}\" keeps trapped fines below {:.0f} % of overlap; steps grow with its root",
            print_quantity(stiffer_modulus(variant.material, overlap / good), dimension::pressure), 100 * good_squeezed
        )
    );
}

void check_protocol(
    Problems& problems, const Place& place, std::string_view stage, Protocol protocol, const Variant& variant
) {
    if (protocol == Protocol::Wide) {
        const double ratio = size_ratio_with_fines(variant);
        if (variant.soil && ratio < wide_grading) {
            problems.warning(
                "W615", place,
                fmt::format(
                    "stage \"{}\" takes protocol \"wide\", and the coarsest grains are only {:.3g} times the finest",
                    stage, ratio
                ),
                "take protocol = \"faithful\": the inertia that wide lends to fine grains among much coarser ones has "
                "no use here"
            );
        }
        return;
    }
    if (!variant.soil || !variant.soil->coarse) {
        return; // seen in mixtures of two fractions: a curve has grains of all sizes between
    }
    const double ratio = size_ratio_of(variant);
    if (ratio < (protocol == Protocol::Swift ? too_wide_to_push : too_wide)) {
        return;
    }
    problems.warning(
        "W616", place,
        fmt::format(
            "stage \"{}\" compacts grains of which the coarsest are {:.3g} times the finest by protocol \"{}\": in "
            "gradings as wide {}",
            stage, ratio, packing::name_of(protocol), seen_of(protocol)
        ),
        "take protocol = \"wide\""
    );
}

} // namespace suffuse::casefile
