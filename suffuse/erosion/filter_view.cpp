#include "suffuse/erosion/filter_view.hpp"

#include "suffuse/erosion/base_profile.hpp"
#include "suffuse/grains/gradation.hpp"
#include "suffuse/pores/network.hpp"
#include "suffuse/pores/widest_path.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace suffuse::erosion {
namespace {

constexpr std::size_t most_sizes = 8; ///< classes of the base, of equal mass

/// Unit vectors of a right-angled cell and its width along each.
struct Side {
    Vec3 along;
    double width = 0; ///< [m]
};

Side side_of(const Mat3& h, int axis) {
    const Vec3 edge = h.column(axis);
    return {edge / norm(edge), norm(edge)};
}

/// Diameter of the largest sphere that gets through the held grains along the flow [m]; 0 where none does.
double controlling_constriction(const dem::World& world, const Vec3& direction) {
    std::vector<Vec3> position;
    std::vector<double> radius;
    for (std::size_t g = 0; g < world.grains.size(); ++g) {
        if (world.grains.fine[g] == 0) {
            position.push_back(world.grains.position[g]);
            radius.push_back(world.grains.radius[g]);
        }
    }
    const pores::PoreNetwork network = pores::build_network(world.cell.h, position, radius);
    const std::vector<double> path = pores::widest_paths(network, pores::axis_along(world.cell.h, direction));
    return path.empty() ? 0 : std::max(0.0, *std::ranges::max_element(path));
}

/// Of the mass of the grains that count: free ones, and finer than a gap [-].
double eroded_share(const MigrationLedger& ledger, const std::optional<double>& gap) {
    double all = 0, eroded = 0;
    for (std::size_t k = 0; k < ledger.size(); ++k) {
        if (ledger.where[k] != Whereabouts::Fixed && (!gap || ledger.diameter[k] <= *gap)) {
            all += ledger.mass[k];
            eroded += ledger.where[k] == Whereabouts::Eroded ? ledger.mass[k] : 0;
        }
    }
    return all > 0 ? eroded / all : 0;
}

BaseSizes share_by_size(const MigrationLedger& ledger, const Stack& stack, const Vec3& direction) {
    std::vector<std::size_t> free;
    double all = 0;
    for (std::size_t k = 0; k < ledger.size(); ++k) {
        if (ledger.where[k] != Whereabouts::Fixed) {
            free.push_back(k);
            all += ledger.mass[k];
        }
    }
    std::ranges::sort(free, [&](std::size_t a, std::size_t b) {
        return std::pair(ledger.diameter[a], ledger.id[a]) < std::pair(ledger.diameter[b], ledger.id[b]);
    });
    BaseSizes sizes;
    double so_far = 0, mass = 0, weighted = 0, entered = 0, eroded = 0;
    for (const std::size_t k : free) {
        const bool has_left = ledger.where[k] == Whereabouts::Eroded;
        so_far += ledger.mass[k];
        mass += ledger.mass[k];
        weighted += ledger.mass[k] * ledger.diameter[k];
        eroded += has_left ? ledger.mass[k] : 0;
        entered += has_left || depth_of(ledger, k, stack, direction) > 0 ? ledger.mass[k] : 0;
        const double wanted = static_cast<double>(sizes.diameter.size() + 1) / static_cast<double>(most_sizes);
        constexpr double rounding = 1e-9;
        if (so_far >= (wanted - rounding) * all || k == free.back()) {
            sizes.diameter.push_back(weighted / mass);
            sizes.mass_share.push_back(mass / all);
            sizes.entered.push_back(entered / mass);
            sizes.eroded.push_back(eroded / mass);
            mass = weighted = entered = eroded = 0;
        }
    }
    return sizes;
}

} // namespace

StackCut cut_stack(const dem::World& world, const Stack& stack, const Vec3& direction) {
    const int axis = pores::axis_along(world.cell.h, direction);
    const Side across = side_of(world.cell.h, (axis + 1) % 3), normal = side_of(world.cell.h, (axis + 2) % 3);
    const Vec3 along = direction / norm(direction);
    StackCut cut;
    cut.width = across.width;
    for (std::size_t g = 0; g < world.grains.size(); ++g) {
        const Vec3& x = world.grains.position[g];
        const double r = world.grains.radius[g];
        const double off = moved_into(dot(x, normal.along), 0, normal.width) - 0.5 * normal.width;
        if (std::abs(off) >= r) {
            continue;
        }
        const bool is_base = world.grains.fine[g] != 0;
        // Of the base, what lies in the rough end of the filter has come the other way: from there it leaves.
        const double first = is_base ? stack.face - stack.filter_grain : stack.interface - 0.5 * stack.filter_grain;
        cut.along.push_back(moved_into(dot(x, along), first, stack.length) - stack.interface);
        cut.across.push_back(moved_into(dot(x, across.along), 0, across.width));
        cut.radius.push_back(std::sqrt(r * r - off * off));
        cut.is_base.push_back(is_base ? 1 : 0);
    }
    return cut;
}

FilterView
view_filter(const dem::World& world, const Stack& stack, const Vec3& direction, const std::optional<double>& base_gap) {
    constexpr double fine_end = 0.15, coarse_end = 0.85;
    FilterView view;
    view.filter_d15 = grains::size_at(grains::measure_gradation_of(world.grains, false), fine_end);
    const grains::Gradation base = grains::measure_gradation_of(world.grains, true);
    view.base_gap = base_gap;
    view.base_d85 = grains::size_at(base, coarse_end * (view.base_gap ? grains::passing(base, *view.base_gap) : 1));
    view.constriction = controlling_constriction(world, direction);
    view.before = view.after = cut_stack(world, stack, direction);
    return view;
}

void look_again(
    const MigrationLedger& ledger, const dem::World& world, const Stack& stack, const Vec3& direction, FilterView& view
) {
    view.after = cut_stack(world, stack, direction);
    view.sizes = share_by_size(ledger, stack, direction);
    view.passed = eroded_share(ledger, view.base_gap);
    view.largest_eroded = 0;
    for (std::size_t k = 0; k < ledger.size(); ++k) {
        const bool has_left = ledger.where[k] == Whereabouts::Eroded;
        view.largest_eroded = std::max(view.largest_eroded, has_left ? ledger.diameter[k] : 0);
    }
}

} // namespace suffuse::erosion
