#include "suffuse/erosion/base_profile.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace suffuse::erosion {
namespace {

constexpr double known_share = 0.95; ///< of the base's mass in the filter, whose depth is given

/// Adds a sphere around `at` to what slices from `first` hold [m3].
void add_sphere(double at, double radius, double first, double step, std::vector<double>& volume) {
    const double low = at - radius;
    const double from = std::floor((low - first) / step), to = std::floor((at + radius - first) / step);
    for (double k = std::max(0.0, from); k <= to && k < static_cast<double>(volume.size()); ++k) {
        const double begin = first + k * step;
        volume[static_cast<std::size_t>(k)] += cap_volume(radius, begin + step - low) - cap_volume(radius, begin - low);
    }
}

std::vector<double> divided(std::vector<double> values, double divisor) {
    for (double& value : values) {
        value /= divisor;
    }
    return values;
}

/// Of a slice [m3].
double slice_volume(const dem::World& world, const Stack& stack, const BaseProfile& profile) {
    return cell::volume(world.cell) / stack.length * profile.step;
}

} // namespace

BaseProfile begin_profile(const dem::World& world, const Stack& stack, const Vec3& direction) {
    BaseProfile profile;
    profile.step = 0.5 * stack.filter_grain;
    // Of the base some lies before its face, in the rough end of the filter.
    const double before = std::ceil((stack.base_thickness() + stack.filter_grain) / profile.step);
    const double behind = std::ceil(stack.filter_thickness() / profile.step);
    profile.first = -before * profile.step;
    std::vector<double> filter(static_cast<std::size_t>(before + behind));
    const Vec3 along = direction / norm(direction);
    for (std::size_t g = 0; g < world.grains.size(); ++g) {
        if (world.grains.fine[g] == 0) {
            const double depth =
                moved_into(dot(world.grains.position[g], along), stack.face, stack.length) - stack.interface;
            for (const double period : {-1.0, 0.0, 1.0}) { // both its ends are rough
                const double at = depth + period * stack.length;
                add_sphere(at, world.grains.radius[g], profile.first, profile.step, filter);
            }
        }
    }
    profile.filter = divided(std::move(filter), slice_volume(world, stack, profile));
    return profile;
}

double depth_of(const MigrationLedger& ledger, std::size_t k, const Stack& stack, const Vec3& direction) {
    const double travel = dot(ledger.end[k] - ledger.start[k], direction) / norm(direction);
    return stack.exit - ledger.to_exit[k] + travel - stack.interface;
}

void note_profile(
    const MigrationLedger& ledger, const dem::World& world, const Stack& stack, const Vec3& direction,
    BaseProfile& profile, MigrationHold& hold
) {
    std::vector<double> base(profile.filter.size());
    std::vector<std::pair<double, double>> in_filter; // depth, mass
    double entered = 0, all = 0, there = 0;
    for (std::size_t k = 0; k < ledger.size(); ++k) {
        const double depth = depth_of(ledger, k, stack, direction);
        const bool has_left = ledger.where[k] == Whereabouts::Eroded;
        all += ledger.where[k] != Whereabouts::Fixed ? ledger.mass[k] : 0;
        entered += has_left || depth > 0 ? ledger.mass[k] : 0;
        if (!has_left) {
            add_sphere(depth, 0.5 * ledger.diameter[k], profile.first, profile.step, base);
            if (depth > 0) {
                in_filter.emplace_back(depth, ledger.mass[k]);
                there += ledger.mass[k];
            }
        }
    }
    profile.base.push_back(divided(std::move(base), slice_volume(world, stack, profile)));
    hold.entered_mass_share = entered / all;
    hold.depth = 0;
    std::ranges::sort(in_filter);
    double passed = 0;
    for (const auto& [depth, mass] : in_filter) {
        hold.depth = depth;
        passed += mass;
        if (passed >= known_share * there) {
            break;
        }
    }
}

} // namespace suffuse::erosion
