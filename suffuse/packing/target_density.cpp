#include "suffuse/packing/target_density.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/packing/compact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace suffuse::packing {
namespace {

constexpr int most_trials = 16;
constexpr double default_adhesion = 1e6; // [Pa], where the case lends none: the loosest state on offer

/// Preparations on one scale: 0 frictionless, 1 the final friction, 2 the final friction with all the adhesion.
CompactSpec preparation(const CompactSpec& wanted, const grains::Material& final_material, double looseness) {
    CompactSpec spec = wanted;
    spec.prepare = {};
    spec.prepare.friction = std::min(looseness, 1.0) * final_material.friction;
    if (looseness > 1) {
        const double share = looseness - 1;
        spec.prepare.adhesion_normal = share * wanted.prepare.adhesion_normal.value_or(default_adhesion);
        spec.prepare.adhesion_shear = share * wanted.prepare.adhesion_shear.value_or(default_adhesion);
    }
    return spec;
}

/// Swift: the sample ends a little denser than its start, so that the first trial mostly meets; what it misses by moves
/// the next start.
FoundDensity search_start(const CompactSpec& wanted, const std::function<double(const CompactSpec&)>& reach) {
    constexpr int most_starts = 8;
    constexpr double least_start = 0.25, most_start = 0.5; // beyond, overlaps never clear or nothing touches
    const double target = *wanted.void_ratio, wanted_porosity = porosity_of(target);
    FoundDensity found;
    found.spec = wanted;
    double start = wanted.start_porosity.value_or(wanted_porosity + swift_settling);
    double densest = std::numeric_limits<double>::max(), loosest = 0;
    while (found.trials < most_starts && start > least_start && start < most_start) {
        found.spec.start_porosity = start;
        found.void_ratio = reach(found.spec);
        ++found.trials;
        densest = std::min(densest, found.void_ratio), loosest = std::max(loosest, found.void_ratio);
        if (std::abs(found.void_ratio - target) <= wanted.void_ratio_tolerance) {
            return found;
        }
        start += wanted_porosity - porosity_of(found.void_ratio);
    }
    throw StateError(
        found.trials == 0
            ? fmt::format(
                  "the void ratio {:.4f} is out of reach of protocol \"swift\", which starts at porosities from {} to "
                  "{}: take protocol = \"faithful\"",
                  target, least_start, most_start
              )
            : fmt::format(
                  "the void ratio {:.4f} was not met at {:.4g} kPa: {} starts went from {:.4f} to {:.4f}; {}", target,
                  wanted.pressure / 1e3, found.trials, densest, loosest,
                  target < densest ? "lower prepare.friction for a denser sample"
                  : target > loosest
                      ? "looser samples need adhesion while they are compacted: take protocol = \"faithful\""
                      : "widen void_ratio_tolerance, or take more grains"
              )
    );
}

[[noreturn]] void report_range(const CompactSpec& wanted, double densest, double loosest) {
    throw StateError(fmt::format(
        "the void ratio {:.4f} cannot be reached at {:.4g} kPa: this sample goes from {:.4f} (frictionless) to {:.4f} "
        "(final friction with adhesion {:.3g} Pa) during compaction; ask for a value in between, or lend it more "
        "adhesion",
        *wanted.void_ratio, wanted.pressure / 1e3, densest, loosest,
        wanted.prepare.adhesion_normal.value_or(default_adhesion)
    ));
}

} // namespace

FoundDensity search_void_ratio(
    const CompactSpec& wanted, const grains::Material& final_material,
    const std::function<double(const CompactSpec&)>& reach
) {
    if (wanted.protocol == Protocol::Swift) {
        return search_start(wanted, reach);
    }
    const double target = *wanted.void_ratio;
    FoundDensity found;
    const auto try_one = [&](double looseness) {
        found.spec = preparation(wanted, final_material, looseness);
        found.void_ratio = reach(found.spec);
        ++found.trials;
        return found.void_ratio;
    };
    const auto good = [&] { return std::abs(found.void_ratio - target) <= wanted.void_ratio_tolerance; };

    double low = 0, high = 1, at_low = 0, at_high = try_one(1);
    if (good()) {
        return found;
    }
    if (at_high < target) { // looser than the final friction gives
        low = 1, at_low = at_high, high = 2, at_high = try_one(2);
    } else {
        at_low = try_one(0);
    }
    if (good()) {
        return found;
    }
    if (target < at_low || target > at_high) {
        const double densest = low == 0 ? at_low : try_one(0);
        const double loosest = high == 2 ? at_high : try_one(2);
        report_range(wanted, densest, loosest);
    }
    while (found.trials < most_trials) {
        // Between the chord and the middle: the void ratio is a curved and, within its noise, monotonic function.
        const double chord = (target - at_low) / (at_high - at_low);
        const double share = std::clamp(0.7 * chord + 0.15, 0.1, 0.9);
        const double looseness = low + share * (high - low);
        const double reached = try_one(looseness);
        if (good()) {
            return found;
        }
        (reached < target ? low : high) = looseness;
        (reached < target ? at_low : at_high) = reached;
    }
    throw StateError(fmt::format(
        "the void ratio {:.4f} was not met within {} after {} compactions; the nearest are {:.4f} and {:.4f}: widen "
        "void_ratio_tolerance, or take more grains",
        target, wanted.void_ratio_tolerance, found.trials, at_low, at_high
    ));
}

} // namespace suffuse::packing
