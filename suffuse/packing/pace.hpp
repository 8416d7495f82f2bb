#pragma once
// How a protocol drives one burst of a compaction: time step, strain rate, servo and drag, all from the state alone.

#include "suffuse/packing/compact.hpp"

namespace suffuse::packing {

struct Pace {
    dem::StepPlan plan;
    bool holding = false; ///< swift: grains have yet to come to rest against each other
};

Pace choose_pace(
    const dem::World& world, const CompactSpec& spec, const dem::BalanceSpec& balance, const CompactState& state
);

/// Swift: unbalanced force above which a sample is strained the slower, and with which its compaction ends [-].
double swift_calm(const dem::BalanceSpec& balance);

/// Whether the sample carries nearly all of the pressure.
bool is_loaded(const CompactSpec& spec, const CompactState& state);

/// Largest strain rate of all but `swift`, while the cloud carries no load [1/s].
/// @param density of the grains [kg/m3]; @param median_diameter by mass [m]
double largest_rate(const CompactSpec& spec, double density, double median_diameter);

/// The time step that the protocol uses now [s]. @param damping local [-]
double choose_time_step(const dem::World& world, const CompactSpec& spec, double damping);

/// The reference's: a share of the P-wave time of the smallest grain, of radius `smallest` [m] [s].
double slow_time_step(double smallest, const grains::Material& material);

/// Whether grains stick while they are compacted, so that their skeleton collapses when they are let go.
bool adheres_at_first(const CompactSpec& spec);

/// What `wide` lends where nothing collapses. @param spread of the median grain, by mass, over the smallest [-]
dem::Lent lent_to_wide(double spread);

/// The inertia that the protocol lends for this burst.
dem::Lent choose_lent(const dem::World& world, const CompactSpec& spec, const CompactState& state);

} // namespace suffuse::packing
