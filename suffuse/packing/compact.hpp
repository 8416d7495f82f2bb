#pragma once
// Isotropic compaction of a cloud to a pressure: under a lowered friction or with adhesion, then with the final
// parameters until settled. Four protocols (spec.hpp): `slow` is the reference's own (its section 4: strain rate
// capped in three steps as the load builds up, inertial servo), `faithful` follows it with fewer steps, `swift` is the
// quickest, `wide` is `faithful` for wide gradings.

#include "suffuse/dem/lent_inertia.hpp"
#include "suffuse/dem/settle.hpp"
#include "suffuse/packing/spec.hpp"

#include <cstdint>

namespace suffuse::packing {

/// Far from touching: here `faithful` and `wide` make their first step, unless grains adhere [-].
inline constexpr double open_porosity = 0.50;

/// What a swift sample gives, of porosity, from where its grains are pushed together to a pressure of 100 kPa or so
/// [-].
inline constexpr double swift_settling = 0.002;

inline double porosity_of(double void_ratio) {
    return void_ratio / (1 + void_ratio);
}

/// Where a compaction stands; part of what a checkpoint saves.
struct CompactState {
    enum class Phase : std::int32_t {
        Relax,   ///< swift: overlaps that geometry left are pressed out, frictionless, at constant volume
        Compact, ///< to the pressure, with the parameters of the preparation
        Settle,  ///< until balanced, with the final parameters
        Prove,   ///< with the grains' own inertia, for as long as [balance] requires
        Done
    };

    Phase phase = Phase::Compact;
    dem::BalanceState balance;
    double time_step = 0;                ///< of the bursts now [s]
    std::int64_t known_contacts = 0;     ///< touching when it was chosen
    grains::Material material;           ///< with the final parameters
    double damping = dem::usual_damping; ///< local [-]
    dem::Mode mode = dem::Mode::Reference;
    double median_diameter = 0;      ///< by mass [m]
    double start_porosity = 0;       ///< when the first step was made [-]
    dem::Lent lent;                  ///< inertia that grains have beyond their own
    std::int64_t steps = 0;          ///< in all
    double void_ratio_compacted = 0; ///< at the end of compaction, before the final parameters
};

/// Sets the parameters of the compaction and brings the grains to its start; `world` is the cloud.
/// @throws StateError when a start is requested that is too dense for the protocol.
CompactState
begin_compaction(dem::World& world, const CompactSpec& spec, double damping, dem::Mode mode = dem::Mode::Reference);

/// The same for grains that stand already, and have their final parameters: they only have to settle.
CompactState begin_settling(dem::World& world, double damping, dem::Mode mode = dem::Mode::Reference);

/// Whether a balanced sample is known to miss the specified void ratio, before it has proved its balance.
bool misses_void_ratio(const dem::World& world, const CompactSpec& spec, const CompactState& state);

/// One burst of steps. @return whether the sample is settled at the pressure with its final parameters.
/// @throws StateError when the pressure is out of reach, with the void ratio and the pressure reached.
bool compact_burst(
    dem::World& world, dem::StepCaches& caches, const CompactSpec& spec, const dem::BalanceSpec& balance,
    CompactState& state
);

/// What an interrupted compaction owes a world that lives on: the final material, and the grains' own inertia. Caches
/// of the world hold copies of what changes.
void give_back(dem::World& world, const CompactState& state);

} // namespace suffuse::packing
