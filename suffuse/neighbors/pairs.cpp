#include "suffuse/neighbors/pairs.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/parallel.hpp"
#include "suffuse/base/prefix_sum.hpp"
#include "suffuse/neighbors/grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

namespace suffuse::neighbors {
namespace {

constexpr double rounding_slack = 1e-9; // of a cell: fractions are rounded, the searched range must not be

Pair ordered(std::uint32_t i, std::uint32_t j, const cell::Image& image) {
    return i <= j ? Pair{i, j, image} : Pair{j, i, -image};
}

class Search {
public:
    /// @param sought a 1 for each grain that all its pairs are sought of; empty: all pairs of all
    Search(
        const Mat3& h, std::span<const double> radius, const HomePositions& home, std::vector<Grid> grids,
        double margin, std::span<const std::uint8_t> sought
    )
        : h_(h), width_(cell::widths(h)), radius_(radius), home_(home), grids_(std::move(grids)), margin_(margin),
          sought_(sought) {
        for (const double r : radius) {
            largest_ = std::max(largest_, r);
        }
    }

    /// Appends the pairs of grain `i` with grains of its own class (once a pair) and with larger grains; if it is
    /// sought, with all (once a pair of two that are).
    void collect(std::uint32_t i, std::vector<Pair>& pairs) const {
        if (!sought_.empty() && sought_[i] == 0) {
            return;
        }
        const int own = size_class(radius_[i], largest_);
        const int last = sought_.empty() ? own : static_cast<int>(grids_.size()) - 1;
        for (int c = 0; c <= last; ++c) {
            const Grid& grid = grids_[static_cast<std::size_t>(c)];
            if (!grid.grain.empty()) {
                collect_from(grid, i, c == own, pairs);
            }
        }
    }

private:
    void collect_from(const Grid& grid, std::uint32_t i, bool own_class, std::vector<Pair>& pairs) const {
        const double reach = radius_[i] + grid.largest_radius + margin_;
        const Vec3& s = home_.fraction[i];
        const Vec3 span = Vec3{reach / width_.x, reach / width_.y, reach / width_.z} + rounding_slack * Vec3{1, 1, 1};
        grid.bins.for_each(s - span, s + span, [&](std::size_t bin, const cell::Image& period) {
            test_bin(grid, bin, period, i, own_class, pairs);
        });
    }

    void test_bin(
        const Grid& grid, std::size_t bin, const cell::Image& period, std::uint32_t i, bool own_class,
        std::vector<Pair>& pairs
    ) const {
        const Vec3 origin = home_.position[i] - cell::shift(h_, period);
        for (std::uint32_t k = grid.start[bin]; k < grid.start[bin + 1]; ++k) {
            const std::uint32_t j = grid.grain[k];
            const bool is_met_twice = sought_.empty() ? own_class : sought_[j] != 0;
            if (is_met_twice && (j < i || (j == i && period <= cell::Image{}))) {
                continue;
            }
            const double limit = radius_[i] + radius_[j] + margin_;
            if (norm2(home_.position[j] - origin) > limit * limit) {
                continue;
            }
            pairs.push_back(ordered(i, j, period - home_.period[j] + home_.period[i]));
        }
    }

    Mat3 h_;
    Vec3 width_;
    std::span<const double> radius_;
    const HomePositions& home_;
    std::vector<Grid> grids_;
    double margin_;
    std::span<const std::uint8_t> sought_;
    double largest_ = 0;
};

/// Sorts by counting on `first`, then within each short row: linear in the number of pairs.
std::vector<Pair> sorted(std::vector<std::vector<Pair>> blocks, std::size_t grains) {
    const auto for_each_block = [&](auto&& visit) {
        parallel_for(blocks.size(), 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t b = begin; b < end; ++b) {
                visit(blocks[b]);
            }
        });
    };
    const auto take_one = [](std::uint32_t& count) {
        return std::atomic_ref(count).fetch_add(1, std::memory_order_relaxed);
    };
    std::vector<std::uint32_t> start(grains + 1, 0);
    for_each_block([&](const std::vector<Pair>& block) {
        for (const Pair& pair : block) {
            take_one(start[pair.first]);
        }
    });
    std::vector<Pair> pairs(sum_before(std::span(start)));
    std::vector<std::uint32_t> next = start;
    for_each_block([&](std::vector<Pair>& block) {
        for (const Pair& pair : block) {
            pairs[take_one(next[pair.first])] = pair;
        }
        block = std::vector<Pair>(); // as large as what it was copied to
    });
    parallel_for(grains, 1024, [&](std::size_t begin, std::size_t end) {
        for (std::size_t g = begin; g < end; ++g) {
            std::sort(pairs.begin() + start[g], pairs.begin() + start[g + 1]);
        }
    });
    return pairs;
}

void check_input(const Mat3& h, std::span<const Vec3> position) {
    if (!(determinant(h) > 0)) {
        throw GeometryError(fmt::format("the periodic cell has the volume {} m3; it must be positive", determinant(h)));
    }
    const Mat3 inverse_h = inverse(h);
    const auto is_finite = [&](std::size_t g) {
        const auto& [x, y, z] = position[g];
        return std::isfinite(x) && std::isfinite(y) && std::isfinite(z);
    };
    const auto is_refused = [&](std::size_t g) { return !is_finite(g) || !cell::has_period(inverse_h, position[g]); };
    const std::size_t first = parallel_sum(
        position.size(), 4096, position.size(),
        [&](std::size_t begin, std::size_t end) {
            while (begin < end && !is_refused(begin)) {
                ++begin;
            }
            return begin < end ? begin : position.size();
        },
        [](std::size_t a, std::size_t b) { return std::min(a, b); }
    );
    if (first == position.size()) {
        return;
    }
    if (!is_finite(first)) {
        throw GeometryError(
            fmt::format("the position of grain row {} is not finite: the motion has become unstable", first)
        );
    }
    throw GeometryError(fmt::format(
        "grain row {} lies more than {} periods from the origin: wrap the positions into the cell", first,
        cell::largest_period
    ));
}

/// Periods in which a grain within `reach` [m] may be, both grains inside the cell. @param width of the cell [m]
std::vector<cell::Image> images_within(double reach, const Vec3& width) {
    const int na = static_cast<int>(reach / width.x) + 1, nb = static_cast<int>(reach / width.y) + 1;
    const int nc = static_cast<int>(reach / width.z) + 1;
    std::vector<cell::Image> images;
    for (int a = -na; a <= na; ++a) {
        for (int b = -nb; b <= nb; ++b) {
            for (int c = -nc; c <= nc; ++c) {
                images.push_back({a, b, c});
            }
        }
    }
    return images;
}

/// Unsorted, in blocks of the grains that they were found from.
std::vector<std::vector<Pair>> collect_pairs(
    const Mat3& h, std::vector<Vec3> position, std::span<const double> radius, double margin,
    std::span<const std::uint8_t> sought
) {
    const std::size_t grains = position.size();
    const HomePositions home = bring_home(h, std::move(position));
    const Search search(h, radius, home, build_grids(h, home, radius, margin), margin, sought);
    constexpr std::size_t block = 512;
    std::vector<std::vector<Pair>> blocks((grains + block - 1) / block);
    parallel_for(grains, block, [&](std::size_t begin, std::size_t end) {
        std::vector<Pair>& pairs = blocks[begin / block];
        if (sought.empty()) {
            pairs.reserve(4 * (end - begin));
        }
        for (std::size_t i = begin; i < end; ++i) {
            search.collect(static_cast<std::uint32_t>(i), pairs);
        }
    });
    return blocks;
}

} // namespace

std::vector<Pair> find_pairs(const Mat3& h, std::vector<Vec3> position, std::span<const double> radius, double margin) {
    return find_pairs_of({}, h, std::move(position), radius, margin);
}

std::vector<Pair> find_pairs_of(
    std::span<const std::uint8_t> sought, const Mat3& h, std::vector<Vec3> position, std::span<const double> radius,
    double margin
) {
    check_input(h, position);
    return sorted(collect_pairs(h, std::move(position), radius, margin, sought), radius.size());
}

std::vector<Pair>
find_pairs_exhaustively(const Mat3& h, std::span<const Vec3> position, std::span<const double> radius, double margin) {
    const HomePositions home = bring_home(h, {position.begin(), position.end()});
    const Vec3 width = cell::widths(h);
    std::vector<Pair> pairs;
    for (std::uint32_t i = 0; i < position.size(); ++i) {
        for (std::uint32_t j = i; j < position.size(); ++j) {
            const double reach = radius[i] + radius[j] + margin;
            for (const cell::Image& image : images_within(reach, width)) {
                const Vec3 d = home.position[j] + cell::shift(h, image) - home.position[i];
                const bool is_new = i != j || image > cell::Image{}; // a grain and its image: once
                if (is_new && norm2(d) <= reach * reach) {
                    pairs.push_back({i, j, image - home.period[j] + home.period[i]});
                }
            }
        }
    }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

} // namespace suffuse::neighbors
