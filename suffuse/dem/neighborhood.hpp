#pragma once
// Which contacts the step looks at. Two lists: a wide one from the neighbor search, and from it the table of contacts:
// the pairs that touch, and those whose two grains may come to touch before the table is made again, each grain at its
// own speed. Both are caches, made from the world; pairs that do not touch add exact zeros, so when they are made
// changes no bit of the result.

#include "suffuse/contact/sum_plan.hpp"
#include "suffuse/dem/move_grains.hpp"
#include "suffuse/dem/world.hpp"
#include "suffuse/neighbors/pair_list.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace suffuse::dem {

/// Where a grain was, as near as single precision comes to it [m].
using Place = std::array<float, 3>;

using MovingRows = std::vector<grains::MovingRow>;

class Neighborhood {
public:
    /// Whether no pair outside the contact table can touch in a cell `h`, as long as no grain has moved further than
    /// `watch()` allows and the memory that the material needs is there.
    [[nodiscard]] bool holds(const World& world, const contact::SingleMemory* single, const Mat3& h) const;

    /// Makes the contact table of `world`, whose grains are where `rows` say. @param single where the contacts' memory
    /// is if the world's contacts do not have it, else null; @param dt time step [s]
    void update(World& world, const MovingRows& rows, contact::SingleMemory* single, double dt);

    /// Forgets everything: after grains were added, removed or moved by hand.
    void invalidate() { valid_ = false; }

    /// Forgets the table, but not the wide list: after grains were held or set free.
    void forget_table() { has_table_ = false; }

    /// Leaves pairs of two held grains out of the table, where only moving grains matter: neither the stress nor
    /// the forces on held grains are then whole. Of all grains, only held ones sleep.
    void leave_out_held_pairs() { leaves_out_held_ = true; }

    [[nodiscard]] bool leaves_out_held_pairs() const { return leaves_out_held_; }

    [[nodiscard]] const Watch& watch() const { return watch_; }

    /// Computes anew how long the grains in no row of the table stay within their watch if nothing pushes them.
    void look_at_sleepers(const World& world, const MovingRows& rows);

    /// Time of the world until which they do [s].
    [[nodiscard]] double sleepers_until() const { return sleepers_until_; }

    /// Whether none moves in a cell that stands.
    [[nodiscard]] bool all_sleepers_stand() const { return std::isinf(sleepers_until_); }

    /// Mean motion from the cell at which the table was made to the cell `h`.
    [[nodiscard]] Mat3 mean_motion(const Mat3& h) const { return h * inverse_h_; }

    [[nodiscard]] const contact::SumPlan& sum_plan() const { return sum_plan_; }

    [[nodiscard]] double largest_radius() const { return largest_radius_; } ///< of all grains [m]

    [[nodiscard]] std::int64_t searches() const { return searches_; } ///< neighbor searches so far

    [[nodiscard]] std::int64_t prunings() const { return prunings_; } ///< contact tables made so far

private:
    void measure_grains(const World& world);
    void adapt(double lasted);
    [[nodiscard]] std::vector<double> allow_motion(const World& world, const MovingRows& rows, double dt);
    [[nodiscard]] std::vector<std::uint8_t>
    find_strayed(const World& world, const MovingRows& rows, const std::vector<double>& allowance) const;
    void search_again(const World& world, const MovingRows& rows, std::span<const std::uint8_t> strayed);
    void search(const World& world, const MovingRows& rows, const std::vector<double>& allowance);
    void make_table(
        World& world, const MovingRows& rows, contact::SingleMemory* single, const std::vector<double>& allowance
    );

    bool valid_ = false, has_table_ = false;
    bool leaves_out_held_ = false;
    double smallest_radius_ = 0, largest_radius_ = 0;

    // The wide list: all pairs with a gap up to the margin, when it was made.
    neighbors::PairList pairs_;
    std::vector<Place> wide_place_; ///< of each grain
    Mat3 wide_h_{};
    double wide_margin_ = 0;  ///< [m]
    bool is_patched_ = false; ///< some pairs were sought later than others
    std::int64_t wide_step_ = 0;

    // The contact table: what a grain may move and the cell may stretch while it holds.
    double table_steps_ = 0;     ///< that it is meant to last
    double idle_pairs_ = 0;      ///< of the table, that did not touch when it was made
    double least_allowance_ = 0; ///< of a grain at rest [m]
    double stretch_ = 0;         ///< of a branch, by the mean motion [-]
    Watch watch_;
    double sleepers_until_ = 0; ///< [s]
    Mat3 near_h_{}, inverse_h_{};
    std::int64_t near_step_ = 0;

    contact::SumPlan sum_plan_;
    std::int64_t searches_ = 0, prunings_ = 0;
};

} // namespace suffuse::dem
