#include "suffuse/neighbors/pair_list.hpp"

#include "suffuse/base/error.hpp"

#include <algorithm>
#include <limits>

namespace suffuse::neighbors {

PairList::PairList(std::span<const Pair> sorted, std::size_t grains)
    : start_(grains + 1, 0), second_(sorted.size()), image_(sorted.size()) {
    for (std::size_t k = 0; k < sorted.size(); ++k) {
        ++start_[sorted[k].first + 1];
        second_[k] = sorted[k].second;
        image_[k] = image_row(images_, sorted[k].image);
    }
    for (std::size_t g = 0; g < grains; ++g) {
        start_[g + 1] += start_[g];
    }
}

std::uint16_t image_row(std::vector<cell::Image>& images, const cell::Image& image) {
    const auto found = std::ranges::find(images, image); // nearly always among the first few
    const auto row = static_cast<std::size_t>(found - images.begin());
    if (row >= std::numeric_limits<std::uint16_t>::max()) {
        throw StateError(
            "grains have drifted over more periods of the cell than a step can tell apart: wrap their positions into "
            "the cell, or take a smaller time step if the motion has blown up"
        );
    }
    if (found == images.end()) {
        images.push_back(image);
    }
    return static_cast<std::uint16_t>(row);
}

} // namespace suffuse::neighbors
