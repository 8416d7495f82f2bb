#include "suffuse/erosion/rest_under_weight.hpp"

#include "suffuse/erosion/mobility_bounds.hpp"

namespace suffuse::erosion {
namespace {

// In units of WeightScale::time; measured against longer ones in docs/theory/weight.md.
constexpr double rest_burst = 5, longest_rest = 200;

} // namespace

Rest rest_under_weight(WeighedCopy& copy, const Pulse& pulse) {
    Rest rest{.ended = copy.free_count() == 0, .moving = std::vector<std::uint8_t>(copy.fines().size(), 1)};
    copy.load({}, 0);
    while (!rest.ended && rest.took < longest_rest) {
        const std::vector<Vec3> before = copy.positions();
        copy.hold(rest_burst, pulse, "rest");
        rest.took += rest_burst;
        std::int64_t count = 0;
        for (std::size_t k = 0; k < before.size(); ++k) {
            const double diameter = 2 * copy.world().grains.radius[copy.fines()[k]];
            rest.moving[k] = moves_in_rest(norm(copy.position(k) - before[k]), diameter) ? 1 : 0;
            count += rest.moving[k];
        }
        rest.ended = are_resting(count, copy.free_count());
    }
    return rest;
}

} // namespace suffuse::erosion
