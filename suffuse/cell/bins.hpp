#pragma once
// The periodic cell cut into equal bins along its three vectors, and which of them a box reaches into across its faces.

#include "suffuse/cell/cell.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace suffuse::cell {

struct Bins {
    std::array<std::int32_t, 3> along{1, 1, 1}; ///< how many along each cell vector

    [[nodiscard]] std::size_t count() const { return row(along[0] - 1, along[1] - 1, along[2] - 1) + 1; }

    /// The bin of a point of the cell, given in fractions of its vectors [-]; rounding may have put it on the far face.
    [[nodiscard]] std::size_t bin_of(const Vec3& fraction) const {
        const auto cut = [&](int a) {
            const std::int32_t n = along[static_cast<std::size_t>(a)];
            return std::clamp(static_cast<std::int32_t>(fraction[a] * n), 0, n - 1);
        };
        return row(cut(0), cut(1), cut(2));
    }

    /// Calls visit(bin, period) for every bin that the box from `low` to `high` [-] reaches into, moved home by the
    /// period that the box meets it in; once more for each further period.
    template <class Visit>
    void for_each(const Vec3& low, const Vec3& high, Visit&& visit) const {
        any_of(low, high, [&](std::size_t bin, const Image& period) {
            visit(bin, period);
            return false;
        });
    }

    /// Whether one of those bins is `wanted`(bin, period); the search ends there.
    template <class Wanted>
    bool any_of(const Vec3& low, const Vec3& high, Wanted&& wanted) const {
        const Reach reach[] = {reach_of(low, high, 0), reach_of(low, high, 1), reach_of(low, high, 2)};
        for (Place i = reach[0].first; i.index <= reach[0].last; i.move_on(along[0])) {
            for (Place j = reach[1].first; j.index <= reach[1].last; j.move_on(along[1])) {
                for (Place k = reach[2].first; k.index <= reach[2].last; k.move_on(along[2])) {
                    if (wanted(row(i.home, j.home, k.home), Image{i.period, j.period, k.period})) {
                        return true;
                    }
                }
            }
        }
        return false;
    }

private:
    /// A bin along one vector, counted on beyond the faces of the cell: where it is at home, and in which period it is.
    struct Place {
        std::int32_t index, period, home;

        Place(std::int32_t i, std::int32_t n)
            : index(i), period(i >= 0 ? i / n : -((n - 1 - i) / n)), home(i - period * n) {}

        void move_on(std::int32_t n) {
            ++index;
            if (++home == n) {
                home = 0, ++period;
            }
        }
    };

    struct Reach {
        Place first;
        std::int32_t last;
    };

    [[nodiscard]] Reach reach_of(const Vec3& low, const Vec3& high, int a) const {
        const std::int32_t n = along[static_cast<std::size_t>(a)];
        const auto floor_of = [&](double s) { return static_cast<std::int32_t>(std::floor(s * n)); };
        return {Place(floor_of(low[a]), n), floor_of(high[a])};
    }

    [[nodiscard]] std::size_t row(std::int32_t i, std::int32_t j, std::int32_t k) const {
        return (static_cast<std::size_t>(i) * static_cast<std::size_t>(along[1]) + static_cast<std::size_t>(j)) *
                   static_cast<std::size_t>(along[2]) +
               static_cast<std::size_t>(k);
    }
};

} // namespace suffuse::cell
