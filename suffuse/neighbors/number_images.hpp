#pragma once
// Images of pairs as numbers of two bytes: few different ones occur.

#include "suffuse/base/parallel.hpp"
#include "suffuse/neighbors/pair_list.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace suffuse::neighbors {

/// Numbers the images of rows in runs, each run on a thread: run r has the rows from run_start[r] to run_start[r + 1].
/// The home period is number 0.
/// @param image_of of a row; @param number of each row, as many as there are rows; @param images by number
/// @throws StateError as PairList.
template <class ImageOf>
void number_images(
    std::span<const std::uint32_t> run_start, ImageOf&& image_of, std::vector<std::uint16_t>& number,
    std::vector<cell::Image>& images
) {
    const std::size_t runs = run_start.size() - 1;
    const auto for_each_row = [&](auto&& visit) {
        parallel_for(runs, 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t r = begin; r < end; ++r) {
                for (std::size_t k = run_start[r]; k < run_start[r + 1]; ++k) {
                    visit(r, k);
                }
            }
        });
    };
    std::vector<std::vector<cell::Image>> met(runs, {cell::Image{}}); // each run has numbers of its own first
    for_each_row([&](std::size_t r, std::size_t k) { number[k] = image_row(met[r], image_of(k)); });
    images.assign(1, cell::Image{});
    std::vector<std::vector<std::uint16_t>> common(runs);
    for (std::size_t r = 0; r < runs; ++r) {
        for (const cell::Image& image : met[r]) {
            common[r].push_back(image_row(images, image));
        }
    }
    for_each_row([&](std::size_t r, std::size_t k) { number[k] = common[r][number[k]]; });
}

} // namespace suffuse::neighbors
