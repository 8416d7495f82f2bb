#include "suffuse/neighbors/pair_list.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/parallel.hpp"
#include "suffuse/neighbors/number_images.hpp"

#include <algorithm>
#include <limits>

namespace suffuse::neighbors {

PairList::PairList(std::span<const Pair> sorted, std::size_t grains)
    : start_(grains + 1), second_(sorted.size()), image_(sorted.size()) {
    constexpr std::size_t block = 16'384;
    parallel_for(grains + 1, block, [&](std::size_t begin, std::size_t end) {
        auto next = std::ranges::lower_bound(sorted, static_cast<std::uint32_t>(begin), {}, &Pair::first);
        for (std::size_t g = begin; g < end; ++g) {
            next = std::find_if(next, sorted.end(), [g](const Pair& pair) { return pair.first >= g; });
            start_[g] = static_cast<std::uint32_t>(next - sorted.begin());
        }
    });
    parallel_for(sorted.size(), block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            second_[k] = sorted[k].second;
        }
    });
    std::vector<std::uint32_t> run_start;
    for (std::size_t k = 0; k < sorted.size(); k += block) {
        run_start.push_back(static_cast<std::uint32_t>(k));
    }
    run_start.push_back(static_cast<std::uint32_t>(sorted.size()));
    number_images(
        run_start, [&](std::size_t k) { return sorted[k].image; }, image_, images_
    );
}

std::uint16_t image_row(std::vector<cell::Image>& images, const cell::Image& image) {
    const auto found = std::ranges::find(images, image); // nearly always among the first few
    const auto row = static_cast<std::size_t>(found - images.begin());
    if (row >= std::numeric_limits<std::uint16_t>::max()) {
        throw StateError("grains have drifted over more periods of the cell than a step can resolve: wrap their "
                         "positions into the cell, or take a smaller time step if the motion has become unstable");
    }
    if (found == images.end()) {
        images.push_back(image);
    }
    return static_cast<std::uint16_t>(row);
}

} // namespace suffuse::neighbors
