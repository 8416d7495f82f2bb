#include "suffuse/erosion/grain_water.hpp"

#include "suffuse/base/constants.hpp"
#include "suffuse/base/quantile.hpp"
#include "suffuse/flow/pore_velocity.hpp"

#include <algorithm>

namespace suffuse::erosion {
namespace {

/// Drag over Stokes' is taken between these: pores where water rests give no measure of it.
constexpr double least_hindrance = 1, largest_hindrance = 30;

} // namespace

double stokes_rate(double diameter, double mass, double viscosity) {
    return 3 * pi * viscosity * diameter / mass;
}

GrainWater::GrainWater(
    const dem::World& world, std::span<const std::uint8_t> goes, const Vec3& direction, const flow::Fluid& fluid,
    double coarse_permeability, double hindrance_before
)
    : hindrance_(hindrance_before) {
    const grains::Grains& grains = world.grains;
    std::vector<std::uint32_t> standing;
    std::vector<Vec3> position;
    std::vector<double> radius;
    for (std::uint32_t g = 0; g < grains.size(); ++g) {
        if (goes[g] == 0) {
            standing.push_back(g);
            position.push_back(grains.position[g]);
            radius.push_back(grains.radius[g]);
        }
    }
    seepage_ = flow::solve_seepage(world.cell, position, radius, {.gradient = 1, .direction = direction}, fluid);
    flow::limit_to_coarse(seepage_, fluid.conductance, coarse_permeability);
    const pores::Pores& pores = seepage_.network.pores;
    pore_velocity_ = flow::pore_velocities(seepage_.network, position, radius, seepage_.field.flux);
    locator_.emplace(seepage_.network, position);

    force_.resize(grains.size());
    std::vector<Vec3> velocity(grains.size()); // around them, by water
    std::vector<double> water(grains.size());
    for (std::size_t p = 0; p < pores.size(); ++p) {
        const double volume = std::max(0.0, pores.void_volume[p]);
        for (const std::uint32_t row : pores.grain[p]) {
            velocity[standing[row]] += volume * pore_velocity_[p];
            water[standing[row]] += volume;
        }
    }
    std::vector<double> hindrance(grains.size()), of_fines;
    for (std::size_t row = 0; row < standing.size(); ++row) {
        const std::uint32_t g = standing[row];
        force_[g] = seepage_.grain_force[row];
        const double speed = water[g] > 0 ? norm(velocity[g]) / water[g] : 0;
        const double stokes =
            grains.mass[g] * stokes_rate(2 * grains.radius[g], grains.mass[g], fluid.viscosity) * speed;
        if (stokes > 0) {
            hindrance[g] = std::clamp(norm(force_[g]) / stokes, least_hindrance, largest_hindrance);
            if (grains.fine[g] != 0) {
                of_fines.push_back(hindrance[g]);
            }
        }
    }
    if (!of_fines.empty()) {
        hindrance_ = upper_quantile(std::move(of_fines), 0.5);
    }
    mass_ = grains.mass;
    rate_.resize(grains.size());
    for (std::size_t g = 0; g < grains.size(); ++g) {
        const double factor = hindrance[g] > 0 ? hindrance[g] : hindrance_;
        rate_[g] = factor * stokes_rate(2 * grains.radius[g], grains.mass[g], fluid.viscosity);
    }
}

Vec3 GrainWater::velocity_at(const Vec3& place) const {
    return pore_velocity_[locator_->find(place).pore];
}

} // namespace suffuse::erosion
