#pragma once
// A base and the filter behind it, along the flow, in a cell that is periodic in all directions: where the layers are,
// and which share of the head each takes. Fine grains are the base; all others are held and filter it.

#include "suffuse/dem/world.hpp"
#include "suffuse/flow/seepage.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace suffuse::erosion {

/// Lengths along the flow [m]. Places are of the period that has the base's middle in its own middle.
struct Stack {
    double length = 0;                       ///< of the cell; 0: no stack
    double face = 0;                         ///< where the water enters the base, and the filter ends one period before
    double interface = 0;                    ///< where the filter begins
    double base_grain = 0, filter_grain = 0; ///< the largest [m]
    double exit = 0;                         ///< of a migration: the plane by which base grains leave

    [[nodiscard]] bool is_stack() const { return length > 0; }

    [[nodiscard]] double base_thickness() const { return interface - face; }

    [[nodiscard]] double filter_thickness() const { return face + length - interface; }

    /// Place along the flow, in that period. @param at dot product of a position and the flow's direction
    [[nodiscard]] double place(double at) const;
};

/// `at`, moved by whole periods to [from, from + length).
double moved_into(double at, double from, double length);

/// Volume of the part of a sphere below a plane at `h` above its lowest point [m3].
double cap_volume(double radius, double h);

/// Layers are parted by planes that have as much of the base on one side as of the filter on the other: both are rough.
/// @param direction along an edge of a right-angled cell, from the base into the filter.
/// @throws StateError where fines lie among all coarse grains, so that there are no layers
Stack find_layers(const dem::World& world, const Vec3& direction);

/// A row a grain: 1 for all that are held, the filter and a screen of base grains. Those are nearer to the face where
/// the water enters than the largest of them is wide, or beyond it: no other gets past them into the filter's end.
std::vector<std::uint8_t> held_in_stack(const dem::World& world, const Stack& stack, const Vec3& direction);

/// Over those of the whole sample [-].
struct LayerHeads {
    double base = 1, filter = 1; ///< their gradients
    double interface = 0;        ///< the head that is lost there
};

/// Of the volume of a sphere: its part at the interface, from half of the largest base grain before it to the largest
/// filter grain behind it. @param at dot product of its position and the flow's direction
double share_at_interface(double at, double radius, const Stack& stack);

/// Gradients from the heads of the pores within each layer, by least squares, each with the weight of its water; the
/// two ends of a layer, half of a grain, are left out. The head of the interface is that which pushes the grains there.
/// @param force of the water on each of the grains [N]
LayerHeads layer_heads(
    const flow::Seepage& seepage, const grains::Grains& grains, std::span<const Vec3> force, const Stack& stack,
    const Vec3& direction
);

} // namespace suffuse::erosion
