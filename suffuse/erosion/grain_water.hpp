#pragma once
// The water as a grain meets it that may move: its force on those that stand in its way, its velocity where others go
// with it, and the rate at which it drags each. All at a hydraulic gradient of 1.

#include "suffuse/dem/world.hpp"
#include "suffuse/flow/fluid.hpp"
#include "suffuse/flow/seepage.hpp"
#include "suffuse/pores/locate.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace suffuse::erosion {

/// Stokes' drag over mass and velocity: the rate at which still water brakes a sphere [1/s].
double stokes_rate(double diameter, double mass, double viscosity);

class GrainWater {
public:
    /// Solves the flow among the grains that stand. @param goes 1 for a grain that does not resist, a row a grain
    /// @param direction of the flow
    /// @param coarse_permeability of the coarse grains alone [m2], which by bounded drag limits it
    /// @param hindrance of the flow before, for where no fine grain stands
    /// @throws as flow::solve_seepage
    GrainWater(
        const dem::World& world, std::span<const std::uint8_t> goes, const Vec3& direction, const flow::Fluid& fluid,
        double coarse_permeability, double hindrance = 1
    );

    /// Along the flow [m2].
    [[nodiscard]] double permeability() const { return seepage_.permeability; }

    [[nodiscard]] const flow::Seepage& seepage() const { return seepage_; }

    /// Mean velocity in the pore at a place [m/s].
    [[nodiscard]] Vec3 velocity_at(const Vec3& place) const;

    /// Velocity at which the water would not push standing grain `g`: its force at rest over mass and rate [m/s].
    [[nodiscard]] Vec3 velocity(std::uint32_t g) const { return force_[g] / (mass_[g] * rate_[g]); }

    /// On standing grain `g` while it rests [N].
    [[nodiscard]] const Vec3& force(std::uint32_t g) const { return force_[g]; }

    /// The same of every grain of the world; 0 for those that do not stand.
    [[nodiscard]] std::span<const Vec3> forces() const { return force_; }

    /// At which the motion of grain `g` relative to that velocity is braked [1/s]. Of a grain that stands: its force at
    /// rest over the mean velocity of the water around it, at least Stokes'; of others Stokes' times `hindrance`.
    [[nodiscard]] double rate(std::uint32_t g) const { return rate_[g]; }

    /// Drag over Stokes', of the median fine grain that stands; that of the flow before where none does [-].
    [[nodiscard]] double hindrance() const { return hindrance_; }

private:
    flow::Seepage seepage_;
    std::vector<Vec3> pore_velocity_;
    std::vector<Vec3> force_; ///< of the world's grains, as the following
    std::vector<double> mass_, rate_;
    double hindrance_;
    std::optional<pores::PoreLocator> locator_;
};

} // namespace suffuse::erosion
