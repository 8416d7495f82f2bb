#include "suffuse/packing/target_density.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/packing/compact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace suffuse::packing {
namespace {

constexpr int most_trials = 24;
// Once two preparations nearer than this still differ by more than the tolerance, it is the scatter of single samples
// that decides: others next to them are as likely to meet, at such distances from each other, around where the trials
// so far would meet it.
constexpr double alike = 0.02, step_aside = 0.012, around = 0.3;
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

/// A trial that misses ends early; the one that is taken all the same may not.
double reach_to_the_end(CompactSpec spec, const std::function<double(const CompactSpec&)>& reach) {
    spec.void_ratio_tolerance = std::numeric_limits<double>::infinity();
    return reach(spec);
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
    CompactSpec nearest;
    double least_off = std::numeric_limits<double>::max();
    while (found.trials < most_starts && start > least_start && start < most_start) {
        found.spec.start_porosity = start;
        found.void_ratio = reach(found.spec);
        ++found.trials;
        densest = std::min(densest, found.void_ratio), loosest = std::max(loosest, found.void_ratio);
        const double off = std::abs(found.void_ratio - target);
        if (off <= wanted.void_ratio_tolerance) {
            return found;
        }
        if (off < least_off) {
            least_off = off, nearest = found.spec;
        }
        start += wanted_porosity - porosity_of(found.void_ratio);
    }
    if (wanted.if_unreachable == IfUnreachable::Nearest && found.trials > 0) {
        found.spec = nearest;
        found.void_ratio = reach_to_the_end(nearest, reach);
        found.is_met = false;
        return found;
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

/// Slow and faithful: a bracket is closed on the preparation that meets the void ratio, and where scatter beats that,
/// preparations next to it are tried.
class Search {
public:
    Search(
        const CompactSpec& wanted, const grains::Material& final_material,
        const std::function<double(const CompactSpec&)>& reach
    )
        : wanted_(wanted), final_material_(final_material), reach_(reach), target_(*wanted.void_ratio) {}

    FoundDensity run() {
        if (take_bracket()) {
            close_bracket();
            try_around();
        }
        if (!is_met()) {
            settle_for_nearest();
        }
        found_.trials = static_cast<int>(trials_.size());
        found_.is_met = is_met();
        return found_;
    }

private:
    struct Trial {
        double looseness = 0, void_ratio = 0;
    };

    const Trial& try_one(double looseness) {
        found_.spec = preparation(wanted_, final_material_, looseness);
        found_.void_ratio = reach_(found_.spec);
        trials_.push_back({looseness, found_.void_ratio});
        return trials_.back();
    }

    [[nodiscard]] double off(const Trial& trial) const { return std::abs(trial.void_ratio - target_); }

    [[nodiscard]] bool is_met() const { return std::abs(found_.void_ratio - target_) <= wanted_.void_ratio_tolerance; }

    /// The ends of the scale that the void ratio lies between. @return whether there are two, and none of them meets
    /// it.
    bool take_bracket() {
        high_ = try_one(1);
        if (is_met()) {
            return false;
        }
        if (high_.void_ratio < target_) { // looser than the final friction gives
            low_ = high_;
            high_ = try_one(2);
        } else {
            low_ = try_one(0);
        }
        return !is_met() && low_.void_ratio < target_ && target_ < high_.void_ratio;
    }

    void close_bracket() {
        while (static_cast<int>(trials_.size()) < most_trials && !is_met() && high_.looseness - low_.looseness > alike
        ) {
            // Between the chord and the middle: the void ratio is a curved and, within its noise, monotonic function.
            const double chord = (target_ - low_.void_ratio) / (high_.void_ratio - low_.void_ratio);
            const double share = std::clamp(0.7 * chord + 0.15, 0.1, 0.9);
            const Trial reached = try_one(low_.looseness + share * (high_.looseness - low_.looseness));
            (reached.void_ratio < target_ ? low_ : high_) = reached;
        }
    }

    void try_around() {
        for (int k = 1; static_cast<int>(trials_.size()) < most_trials && !is_met(); ++k) {
            const int pair = (k + 1) / 2; // one to each side
            const double away = step_aside * pair;
            try_one(std::clamp(likeliest() + (k % 2 == 0 ? away : -away), 0.0, 2.0));
        }
    }

    /// Where a straight line through the trials around the bracket meets the target.
    [[nodiscard]] double likeliest() const {
        const double middle = 0.5 * (low_.looseness + high_.looseness);
        double n = 0, x = 0, y = 0, xx = 0, xy = 0;
        for (const Trial& trial : trials_) {
            const double dx = trial.looseness - middle, dy = trial.void_ratio - target_;
            if (std::abs(dx) <= around) {
                n += 1, x += dx, y += dy, xx += dx * dx, xy += dx * dy;
            }
        }
        const double rise = (n * xy - x * y) / (n * xx - x * x), at = (x - y / rise) / n;
        return middle + (rise > 0 ? std::clamp(at, -around, around) : 0);
    }

    void settle_for_nearest() {
        const auto nearest =
            std::ranges::min_element(trials_, std::less{}, [&](const Trial& trial) { return off(trial); });
        if (wanted_.if_unreachable == IfUnreachable::Error) {
            report(*nearest);
        }
        found_.spec = preparation(wanted_, final_material_, nearest->looseness);
        found_.void_ratio = reach_to_the_end(found_.spec, reach_);
    }

    [[noreturn]] void report(const Trial& nearest) {
        if (low_.void_ratio < target_ && target_ < high_.void_ratio) {
            throw StateError(fmt::format(
                "the void ratio {:.4f} was not met within {} after {} compactions; the nearest is {:.4f}: widen "
                "void_ratio_tolerance, take more grains, or in a case take the nearest with if_unreachable = "
                "\"nearest\"",
                target_, wanted_.void_ratio_tolerance, trials_.size(), nearest.void_ratio
            ));
        }
        const double densest = low_.looseness == 0 ? low_.void_ratio : try_one(0).void_ratio;
        const double loosest = high_.looseness == 2 ? high_.void_ratio : try_one(2).void_ratio;
        throw StateError(fmt::format(
            "the void ratio {:.4f} cannot be reached at {:.4g} kPa: this sample goes from {:.4f} (frictionless) to "
            "{:.4f} (final friction with adhesion {:.3g} Pa) during compaction; specify a value in between, more "
            "adhesion, or in a case take the nearest with if_unreachable = \"nearest\"",
            target_, wanted_.pressure / 1e3, densest, loosest,
            wanted_.prepare.adhesion_normal.value_or(default_adhesion)
        ));
    }

    const CompactSpec& wanted_;
    const grains::Material& final_material_;
    const std::function<double(const CompactSpec&)>& reach_;
    double target_; ///< [-]
    FoundDensity found_;
    std::vector<Trial> trials_;
    Trial low_, high_;
};

} // namespace

FoundDensity search_void_ratio(
    const CompactSpec& wanted, const grains::Material& final_material,
    const std::function<double(const CompactSpec&)>& reach
) {
    return wanted.protocol == Protocol::Swift ? search_start(wanted, reach)
                                              : Search(wanted, final_material, reach).run();
}

} // namespace suffuse::packing
