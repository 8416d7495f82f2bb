#pragma once
// What the erosion procedure found, as plain values: the rows behind Figures 9 to 14.

#include "suffuse/base/vec3.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/erosion/ending.hpp"
#include "suffuse/erosion/mobility_result.hpp"
#include "suffuse/flow/known_error.hpp"
#include "suffuse/flow/seepage.hpp"
#include "suffuse/flow/throat_flux.hpp"
#include "suffuse/pores/constrictions.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace suffuse::erosion {

inline constexpr int probe_samples = 10; ///< equal parts of the watch at which the paper's rule reads the speed

/// One probe: every column has a row a fine grain.
struct ProbeResult {
    double gradient = 0;         ///< hydraulic gradient i [-]
    flow::FlowSource flow;       ///< that the forces are of
    double unbalanced_force = 0; ///< of the relaxed state that it started from [-]
    bool reached_floor = false;  ///< the unbalance stopped falling before the wanted one
    std::int64_t relax_steps = 0, ramp = 0, watch = 0;
    double time_step = 0;          ///< [s]
    double fluid_over_contact = 0; ///< mean fluid force on a fine grain / mean contact force [-]
    double signal_over_twin = 0; ///< median speed with fluid / that of the twin, over the fines; infinite: at rest [-]
    double viscous_time = 0;     ///< m/(6 pi mu r) of the median fine grain [s]
    bool beyond_viscous_time = false; ///< ramp and watch last longer: a constant force then overstates motion

    std::vector<std::uint32_t> id;   ///< grain
    std::vector<double> diameter;    ///< [m]
    std::vector<double> fluid_force; ///< magnitude [N]
    std::vector<int> coordination;   ///< contacts in the equilibrium
    /// At full force, and after each tenth of the watch [m/s].
    std::vector<std::array<double, probe_samples + 1>> speed;
    std::vector<double> twin_speed;                         ///< at the end, without fluid [m/s]
    std::vector<double> displacement;                       ///< along the drag, relative to the twin [m]
    std::vector<double> free_speed, free_displacement;      ///< of the same grain without contacts [m/s], [m]
    double twin_noise = 0;                                  ///< quantile of the twin's speeds; judges no grain [m/s]
    std::vector<std::uint8_t> by_velocity, by_displacement; ///< 1: detachable by that rule
    std::array<std::array<std::int64_t, 2>, 2> agreement{}; ///< [by velocity][by displacement] counts
    std::int64_t hidden_by_noise = 0; ///< fines that would be detachable by velocity if the twin were at rest
};

/// The constrictions of the coarse skeleton, one row a facet of its Delaunay triangulation that counts.
using Constrictions = pores::Constrictions;

/// Constrictions of the coarse skeleton by their number and sizes alone [m].
struct ConstrictionSummary {
    std::int64_t count = 0;
    double mean = 0, median = 0, d35 = 0;
};

/// By pores::VoidMerge, whatever way counts: which pores are one void is a matter of definition.
using ConstrictionsByMerge = std::array<ConstrictionSummary, pores::every_merge.size()>;

/// What became of a detached grain that followed the water.
enum class Fate {
    Left,   ///< got far enough
    Lodged, ///< held on its way, and lies there now
    Stayed, ///< held where it was, or all places on its way were filled
};

/// "left", "lodged", "stayed".
constexpr std::string_view name_of(Fate fate) {
    return fate == Fate::Left ? "left" : fate == Fate::Lodged ? "lodged" : "stayed";
}

/// How the detached fines of a pass fared with the water, one row a grain (ConstrictionSize::FlowPath); else empty.
struct Transport {
    double distance = 0;              ///< a grain that got so far along the flow has left [m]
    std::vector<std::uint32_t> id;    ///< grain
    std::vector<double> diameter;     ///< [m]
    std::vector<double> mass;         ///< [kg]
    std::vector<double> travel;       ///< along the flow in this pass, until it left or was held [m]
    std::vector<double> progress;     ///< along the flow since the erosion began, to where it is after the pass [m]
    std::vector<double> path;         ///< in this pass, from throat to throat [m]
    std::vector<int> throats;         ///< passed
    std::vector<double> constriction; ///< diameter of the one that held it; 0 where none did, or it was closed [m]
    std::vector<Fate> fate;

    [[nodiscard]] std::size_t size() const { return id.size(); }
};

/// Mass held over the sum of mass times travel: if each length of the flow held grains with the same chance, the
/// coefficient of an exponential law [Iwasaki1937] by maximum likelihood, grains weighted by their mass, those that
/// left counted as not held yet [1/m]. Nothing where none travelled.
inline std::optional<double> filter_coefficient(const Transport& transport) {
    double held = 0, travelled = 0;
    for (std::size_t k = 0; k < transport.size(); ++k) {
        held += transport.fate[k] == Fate::Left ? 0 : transport.mass[k];
        travelled += transport.mass[k] * std::max(transport.travel[k], 0.0);
    }
    return travelled > 0 ? std::optional(held / travelled) : std::nullopt;
}

/// What happens to the skeleton at a point of a pass's history.
enum class Phase {
    Removal,        ///< the first step without the grains that left
    ConstantVolume, ///< until it rests, or carries nothing
    Servo           ///< under the stresses held before
};

/// "removal", "constant volume", "servo".
constexpr std::string_view name_of(Phase phase) {
    return phase == Phase::Removal ? "removal" : phase == Phase::ConstantVolume ? "constant volume" : "servo";
}

/// Why a grain left: the rule that found it detachable (OwnRule: the caller's), that the water moves it against its
/// weight, or that its class was taken out.
enum class Reason { Velocity, Displacement, Mobile, Forced, Removed, RemovedActive, RemovedInactive, OwnRule };

/// The state of the sample at one point of the history of an erosion pass (Figures 13 and 14).
struct PathRow {
    int pass = 0;
    Phase phase = Phase::Removal;
    std::int64_t step = 0;        ///< since the start of the erosion stage
    Mat3 stress;                  ///< compression positive [Pa]
    double volumetric_strain = 0; ///< since the start of the erosion stage, compression positive [-]
    double porosity = 0;          ///< [-]
    double unbalanced_force = 0;  ///< [-]
    double eroded_mass = 0;       ///< so far, share of the initial mass [-]
};

/// One grain that left.
struct LedgerRow {
    std::uint32_t grain = 0; ///< id
    int pass = 0;            ///< 1-based
    double diameter = 0;     ///< [m]
    double mass = 0;         ///< [kg]
    int coordination = 0;    ///< contacts when it left
    Reason reason = Reason::Velocity;
};

struct PassResult {
    int pass = 0;                           ///< 1-based
    ProbeResult probe;                      ///< with weight: its gradient and flow alone
    std::optional<MobilityResult> mobility; ///< with weight
    Constrictions constrictions;
    pores::VoidMerge merge = pores::VoidMerge::None; ///< of the voids that they lie between
    ConstrictionsByMerge constrictions_by_merge;
    std::int64_t detachable = 0, held_back = 0, removed = 0;
    Transport transport;
    double eroded_mass_percent = 0;                     ///< of the mass before this pass [%]
    double eroded_mass_percent_of_initial = 0;          ///< [%]
    std::map<int, std::int64_t> coordination_histogram; ///< of the removed grains
    Mat3 stress_before, stress_after_removal, stress_constant_volume, stress_after; ///< [Pa]
    double porosity_before = 0, porosity_after_removal = 0, porosity_after = 0;
    double void_ratio_after = 0, fines_content_after = 0;
    double volumetric_strain = 0;                           ///< of this pass, compression positive [-]
    double permeability_before = 0, permeability_after = 0; ///< along the flow [m2]
    flow::FlowSource flow_after;                        ///< that permeability_after is of; before: that of the probe
    double reynolds_before = 0, reynolds_after = 0;     ///< of the water at the gradient, flow/reynolds.hpp [-]
    flow::ClosedVoids closed_voids;                     ///< after the pass, of grains by id
    double tortuosity_before = 0, tortuosity_after = 0; ///< of its ways, flow/pore_velocity.hpp [-]
    flow::ThroatFlux throat_flux_before, throat_flux_after; ///< how the flow spreads over the throats
    std::int64_t steps = 0;
    double time_step = 0;                       ///< of the last of them [s]
    std::map<std::string, double> wall_seconds; ///< by part: "relax", "flow", "probe", "constrictions" ...
    bool failed = false;                        ///< the skeleton does not carry its stresses any more
    bool reached_target = false;                ///< as much has left as was specified, whatever the verdict
    Ending verdict;
};

struct ErosionResult {
    std::vector<PassResult> passes;
    std::vector<LedgerRow> ledger;
    std::vector<PathRow> path;
    double initial_mass = 0; ///< [kg]
};

/// Share of the mean stress lost at constant volume [-]; nothing where there was no stress to lose.
inline std::optional<double> stress_loss(const PassResult& pass) {
    const double before = dem::mean_stress(pass.stress_before);
    return before > 0 ? std::optional(1 - dem::mean_stress(pass.stress_constant_volume) / before) : std::nullopt;
}

/// Mass that left in all passes, of the initial mass [%].
inline double eroded_percent(const ErosionResult& erosion) {
    double percent = 0;
    for (const PassResult& pass : erosion.passes) {
        percent += pass.eroded_mass_percent_of_initial;
    }
    return percent;
}

/// The first pass that lost the largest share of the mean stress; null where none had stress to lose.
inline const PassResult* pass_of_largest_loss(const ErosionResult& erosion) {
    const PassResult* worst = nullptr;
    for (const PassResult& pass : erosion.passes) {
        if (stress_loss(pass) && (worst == nullptr || *stress_loss(pass) > *stress_loss(*worst))) {
            worst = &pass;
        }
    }
    return worst;
}

/// Permeability after the last pass over that before the first [-]; nothing where one of the two was not measured.
inline std::optional<double> permeability_change(const ErosionResult& erosion) {
    if (erosion.passes.empty()) {
        return std::nullopt;
    }
    const double before = erosion.passes.front().permeability_before, after = erosion.passes.back().permeability_after;
    return before > 0 && after > 0 ? std::optional(after / before) : std::nullopt;
}

/// A permeability that changes by less stays as it was, in words.
inline constexpr double least_permeability_change = 0.005;

} // namespace suffuse::erosion
