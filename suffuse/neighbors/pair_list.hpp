#pragma once
// The neighbor list: sorted pairs in little memory, kept between two searches (a Verlet list), for millions of grains.

#include "suffuse/neighbors/pairs.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace suffuse::neighbors {

class PairList {
public:
    PairList() = default;

    /// @param sorted pairs of grains below `grains`
    /// @throws StateError where more than 65,535 different images occur: grains have drifted over that many periods.
    PairList(std::span<const Pair> sorted, std::size_t grains);

    [[nodiscard]] std::size_t size() const { return second_.size(); }

    [[nodiscard]] std::size_t grains() const { return start_.size() - 1; }

    /// Number of the first pair of the first grain `grain`, or of all pairs for `grains()`.
    [[nodiscard]] std::size_t start_of(std::size_t grain) const { return start_[grain]; }

    /// Calls `visit(k, pair)` on the pairs of the first grains `begin` to `end`, in order; `k` counts all pairs.
    template <class Visit>
    void for_each_of(std::size_t begin, std::size_t end, Visit&& visit) const {
        for (std::size_t first = begin; first < end; ++first) {
            for (std::size_t k = start_[first]; k < start_[first + 1]; ++k) {
                visit(k, Pair{static_cast<std::uint32_t>(first), second_[k], images_[image_[k]]});
            }
        }
    }

private:
    std::vector<std::uint32_t> start_{0}; ///< first pair of each first grain, and the end
    std::vector<std::uint32_t> second_;
    std::vector<std::uint16_t> image_; ///< rows of `images_`
    std::vector<cell::Image> images_;  ///< those that occur
};

/// Row of `image` in `images`, where it is put if it is new.
/// @throws StateError as PairList.
std::uint16_t image_row(std::vector<cell::Image>& images, const cell::Image& image);

} // namespace suffuse::neighbors
