#pragma once
// Which way detached fines go. Each follows the water through the pores between the grains that stay, from throat to
// throat, until it has got far enough or meets a constriction no wider than itself: a network model of filtration with
// complete mixing in the pores [LeeKoplik2001], on the sample's own pores.

#include "suffuse/base/random.hpp"
#include "suffuse/base/vec3.hpp"
#include "suffuse/dem/world.hpp"
#include "suffuse/flow/fluid.hpp"
#include "suffuse/flow/seepage.hpp"
#include "suffuse/pores/locate.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace suffuse::erosion {

/// One grain's way with the water.
struct Journey {
    std::uint32_t row = 0;              ///< of the grain table
    double travel = 0;                  ///< along the flow [m]
    double path = 0;                    ///< from throat to throat [m]
    int throats = 0;                    ///< passed
    std::optional<double> constriction; ///< diameter of the one that holds it; nothing where it got far enough [m]
    /// Where a grain that is held may lie: in front of the constriction, then in the throats that it came through, the
    /// last one first. Empty where it passed none [m].
    std::vector<Vec3> places;
};

/// The grains that stay, and the water between them under a hydraulic gradient along one direction.
class WaterWays {
public:
    /// @param leaving rows of the grains that the water takes along
    /// @param direction of the flow
    /// @throws GeometryError, SolverError, as flow::solve_seepage
    WaterWays(
        const dem::World& world, std::span<const std::uint32_t> leaving, const Vec3& direction, const flow::Fluid& fluid
    );

    /// Follows the water from `start` until a grain of this diameter is held, or has travelled `distance` along the
    /// flow [m]. In each pore chance takes it to a throat in proportion to the throat's flux. Pressure falls on the
    /// way: it comes to an end. The row is left open.
    [[nodiscard]] Journey follow(const Vec3& start, double diameter, double distance, RandomStream chance) const;

    /// The flow that it follows, among the grains that stay.
    [[nodiscard]] const flow::Seepage& seepage() const { return seepage_; }

    /// The diameter that passes each throat [m].
    [[nodiscard]] std::span<const double> widths() const { return width_; }

private:
    /// A body of water in one of its images.
    struct Place {
        std::uint32_t body = 0;
        cell::Image image;
    };

    /// The way out of a body through a throat.
    struct Outlet {
        std::uint32_t throat;
        std::uint8_t side;    ///< of the throat that the water leaves
        double flux_up_to_it; ///< sum over the body's outlets to this one [m3/s]
    };

    [[nodiscard]] std::span<const Outlet> outlets(std::uint32_t body) const;
    [[nodiscard]] cell::Image image_of_throat(const Outlet& outlet, const Place& place) const;
    [[nodiscard]] Place behind(const Outlet& outlet, const cell::Image& throat) const;
    [[nodiscard]] Vec3 place_before(const Outlet& outlet, const cell::Image& throat, double radius) const;

    [[nodiscard]] std::vector<double> widths_of_throats() const;
    [[nodiscard]] double circle_of(std::size_t t) const; ///< that touches its three grains: the radius [m]

    std::vector<Vec3> position_; ///< of the grains that stay [m]
    std::vector<double> radius_; ///< [m]
    Vec3 direction_;             ///< of length 1
    flow::Seepage seepage_;
    pores::PoreLocator locator_;
    std::vector<double> width_;        ///< of throats [m]
    std::vector<std::uint32_t> first_; ///< outlets of body b are [first_[b], first_[b + 1])
    std::vector<Outlet> outlet_;
};

/// One that the water detached, and how far it may still go before it has left.
struct Traveller {
    std::uint32_t row = 0;
    double distance = 0; ///< along the flow [m]
};

/// Lets all of them travel through the pores between the other grains. The same grain goes the same way at the same
/// step of the world, whatever the number of threads.
std::vector<Journey> follow_the_water(
    const dem::World& world, std::span<const Traveller> travellers, const Vec3& direction, const flow::Fluid& fluid
);

/// The center of a sphere of radius `own` that touches three spheres, on the side of their plane that `upstream` points
/// to; in the plane where it is too small to touch all three [m].
Vec3 touching_place(
    const std::array<Vec3, 3>& center, const std::array<double, 3>& radius, double own, const Vec3& upstream
);

} // namespace suffuse::erosion
