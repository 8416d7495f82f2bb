#include "suffuse/dem/move_grains.hpp"

#include "suffuse/base/clones.hpp"
#include "suffuse/base/parallel.hpp"

#include <algorithm>
#include <array>

namespace suffuse::dem {
namespace {

/// Adds to the grains of domain `d` what other domains exert on them, in the order of the table.
[[gnu::always_inline]] inline void collect(const GrainMove& w, std::size_t d) {
    constexpr std::uint32_t ahead = 24;
    const std::uint32_t end = w.remote_start[d + 1];
    for (std::uint32_t k = w.remote_start[d]; k < end; ++k) {
        if (w.prefetches) {
            __builtin_prefetch(&w.sums[w.grains + std::min(k + ahead, end - 1)], 1);
        }
        grains::GrainSum &share = w.sums[w.grains + k], &sum = w.sums[w.remote[k]];
        sum.force += share.force;
        sum.torque += share.torque;
        share = {};
    }
}

/// 1 for a grain that moves as it is pushed, 0 for one that is held: those have no inverse mass.
[[gnu::always_inline]] inline Double4 is_free(const grains::MovingRow& row) {
    return broadcast<3>(row.position) > Double4{} ? Double4{} + 1.0 : Double4{};
}

/// By how much the grain's squared motion exceeds what the watch allows, in the first lane [m2].
template <class Matrix>
[[gnu::always_inline]] inline Double4
excess(const Matrix& mean_motion, const Double4& watched, const Double4& position) {
    const Double4 moved = position - mean_motion * watched;
    const Double4 square = moved * moved;
    return square + broadcast<1>(square) + broadcast<2>(square) - broadcast<3>(watched);
}

template <bool Turning, class Matrix>
[[gnu::always_inline]] inline void
move_tile(const motion::MotionOf<Double4, Matrix>& motion, const GrainMove& w, std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
        const std::uint32_t g = w.roster[k];
        const grains::GrainSum& sum = w.sums[g];
        grains::MovingRow& row = w.rows[g];
        const Double4 force = w.load == nullptr ? sum.force : sum.force + w.load_share * double4(w.load[g], 0);
        Double4 position = row.position, velocity = row.velocity;
        const Double4 inverse_mass = broadcast<3>(position), inverse_inertia = broadcast<3>(velocity);
        const Double4 free = w.drag == nullptr ? is_free(row) : w.drag[g] * is_free(row);
        motion::shift(motion, inverse_mass * force, free, position, velocity);
        row.position = with_last_of(position, row.position);
        row.velocity = with_last_of(velocity, row.velocity);
        if constexpr (Turning) {
            Double4 spin = row.spin;
            motion::spin_on(motion, inverse_inertia * sum.torque, free, spin);
            row.spin = with_last_of(spin, row.spin);
        }
    }
}

/// Prefetches grains: others look at some of them while they press, and have them in their cache.
[[gnu::always_inline]] inline void prefetch_rows(const GrainMove& w, std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
        const auto* row = reinterpret_cast<const char*>(&w.rows[w.roster[k]]);
        __builtin_prefetch(row, 1);
        __builtin_prefetch(row + sizeof(grains::MovingRow) - 1, 1);
    }
}

/// By tiles: what one grain takes from its force to its watch is a long chain, and two loops keep the processor busier
/// with several grains than one.
template <bool Turning, class Matrix>
[[gnu::always_inline]] inline bool move_in_tiles(
    const motion::MotionOf<Double4, Matrix>& motion, const Matrix& mean_motion, const GrainMove& w, std::size_t d
) {
    constexpr std::size_t tile_grains = 64;
    collect(w, d);
    const Double4 origin = double4(w.origin[d], 0);
    Double4 most = Double4{} - 1.0;
    const std::size_t end = w.only_awake ? w.awake_end[d] : std::min(w.grains, (d + 1) * contact::domain_grains);
    for (std::size_t tile = d * contact::domain_grains; tile < end; tile += tile_grains) {
        const std::size_t tile_end = std::min(end, tile + tile_grains);
        if (w.prefetches) {
            prefetch_rows(w, tile_end, std::min(end, tile_end + tile_grains));
        }
        move_tile<Turning>(motion, w, tile, tile_end);
        for (std::size_t k = tile; k < tile_end; ++k) {
            const std::uint32_t g = w.roster[k];
            const Double4 over = excess(mean_motion, origin + widened(w.watch[g].place), w.rows[g].position);
            most = over > most ? over : most;
        }
    }
    return most[0] > 0;
}

SUFFUSE_CLONES bool move_in_any_cell(const GrainMove& w, std::size_t d) {
    return move_in_tiles<true>(w.motion, w.mean_motion, w, d);
}

SUFFUSE_CLONES bool move_in_upright_cell(const GrainMove& w, std::size_t d) {
    return move_in_tiles<true>(w.upright_motion, w.upright_mean_motion, w, d);
}

SUFFUSE_CLONES bool shift_in_upright_cell(const GrainMove& w, std::size_t d) {
    return move_in_tiles<false>(w.upright_motion, w.upright_mean_motion, w, d);
}

/// The sleepers of a domain, four side by side through all the steps.
template <class Matrix>
[[gnu::always_inline]] inline void coast_domain(
    std::span<const motion::MotionOf<Double4, Matrix>> steps, const std::uint32_t* roster, std::size_t begin,
    std::size_t end, grains::MovingRow* rows
) {
    constexpr std::size_t side = 4;
    for (std::size_t k = begin; k < end; k += side) {
        std::array<grains::MovingRow, side> row{};
        std::array<Double4, side> free{};
        for (std::size_t q = 0; q < side; ++q) {
            row[q] = rows[roster[std::min(k + q, end - 1)]];
            free[q] = is_free(row[q]);
        }
        for (const motion::MotionOf<Double4, Matrix>& step : steps) {
            for (std::size_t q = 0; q < side; ++q) {
                motion::coast(step, free[q], row[q].position, row[q].velocity, row[q].spin);
            }
        }
        for (std::size_t q = 0; q < std::min(side, end - k); ++q) {
            grains::MovingRow& to = rows[roster[k + q]];
            to = {
                with_last_of(row[q].position, to.position), with_last_of(row[q].velocity, to.velocity),
                with_last_of(row[q].spin, to.spin)};
        }
    }
}

SUFFUSE_CLONES void coast_in_any_cell(
    std::span<const motion::LaneMotion> steps, const std::uint32_t* roster, std::size_t begin, std::size_t end,
    grains::MovingRow* rows
) {
    coast_domain(steps, roster, begin, end, rows);
}

SUFFUSE_CLONES void coast_in_upright_cell(
    std::span<const motion::DiagonalMotion> steps, const std::uint32_t* roster, std::size_t begin, std::size_t end,
    grains::MovingRow* rows
) {
    coast_domain(steps, roster, begin, end, rows);
}

} // namespace

GrainMove plan_move(
    const motion::StepMotion& step, const contact::SumPlan& plan, const grains::GrainLoad* load, double load_share,
    bool turning, const Mat3& mean_motion, const Watch& watch, bool only_awake, std::vector<grains::MovingRow>& rows,
    std::vector<grains::GrainSum>& sums
) {
    const bool loaded = load != nullptr && !load->force.empty();
    return {
        .grains = rows.size(),
        .remote = plan.remote.data(),
        .remote_start = plan.remote_start.data(),
        .roster = plan.roster.data(),
        .awake_end = plan.awake_end.data(),
        .load = loaded ? load->force.data() : nullptr,
        .drag = load != nullptr && !load->drag.empty() ? load->drag.data() : nullptr,
        .load_share = load_share,
        .watch = watch.grains.data(),
        .origin = watch.origin.data(),
        .only_awake = only_awake,
        .rows = rows.data(),
        .sums = sums.data(),
        .prefetches = thread_count() > 1,
        .turning = turning,
        .upright = is_diagonal(step.old_gradient) && is_diagonal(step.change) && is_diagonal(mean_motion),
        .motion = motion::in_lanes(step),
        .mean_motion = double4x3(mean_motion),
        .upright_motion = motion::in_diagonals(step),
        .upright_mean_motion = double4_diagonal(mean_motion)};
}

bool move_domain(const GrainMove& move, std::size_t domain) {
    if (!move.upright) {
        return move_in_any_cell(move, domain);
    }
    return move.turning ? move_in_upright_cell(move, domain) : shift_in_upright_cell(move, domain);
}

void coast_sleepers(
    std::span<const motion::StepMotion> steps, const contact::SumPlan& plan, std::vector<grains::MovingRow>& rows
) {
    const bool upright = std::ranges::all_of(steps, [](const motion::StepMotion& step) {
        return is_diagonal(step.old_gradient) && is_diagonal(step.change);
    });
    std::array<motion::LaneMotion, most_slept_steps> any{};
    std::array<motion::DiagonalMotion, most_slept_steps> diagonal{};
    std::ranges::transform(steps, any.begin(), motion::in_lanes);
    std::ranges::transform(steps, diagonal.begin(), motion::in_diagonals);
    parallel_for(plan.domains(), 1, [&](std::size_t first, std::size_t last) {
        for (std::size_t d = first; d < last; ++d) {
            const std::size_t begin = plan.awake_end[d], end = std::min(plan.grains, (d + 1) * contact::domain_grains);
            if (upright) {
                coast_in_upright_cell({diagonal.data(), steps.size()}, plan.roster.data(), begin, end, rows.data());
            } else {
                coast_in_any_cell({any.data(), steps.size()}, plan.roster.data(), begin, end, rows.data());
            }
        }
    });
}

} // namespace suffuse::dem
