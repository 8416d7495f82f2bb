#include "suffuse/packing/skeleton_first.hpp"

#include "suffuse/base/random.hpp"
#include "suffuse/dem/order.hpp"
#include "suffuse/neighbors/pairs.hpp"
#include "suffuse/packing/compact.hpp"
#include "suffuse/packing/overlaps.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace suffuse::packing {
namespace {

constexpr double crowded_porosity = 0.38; // to which overlaps of spheres clear without forces
constexpr double widening_step = 1.005;   // of each edge
constexpr int most_widenings = 150;

/// By how much the fines are larger while room is sought for them.
double swelling() {
    return std::cbrt((1 - crowded_porosity) / (1 - open_porosity));
}

/// Fines on their way into the voids.
class Places {
public:
    Places(const Mat3& h, const grains::Grains& coarse, std::vector<double> radius, std::uint64_t seed)
        : radius_(std::move(radius)), position_(radius_.size()) {
        for (std::size_t g = 0; g < radius_.size(); ++g) {
            random_.emplace_back(seed, "fines into voids", g);
        }
        std::vector<std::uint32_t> all(radius_.size());
        std::iota(all.begin(), all.end(), 0U);
        scatter(h, coarse, std::move(all));
    }

    /// Pushes the fines apart around coarse grains that stay. A few that found no room where they were sent are sent
    /// elsewhere. @return whether none touches another grain.
    bool clear(const Mat3& h, const grains::Grains& coarse) {
        constexpr int most_rounds = 60, most_sendings = 8;
        constexpr double few = 0.02; // of the fines: more of them need a wider cell
        for (int k = 0; k < most_sendings; ++k) {
            std::vector<Vec3> all = coarse.position;
            all.insert(all.end(), position_.begin(), position_.end());
            std::vector<double> radius = coarse.radius;
            radius.insert(radius.end(), radius_.begin(), radius_.end());
            const bool is_clear = clear_overlaps_around(h, radius, all, coarse.size(), most_rounds);
            position_.assign(all.begin() + static_cast<std::ptrdiff_t>(coarse.size()), all.end());
            if (is_clear) {
                return true;
            }
            std::vector<std::uint32_t> homeless = touched(coarse.size(), neighbors::find_pairs(h, all, radius, 0));
            if (static_cast<double>(homeless.size()) > few * static_cast<double>(radius_.size())) {
                return false;
            }
            scatter(h, coarse, std::move(homeless));
        }
        return false;
    }

    void scale(double factor) {
        for (Vec3& x : position_) {
            x *= factor;
        }
    }

    [[nodiscard]] const std::vector<Vec3>& positions() const { return position_; }

private:
    /// The fines of these pairs, of two the second, in order.
    static std::vector<std::uint32_t> touched(std::size_t coarse, const std::vector<neighbors::Pair>& pairs) {
        std::vector<std::uint32_t> fines;
        for (const neighbors::Pair& pair : pairs) {
            if (pair.second >= coarse) {
                fines.push_back(pair.second - static_cast<std::uint32_t>(coarse));
            }
        }
        std::ranges::sort(fines);
        fines.erase(std::unique(fines.begin(), fines.end()), fines.end());
        return fines;
    }

    /// Sends fines to where they reach into no coarse grain, as far as a limited number of tries goes.
    void scatter(const Mat3& h, const grains::Grains& coarse, std::vector<std::uint32_t> homeless) {
        constexpr int most_tries = 64;
        for (int k = 0; k < most_tries && !homeless.empty(); ++k) {
            std::vector<Vec3> tried = coarse.position;
            std::vector<double> size = coarse.radius;
            for (const std::uint32_t g : homeless) {
                const double a = random_[g].uniform(), b = random_[g].uniform(), c = random_[g].uniform();
                position_[g] = h * Vec3{a, b, c};
                tried.push_back(position_[g]);
                size.push_back(radius_[g]);
            }
            std::vector<neighbors::Pair> pairs = neighbors::find_pairs(h, tried, size, 0);
            std::erase_if(pairs, [&](const neighbors::Pair& pair) { return pair.first >= coarse.size(); });
            std::vector<std::uint32_t> still = touched(coarse.size(), pairs);
            for (std::uint32_t& row : still) {
                row = homeless[row];
            }
            homeless = std::move(still);
        }
    }

    std::vector<double> radius_; ///< with the distance that each keeps [m]
    std::vector<Vec3> position_; ///< [m]
    std::vector<RandomStream> random_;
};

/// The edges, over those of the skeleton, in which swollen fines would be as crowded as spheres alone can be. With
/// coarse grains between them they need more.
double least_widening(const dem::World& skeleton, std::span<const double> swollen) {
    double fines = 0;
    for (const double r : swollen) {
        fines += sphere_volume(r);
    }
    const double needed = grains::solid_volume(skeleton.grains) + fines / (1 - crowded_porosity);
    return std::max(1.0, std::cbrt(needed / cell::volume(skeleton.cell)));
}

/// The cell and all that lies in it, larger; contacts are lost.
void widen(dem::World& world, double factor) {
    if (factor == 1) {
        return;
    }
    world.cell.h = factor * world.cell.h;
    world.cell.velocity_gradient = {};
    for (std::size_t g = 0; g < world.grains.size(); ++g) {
        world.grains.position[g] *= factor;
        world.grains.velocity[g] = world.grains.spin[g] = {};
        world.grains.force[g] = world.grains.torque[g] = {};
    }
    world.contacts = {};
}

void add_fines(dem::World& world, const grains::Grains& fines, std::span<const Vec3> position) {
    const double density = world.material.density;
    for (std::size_t g = 0; g < fines.size(); ++g) {
        const std::uint32_t row = grains::add_grain(world.grains, position[g], fines.radius[g], density);
        world.grains.id[row] = fines.id[g];
        world.grains.fine[row] = 1;
        world.grains.velocity[row] = world.cell.velocity_gradient * position[g]; // at rest in the cell
    }
}

} // namespace

grains::Grains take_out_fines(dem::World& world) {
    std::vector<std::uint32_t> rows;
    for (std::uint32_t g = 0; g < world.grains.size(); ++g) {
        if (world.grains.fine[g] != 0) {
            rows.push_back(g);
        }
    }
    grains::Grains fines = world.grains;
    grains::select_rows(fines, rows);
    dem::remove_grains(world, rows);
    return fines;
}

Placing put_into_voids(dem::World& world, const grains::Grains& fines) {
    std::vector<double> swollen;
    for (const double r : fines.radius) {
        swollen.push_back(swelling() * r);
    }
    Placing placing{least_widening(world, swollen), false};
    widen(world, placing.widening);
    Places places(world.cell.h, world.grains, std::move(swollen), world.seed);
    for (int k = 0; k < most_widenings; ++k) {
        placing.touch_none = places.clear(world.cell.h, world.grains);
        if (placing.touch_none) {
            break;
        }
        widen(world, widening_step);
        placing.widening *= widening_step;
        places.scale(widening_step);
    }
    add_fines(world, fines, places.positions());
    return placing;
}

} // namespace suffuse::packing
