#include "suffuse/dem/neighborhood.hpp"

#include "suffuse/base/loop_meter.hpp"
#include "suffuse/base/parallel.hpp"
#include "suffuse/contact/carry_over.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace suffuse::dem {
namespace {

// The wide list costs a search when it runs out, the table costs the law of each of its pairs in every step; both adapt
// to how the grains move. Lengths are in radii of the smallest grain.
constexpr double first_wide_margin = 0.4, least_wide_margin = 0.1, most_wide_margin = 1.5;
constexpr std::int64_t searches_often = 1500; // steps between two searches
constexpr double first_allowance = 2e-3, least_allowance = 1e-4;
constexpr double first_table_steps = 32, least_table_steps = 16, most_table_steps = 128; // a table is meant to last
constexpr double table_cost = 1.5;  // of a table, per pair of the wide list, in pairs that the law looks at (measured)
constexpr double foresight = 1.5;   // speeds change meanwhile
constexpr double soon_out = 0.25;   // of what a grain may move until the list must be made anew: it is found with it
constexpr std::size_t block = 1024; // grains that a thread takes at a time

/// How much a branch of unit length can shrink or grow under the motion `f`.
double strain_of(const Mat3& f) {
    const Mat3 change = f - identity();
    double sum = 0;
    for (const auto& row : change.m) {
        for (const double v : row) {
            sum += v * v;
        }
    }
    return std::sqrt(sum);
}

/// Largest of `value(k)` over [0, rows), at least zero; `at_a_time` rows are a block of work.
template <class Value>
double largest(std::size_t rows, std::size_t at_a_time, Value&& value) {
    return parallel_sum(
        rows, at_a_time, 0.0,
        [&](std::size_t begin, std::size_t end) {
            double most = 0;
            for (std::size_t k = begin; k < end; ++k) {
                most = std::max(most, value(k));
            }
            return most;
        },
        [](double a, double b) { return std::max(a, b); }
    );
}

Place rounded(const Vec3& position) {
    return {static_cast<float>(position.x), static_cast<float>(position.y), static_cast<float>(position.z)};
}

Vec3 position_of(const Place& place) {
    return {place[0], place[1], place[2]};
}

/// How far a place may be from the position that it was rounded from [m].
double rounding_of(const Vec3& position) {
    return std::numeric_limits<float>::epsilon() * (std::abs(position.x) + std::abs(position.y) + std::abs(position.z));
}

/// What the watch measures the places of a domain's grains from.
std::vector<Vec3> domain_origins(const MovingRows& rows) {
    std::vector<Vec3> origin;
    for (std::size_t g = 0; g < rows.size(); g += contact::domain_grains) {
        origin.push_back(xyz(rows[g].position));
    }
    return origin;
}

constexpr double rounded_down = 1 - 2.0 * std::numeric_limits<float>::epsilon();

/// Pairs that do not touch.
template <class Real>
double count_idle(const contact::MemoryOf<Real>& memory) {
    return parallel_sum(memory.overlap.size(), block, 0.0, [&](std::size_t begin, std::size_t end) {
        double idle = 0;
        for (std::size_t c = begin; c < end; ++c) {
            idle += memory.touches(c) ? 0 : 1;
        }
        return idle;
    });
}

template <class Real>
contact::OptionalMemory needed_memory(const grains::Material& m, const contact::MemoryOf<Real>& memory) {
    const bool some_bond =
        std::any_of(memory.bonded.begin(), memory.bonded.end(), [](std::uint8_t bonded) { return bonded != 0; });
    return {m.twisting_stiffness != 0, m.adhesion_normal > 0 || m.adhesion_shear > 0 || some_bond};
}

/// Whether few grains have moved out of the list of a cell `h` that stands, so that their pairs alone are found anew.
/// Large samples have no memory for a second list.
bool can_search_again(const World& world, const Mat3& h, std::span<const std::uint8_t> strayed) {
    constexpr std::size_t few = 4, large = 65'536;
    const auto count = static_cast<std::size_t>(std::ranges::count(strayed, 1));
    return world.cell.h == h && world.cell.velocity_gradient == Mat3{} && count < strayed.size() / few &&
           strayed.size() < large;
}

/// Whether the memory has all that the material needs, and no more.
template <class Real>
bool suits(const contact::MemoryOf<Real>& memory, const grains::Material& material) {
    return contact::optional_memory(memory) == needed_memory(material, memory);
}

} // namespace

bool Neighborhood::holds(const World& world, const contact::SingleMemory* single, const Mat3& h) const {
    // A pair left out had |branch| > (1 + stretch) reach + both allowances. The mean motion shrinks the branch by the
    // strain at most; with strain <= stretch/(1 + stretch) and motions within (1 - stretch) allowance it stays above
    // the reach.
    return valid_ && has_table_ && strain_of(h * inverse_h_) <= stretch_ / (1 + stretch_) &&
           (single != nullptr ? suits(*single, world.material) : suits(world.contacts, world.material));
}

void Neighborhood::update(World& world, const MovingRows& rows, contact::SingleMemory* single, double dt) {
    const MeteredPhase phase("contact table");
    measure_grains(world);
    const std::vector<double> allowance = allow_motion(world, rows, dt);
    const std::vector<std::uint8_t> strayed =
        valid_ ? find_strayed(world, rows, allowance) : std::vector<std::uint8_t>();
    if (!valid_ || !strayed.empty()) {
        const MeteredPhase searching("neighbor search");
        if (valid_ && can_search_again(world, wide_h_, strayed)) {
            search_again(world, rows, strayed);
        } else {
            search(world, rows, allowance);
        }
    }
    make_table(world, rows, single, allowance);
    valid_ = has_table_ = true;
    look_at_sleepers(world, rows);
}

void Neighborhood::look_at_sleepers(const World& world, const MovingRows& rows) {
    if (!valid_) {
        return;
    }
    // Against the mean motion, what nothing pushes keeps its velocity; the hundredth is for what the cell strains.
    const Mat3 motion = mean_motion(world.cell.h);
    const double most_haste = largest(sum_plan_.domains(), 1, [&](std::size_t d) {
        const std::size_t end = std::min(rows.size(), (d + 1) * contact::domain_grains);
        double most = 0;
        for (std::size_t k = sum_plan_.awake_end[d]; k < end; ++k) {
            const std::uint32_t g = sum_plan_.roster[k];
            const Double4 watched = double4(watch_.origin[d], 0) + widened(watch_.grains[g].place);
            const Vec3 position = xyz(rows[g].position);
            const double left = std::sqrt(watched[3]) - norm(position - motion * xyz(watched));
            const double speed = norm(xyz(rows[g].velocity) - world.cell.velocity_gradient * position);
            most = std::max(most, speed > 0 ? speed / std::max(left, 1e-300) : 0);
        }
        return most;
    });
    sleepers_until_ = world.clock.time + 0.99 / most_haste;
}

void Neighborhood::measure_grains(const World& world) {
    if (valid_) {
        return;
    }
    const auto [least, most] = std::minmax_element(world.grains.radius.begin(), world.grains.radius.end());
    smallest_radius_ = world.grains.size() > 0 ? *least : 0;
    largest_radius_ = world.grains.size() > 0 ? *most : 0;
    wide_margin_ = first_wide_margin * smallest_radius_;
    least_allowance_ = first_allowance * smallest_radius_;
    table_steps_ = first_table_steps;
}

void Neighborhood::adapt(double lasted) {
    // Pairs that do not touch grow with the allowances, and those with the time that a table is to last: best is a time
    // in which they cost as much as the table.
    const double idle = std::max(1.0, lasted * idle_pairs_), cost = table_cost * static_cast<double>(pairs_.size());
    table_steps_ *= std::clamp(std::sqrt(cost / idle), 0.8, 1.25);
    table_steps_ = std::clamp(table_steps_, least_table_steps, most_table_steps);
    // A grain in free flight is foreseen that long. A table that it ends leaves all others more than they need.
    if (lasted < table_steps_) {
        least_allowance_ = std::min(1.5 * least_allowance_, 0.1 * wide_margin_);
    } else if (lasted > foresight * table_steps_) {
        least_allowance_ = std::max(0.7 * least_allowance_, least_allowance * smallest_radius_);
    }
}

std::vector<double> Neighborhood::allow_motion(const World& world, const MovingRows& rows, double dt) {
    if (valid_ && has_table_) {
        adapt(static_cast<double>(world.clock.step - near_step_));
    }
    watch_.origin = domain_origins(rows);
    const double seconds = foresight * table_steps_ * dt, most = 0.2 * wide_margin_;
    std::vector<double> allowance(rows.size());
    parallel_for(rows.size(), block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t g = begin; g < end; ++g) {
            const Vec3 position = xyz(rows[g].position);
            const Vec3 fluctuation = xyz(rows[g].velocity) - world.cell.velocity_gradient * position;
            // What the watch cannot distinguish from rest must be little of what it allows.
            const double blur = 8 * rounding_of(position - watch_.origin[g / contact::domain_grains]);
            allowance[g] = std::min(most, std::max(least_allowance_, blur) + seconds * norm(fluctuation));
        }
    });
    stretch_ = least_allowance_ / std::max(largest_radius_, 1e-300) +
               seconds * strain_of(world.cell.velocity_gradient + identity());
    return allowance;
}

std::vector<std::uint8_t>
Neighborhood::find_strayed(const World& world, const MovingRows& rows, const std::vector<double>& allowance) const {
    const Mat3 motion = world.cell.h * inverse(wide_h_);
    const double strain = strain_of(motion);
    const double room = wide_margin_ * (1 - strain) - 2 * (strain + stretch_) * largest_radius_;
    // Of a pair that was sought for the sake of one grain, the other may have moved before as far as is soon out.
    const double patched = room / (2 + soon_out), reach = is_patched_ ? patched : room / 2;
    std::vector<double> moved(rows.size());
    parallel_for(rows.size(), block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t g = begin; g < end; ++g) {
            const Vec3 place = position_of(wide_place_[g]);
            moved[g] = norm(xyz(rows[g].position) - motion * place) + rounding_of(place);
        }
    });
    if (largest(rows.size(), block, [&](std::size_t g) { return moved[g] + allowance[g]; }) < reach) {
        return {};
    }
    std::vector<std::uint8_t> strayed(rows.size());
    for (std::size_t g = 0; g < strayed.size(); ++g) {
        strayed[g] = moved[g] > soon_out * patched || moved[g] + allowance[g] > patched ? 1 : 0;
    }
    return strayed;
}

void Neighborhood::search_again(const World& world, const MovingRows& rows, std::span<const std::uint8_t> strayed) {
    std::vector<Vec3> position(rows.size());
    for (std::size_t g = 0; g < rows.size(); ++g) {
        if (strayed[g] != 0) {
            wide_place_[g] = rounded(xyz(rows[g].position));
        }
        position[g] = xyz(rows[g].position);
    }
    const std::vector<neighbors::Pair> found =
        neighbors::find_pairs_of(strayed, world.cell.h, std::move(position), world.grains.radius, wide_margin_);
    std::vector<neighbors::Pair> pairs;
    pairs.reserve(pairs_.size() + found.size());
    auto next = found.begin();
    pairs_.for_each_of(0, rows.size(), [&](std::size_t, const neighbors::Pair& pair) {
        if (strayed[pair.first] == 0 && strayed[pair.second] == 0) {
            for (; next != found.end() && *next < pair; ++next) {
                pairs.push_back(*next);
            }
            pairs.push_back(pair);
        }
    });
    pairs.insert(pairs.end(), next, found.end());
    pairs_ = {pairs, rows.size()};
    is_patched_ = true;
}

void Neighborhood::search(const World& world, const MovingRows& rows, const std::vector<double>& allowance) {
    if (valid_) {
        const bool too_often = world.clock.step - wide_step_ < searches_often;
        wide_margin_ = std::clamp(
            (too_often ? 1.3 : 0.8) * wide_margin_, least_wide_margin * smallest_radius_,
            most_wide_margin * smallest_radius_
        );
    }
    // What the table needs must be within the list, now that nothing has moved since.
    const double most_allowed = largest(rows.size(), block, [&](std::size_t g) { return allowance[g]; });
    const double needed = 2 * most_allowed + 2 * stretch_ * largest_radius_;
    wide_margin_ = std::max(wide_margin_, 1.5 * needed);
    std::vector<Vec3> position(rows.size());
    wide_place_.resize(rows.size());
    parallel_for(rows.size(), block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t g = begin; g < end; ++g) {
            position[g] = xyz(rows[g].position);
            wide_place_[g] = rounded(position[g]);
        }
    });
    pairs_ = {}; // before the new ones are made, as is what the table makes anew
    watch_.grains = std::vector<WatchedGrain>();
    pairs_ = {neighbors::find_pairs(world.cell.h, std::move(position), world.grains.radius, wide_margin_), rows.size()};
    is_patched_ = false;
    wide_h_ = world.cell.h;
    wide_step_ = world.clock.step;
    ++searches_;
}

void Neighborhood::make_table(
    World& world, const MovingRows& rows, contact::SingleMemory* single, const std::vector<double>& allowance
) {
    const std::vector<double>& radius = world.grains.radius;
    std::vector<std::uint8_t> near(pairs_.size());
    const std::vector<grains::Motion>& motion = world.grains.motion;
    const auto matters = [&](std::uint32_t i, std::uint32_t j) {
        return !leaves_out_held_ || motion[i] == grains::Motion::Free || motion[j] == grains::Motion::Free;
    };
    parallel_for(rows.size(), block, [&](std::size_t begin, std::size_t end) {
        pairs_.for_each_of(begin, end, [&](std::size_t k, const neighbors::Pair& pair) {
            const auto& [i, j, image] = pair;
            const double reach = (1 + stretch_) * (radius[i] + radius[j]) + allowance[i] + allowance[j];
            const Vec3 branch = xyz(rows[j].position) + cell::shift(world.cell.h, image) - xyz(rows[i].position);
            near[k] = norm2(branch) <= reach * reach && matters(i, j) ? 1 : 0;
        });
    });
    const auto carry_over = [&]<class Real>(contact::MemoryOf<Real>& memory) {
        contact::carry_over(world.contacts, memory, pairs_, near, needed_memory(world.material, memory));
        idle_pairs_ = count_idle(memory);
    };
    if (single != nullptr) {
        carry_over(*single);
    } else {
        carry_over(world.contacts);
    }
    std::vector<std::uint8_t> awake(leaves_out_held_ ? rows.size() : 0);
    for (std::size_t g = 0; g < awake.size(); ++g) {
        awake[g] = motion[g] == grains::Motion::Free ? 1 : 0;
    }
    contact::plan_sums(world.contacts, rows.size(), sum_plan_, awake);
    watch_.grains.resize(rows.size());
    parallel_for(rows.size(), block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t g = begin; g < end; ++g) {
            const Vec3 place = xyz(rows[g].position) - watch_.origin[g / contact::domain_grains];
            const double may_move = std::max(0.0, (1 - stretch_) * allowance[g] - rounding_of(place));
            watch_.grains[g] = {narrowed(double4(place, rounded_down * may_move * may_move))};
        }
    });
    near_h_ = world.cell.h;
    inverse_h_ = inverse(world.cell.h);
    near_step_ = world.clock.step;
    ++prunings_;
}

} // namespace suffuse::dem
