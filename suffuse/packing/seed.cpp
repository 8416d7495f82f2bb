#include "suffuse/packing/seed.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/random.hpp"
#include "suffuse/packing/insertion_grid.hpp"
#include "suffuse/packing/overlaps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace suffuse::packing {
namespace {

/// Random positions in a cube, largest grain first: the first free place of a limited number of tries, or the best of
/// them.
std::vector<Vec3> scatter(std::span<const double> radius, double edge, std::uint64_t seed, const Pulse& pulse) {
    constexpr int most_tries = 64;                // beyond, pushing apart is cheaper than trying on
    constexpr std::uint32_t grains_a_beat = 4096; // some tens of milliseconds
    InsertionGrid grid(edge, radius);
    std::vector<Vec3> position(radius.size());
    for (std::uint32_t g = 0; g < radius.size(); ++g) {
        if (g % grains_a_beat == 0) {
            beat(pulse, "scatter", g);
        }
        RandomStream random(seed, "cloud", g);
        double least = edge;
        for (int k = 0; k < most_tries && least > 0; ++k) {
            const double x = random.uniform(0, edge), y = random.uniform(0, edge), z = random.uniform(0, edge);
            const double overlap = grid.deepest_overlap({x, y, z}, radius[g], std::max(0.0, least));
            if (overlap < least) {
                least = overlap;
                position[g] = {x, y, z};
            }
        }
        grid.insert(g, position[g]);
    }
    return position;
}

double edge_at(std::span<const double> radius, double porosity) {
    double solid = 0;
    for (std::size_t g = radius.size(); g-- > 0;) {
        solid += sphere_volume(radius[g]);
    }
    return std::cbrt(solid / (1 - porosity));
}

/// The least porosity, in steps, at which overlaps can be cleared starting from these positions.
double reachable_porosity(std::span<const double> radius, std::vector<Vec3> position, double edge, double porosity) {
    constexpr double step = 0.02;
    for (int k = 1; porosity + k * step < 1; ++k) {
        const double looser = porosity + k * step;
        const double wider = edge_at(radius, looser);
        for (Vec3& x : position) {
            x *= wider / edge;
        }
        edge = wider;
        if (clear_overlaps(diagonal({edge, edge, edge}), radius, position)) {
            return looser;
        }
    }
    return 1;
}

void check_request(const grains::SampledGrains& sample, const PackSpec& spec, double edge) {
    const double porosity = spec.porosity;
    if (!(porosity > 0 && porosity < 1)) {
        throw CaseError(fmt::format("cloud: porosity {:.6g} found, expected between 0 and 1", porosity));
    }
    const double widest = 2 * sample.radius.front();
    if (edge < 2 * widest) {
        const double needed = std::ceil(static_cast<double>(sample.radius.size()) * std::pow(2 * widest / edge, 3));
        throw CaseError(fmt::format(
            "cloud: {} particles at porosity {:.3g} fill a cell of {:.6g} mm, narrower than two of the largest grain "
            "({:.6g} mm); take at least {:.0f} particles, or cut the coarse end of the grading",
            sample.radius.size(), porosity, edge * 1e3, widest * 1e3, needed
        ));
    }
}

} // namespace

Cloud make_cloud(
    const grains::SampledGrains& sample, const PackSpec& spec, double density, std::uint64_t seed, const Pulse& pulse
) {
    expects(!sample.radius.empty() && sample.fine.size() == sample.radius.size(), "a sample has a flag for each grain");
    expects(std::ranges::is_sorted(sample.radius, std::greater<>()), "a sample comes largest first");
    const double edge = edge_at(sample.radius, spec.porosity);
    check_request(sample, spec, edge);
    std::vector<Vec3> position = scatter(sample.radius, edge, seed, pulse);
    const Mat3 h = diagonal({edge, edge, edge});
    if (!clear_overlaps(h, sample.radius, position, default_rounds, pulse)) {
        throw CaseError(fmt::format(
            "cloud: {} particles cannot be placed at porosity {:.3g} without overlaps; {:.3g} can be reached, and "
            "compaction does the rest",
            sample.radius.size(), spec.porosity, reachable_porosity(sample.radius, position, edge, spec.porosity)
        ));
    }
    Cloud cloud;
    cloud.cell.h = h;
    const Mat3 inverse_h = inverse(h);
    for (std::size_t g = 0; g < position.size(); ++g) {
        grains::add_grain(cloud.grains, cell::wrapped(h, inverse_h, position[g]), sample.radius[g], density);
        cloud.grains.fine[g] = sample.fine[g];
    }
    return cloud;
}

} // namespace suffuse::packing
