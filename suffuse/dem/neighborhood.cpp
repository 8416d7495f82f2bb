#include "suffuse/dem/neighborhood.hpp"

#include "suffuse/base/parallel.hpp"
#include "suffuse/contact/carry_over.hpp"

#include <algorithm>
#include <cmath>

namespace suffuse::dem {
namespace {

// Margins, in radii of the smallest grain. The wide list costs a search when it runs out, the table costs a test of
// each of its pairs in every step; both adapt to how fast the grains move.
constexpr double first_wide_margin = 0.4, least_wide_margin = 0.1, most_wide_margin = 1.5;
constexpr double first_near_margin = 0.02, least_near_margin = 0.004;
constexpr std::int64_t seldom = 800, often = 100; // steps between two tables
constexpr std::int64_t searches_often = 1500;     // steps between two searches

/// How much a branch of unit length can shrink or grow under the mean motion from `old_h` to `h`.
double strain_between(const Mat3& old_h, const Mat3& h) {
    const Mat3 f = h * inverse(old_h) - identity();
    double sum = 0;
    for (const auto& row : f.m) {
        for (const double v : row) {
            sum += v * v;
        }
    }
    return std::sqrt(sum);
}

double largest_fluctuation(const std::vector<Vec3>& old, const Mat3& motion, const std::vector<Vec3>& now) {
    const double square = parallel_sum(
        now.size(), 2048, 0.0,
        [&](std::size_t begin, std::size_t end) {
            double most = 0;
            for (std::size_t g = begin; g < end; ++g) {
                most = std::max(most, norm2(now[g] - motion * old[g]));
            }
            return most;
        },
        [](double a, double b) { return std::max(a, b); }
    );
    return std::sqrt(square);
}

contact::OptionalMemory needed_memory(const World& world) {
    const grains::Material& m = world.material;
    const bool some_bond =
        std::any_of(world.contacts.bonded.begin(), world.contacts.bonded.end(), [](std::uint8_t bonded) {
            return bonded != 0;
        });
    return {m.twisting_stiffness != 0, m.adhesion_normal > 0 || m.adhesion_shear > 0 || some_bond};
}

} // namespace

bool Neighborhood::still_good(const Snapshot& list, const Mat3& h, double moved, double wanted_gap) const {
    // A pair left out had a gap above the margin. The mean motion shrinks its branch by the strain at most, and the two
    // grains come nearer by what both moved against it.
    const double strain = strain_between(list.h, h);
    return list.margin * (1 - strain) > 2 * moved + 2 * strain * largest_radius_ + wanted_gap;
}

void Neighborhood::update(World& world, double moved) {
    const Mat3& h = world.cell.h;
    if (valid_ && still_good(near_, h, moved, 0) && contact::optional_memory(world.contacts) == needed_memory(world)) {
        return;
    }
    choose_margins(world);
    const bool wide_enough =
        valid_ &&
        still_good(
            wide_, h, largest_fluctuation(wide_.position, h * inverse(wide_.h), world.grains.position), near_.margin
        );
    if (!wide_enough) {
        search(world);
    }
    make_table(world);
    valid_ = true;
}

void Neighborhood::choose_margins(const World& world) {
    if (!valid_) {
        const auto [least, most] = std::minmax_element(world.grains.radius.begin(), world.grains.radius.end());
        smallest_radius_ = world.grains.size() > 0 ? *least : 0;
        largest_radius_ = world.grains.size() > 0 ? *most : 0;
        wide_.margin = first_wide_margin * smallest_radius_;
        near_.margin = first_near_margin * smallest_radius_;
        return;
    }
    const std::int64_t lasted = world.clock.step - near_.step;
    if (lasted < often) {
        near_.margin = std::min(1.6 * near_.margin, 0.4 * wide_.margin);
    }
    if (lasted > seldom) {
        near_.margin = std::max(0.7 * near_.margin, least_near_margin * smallest_radius_);
    }
}

void Neighborhood::search(const World& world) {
    if (valid_) {
        const bool too_often = world.clock.step - wide_.step < searches_often;
        wide_.margin = std::clamp(
            (too_often ? 1.3 : 0.8) * wide_.margin, least_wide_margin * smallest_radius_,
            most_wide_margin * smallest_radius_
        );
        near_.margin = std::min(near_.margin, 0.4 * wide_.margin);
    }
    pairs_ = {}; // before the new ones are made
    pairs_ = neighbors::find_pairs(world.cell.h, world.grains.position, world.grains.radius, wide_.margin);
    wide_.position = world.grains.position;
    wide_.h = world.cell.h;
    wide_.step = world.clock.step;
    ++searches_;
}

void Neighborhood::make_table(World& world) {
    const auto& grains = world.grains;
    constexpr std::size_t block = 4096;
    std::vector<std::vector<neighbors::Pair>> blocks((pairs_.size() + block - 1) / block);
    parallel_for(pairs_.size(), block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            const auto& [i, j, image] = pairs_[k];
            const double reach = grains.radius[i] + grains.radius[j] + near_.margin;
            const Vec3 branch = grains.position[j] + cell::shift(world.cell.h, image) - grains.position[i];
            if (norm2(branch) <= reach * reach) {
                blocks[begin / block].push_back(pairs_[k]);
            }
        }
    });
    std::vector<neighbors::Pair> close;
    for (auto& part : blocks) {
        close.insert(close.end(), part.begin(), part.end());
        part = {};
    }
    contact::carry_over(world.contacts, close, needed_memory(world), spare_column_);
    contact::index_contacts(world.contacts, grains.size(), incidence_);
    near_.position = grains.position;
    near_.h = world.cell.h;
    near_.step = world.clock.step;
    ++prunings_;
}

} // namespace suffuse::dem
