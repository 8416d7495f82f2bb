#pragma once
// Which contacts the step looks at. Two lists: a wide one from the neighbor search, and from it the table of contacts,
// the pairs that touch or may touch before the list is next looked at. Both are caches, rebuilt from the world; pairs
// that do not touch add exact zeros, so when they are rebuilt changes no bit of the result.

#include "suffuse/contact/forces.hpp"
#include "suffuse/dem/world.hpp"
#include "suffuse/neighbors/pairs.hpp"

#include <cstdint>
#include <vector>

namespace suffuse::dem {

class Neighborhood {
public:
    /// Makes sure that no pair outside `world.contacts` can touch in this step. `moved` is the largest distance that a
    /// grain moved against the mean motion since the table was made (from the last step), see `reference()`.
    void update(World& world, double moved);

    /// Forgets everything: after grains were added, removed or moved by hand.
    void invalidate() { valid_ = false; }

    /// Positions at which the contact table was made, and the cell then.
    [[nodiscard]] const std::vector<Vec3>& reference() const { return near_.position; }

    [[nodiscard]] const Mat3& reference_h() const { return near_.h; }

    [[nodiscard]] const contact::Incidence& incidence() const { return incidence_; }

    [[nodiscard]] std::int64_t searches() const { return searches_; } ///< neighbor searches so far

    [[nodiscard]] std::int64_t prunings() const { return prunings_; } ///< contact tables made so far

    [[nodiscard]] std::size_t candidates() const { return pairs_.size(); } ///< pairs of the wide list

private:
    /// The state at which a list was made, and up to which gap it holds pairs.
    struct Snapshot {
        std::vector<Vec3> position; ///< [m]
        Mat3 h{};                   ///< [m]
        double margin = 0;          ///< [m]
        std::int64_t step = 0;
    };

    void search(const World& world);
    void make_table(World& world);
    [[nodiscard]] bool still_good(const Snapshot& list, const Mat3& h, double moved, double wanted_gap) const;
    void choose_margins(const World& world);

    bool valid_ = false;
    double largest_radius_ = 0, smallest_radius_ = 0;
    Snapshot wide_, near_;
    std::vector<neighbors::Pair> pairs_;
    std::vector<double> spare_column_;
    contact::Incidence incidence_;
    std::int64_t searches_ = 0, prunings_ = 0;
};

} // namespace suffuse::dem
