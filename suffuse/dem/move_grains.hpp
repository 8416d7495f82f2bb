#pragma once
// The second half of the step: each grain collects what contacts and loads exert on it, and moves.

#include "suffuse/contact/sum_plan.hpp"
#include "suffuse/grains/load.hpp"
#include "suffuse/grains/moving_rows.hpp"
#include "suffuse/motion/integrator.hpp"

#include <span>
#include <vector>

namespace suffuse::dem {

/// Where a grain was when the contact table was made, from the origin of its domain and as near as single precision
/// comes to it [m]; in the last lane the square of how far it may be from there, against the mean motion, before the
/// table must be made again [m2].
struct alignas(16) WatchedGrain {
    Float4 place;
};

struct Watch {
    std::vector<WatchedGrain> grains;
    std::vector<Vec3> origin; ///< of each domain of the sum plan: a place near most of its grains [m]
};

/// What moves the grains in one step, for all domains. Points into what it was made of.
struct GrainMove {
    std::size_t grains;
    const std::uint32_t *remote, *remote_start, *roster, *awake_end;
    const Vec3* load;   ///< null: none
    const double* drag; ///< of each grain, over the step's; null: 1
    double load_share;
    const WatchedGrain* watch;
    const Vec3* origin;
    bool only_awake;
    grains::MovingRow* rows;
    grains::GrainSum* sums;
    bool prefetches; ///< for rows that may lie in the cache of another thread
    bool turning, upright;
    motion::LaneMotion motion;
    Double4x3 mean_motion;
    motion::DiagonalMotion upright_motion;
    alignas(double4_alignment) Double4 upright_mean_motion;
};

/// @param only_awake grains in no row of the contact table sleep: `coast_sleepers` moves them later
/// @param turning whether a grain turns: none does where contacts only push
/// @param mean_motion from the cell at which the watch was made to the cell of the next step
GrainMove plan_move(
    const motion::StepMotion& step, const contact::SumPlan& plan, const grains::GrainLoad* load, double load_share,
    bool turning, const Mat3& mean_motion, const Watch& watch, bool only_awake, std::vector<grains::MovingRow>& rows,
    std::vector<grains::GrainSum>& sums
);

/// Collects into the sums of a domain's grains what other domains exert on them, whose rows it sets to zero, adds the
/// load and moves the grains. @return whether one of them is further than the watch allows
bool move_domain(const GrainMove& move, std::size_t domain);

constexpr std::size_t most_slept_steps = 64;

/// Moves the grains that slept through `steps`, at most `most_slept_steps`, to the bits that `move_grains` without load
/// would have given them.
void coast_sleepers(
    std::span<const motion::StepMotion> steps, const contact::SumPlan& plan, std::vector<grains::MovingRow>& rows
);

} // namespace suffuse::dem
