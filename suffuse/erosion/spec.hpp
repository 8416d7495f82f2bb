#pragma once
// Settings of the erosion procedure, section 4 of the paper.

#include "suffuse/base/constants.hpp"
#include "suffuse/base/vec3.hpp"
#include "suffuse/dem/inertial_number.hpp"
#include "suffuse/dem/spec.hpp"
#include "suffuse/flow/fluid.hpp"
#include "suffuse/pores/voids.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace suffuse::erosion {

/// `[gravity]`: what gives the fines of a probe their weight. It must be said where down is.
struct Gravity {
    Vec3 down = {0, 0, -1};                 ///< of length 1
    double acceleration = suffuse::gravity; ///< [m/s2]
};

/// How fines of weight move, and when they count as mobile; docs/theory/weight.md says what each choice changes.
struct WeighedMotion {
    double hold_at_most = 100; ///< of a gradient under which motion does not end, in units of WeightScale::time [-]
    double fluid_drag = 1;     ///< factor on the viscous drag of WeightScale [-]
    double moved = 0.5;        ///< along the flow, beyond which a grain is mobile: out of its place at rest [diameters]
    double softness = 1e-3;    ///< overlap over radius by which weight presses two equal fines together, at most [-]
};

/// Step 3: coarse grains held, fluid forces ramped on the fines of a copy and kept, with a twin without fluid.
struct ProbeSpec {
    std::int64_t ramp = 100;        ///< steps from no force to the full force; of 1 to 1000, few verdicts differ
    std::int64_t watch = 1000;      ///< steps at the full force; the paper's value
    bool hold_coarse = true;        ///< the paper holds them
    double unbalanced_force = 1e-8; ///< the probe starts from the equilibrium relaxed to this at constant volume [-]
    std::int64_t relax_limit = dem::most_relax_steps; ///< steps after which the floor reached is taken and reported
    flow::SolverChoice flow;                          ///< that gives the forces and permeabilities
    std::optional<Gravity> gravity; ///< fines have weight, and mobility.hpp finds what moves; else they have none, and
                                    ///< `ramp`, `watch` and what follows them hold
    WeighedMotion weighed;          ///< of use with `gravity` alone
};

enum class DetachBy { Velocity, Displacement };

enum class VelocityRule {
    StillAccelerating, ///< rises over every tenth of the watch, and ends by a share of free flight above what the same
                       ///< grain does in the twin
    Rising,            ///< rises over every tenth of the watch
    Above,             ///< ends above a given speed
};

/// Which fines count as detachable.
struct DetachSpec {
    DetachBy by = DetachBy::Velocity;
    VelocityRule rule = VelocityRule::StillAccelerating;
    double over = 0.5;                    ///< share of the free flight: speed, or displacement along the drag [-]
    std::optional<double> over_speed;     ///< VelocityRule::Above: [m/s]
    std::optional<double> over_diameters; ///< displacement rule: an absolute share of the grain's diameter instead [-]
    double noise_quantile = 0.999; ///< of the twin's speeds, reported as their noise; no grain is judged by it [-]
};

enum class ConstrictionSize {
    Mean, ///< the paper's choice
    Median,
    D35,        ///< by number of facets
    WidestPath, ///< ours: the widest way from the grain's pore to its image one period along the flow
    FlowPath,   ///< ours: those that it meets on its way with the water, between the grains that stay
    None,       ///< every detachable grain leaves
};

/// `do = "detach"`: the probe at several gradients, nothing removed. Figure 9.
struct DetachStageSpec {
    std::vector<double> gradients = {0, 0.01, 0.05, 0.1};
    Vec3 direction = {0, 0, 1};
    std::optional<double> specified_gradient; ///< with weight: that the soil has to bear [-]
    ProbeSpec probe;
    DetachSpec detached;
};

/// Forced removal instead of the probe: fines with at most this many contacts leave (Scholtes 2010 style).
struct ForcedRemoval {
    int max_contacts = 3;
};

/// As much mass as an erosion is to take.
struct ErodedTarget {
    enum class Of { Fines, Solids };
    double share = 1; ///< of the mass before the first pass [-]
    Of of = Of::Fines;
};

/// "fines", "solids".
constexpr std::string_view name_of(ErodedTarget::Of of) {
    return of == ErodedTarget::Of::Fines ? "fines" : "solids";
}

/// How what is left finds its new equilibrium.
struct ResettleSpec {
    double max_strain = 0.2; ///< of an axis in a pass, beyond which the skeleton counts as failed and is left as it is
    double inertial_number = dem::loaded_inertial_number; ///< sets the largest strain rate under the stresses held [-]
};

/// What may change from one pass of an erosion to the next.
struct PassSpec {
    double gradient = 0.05;
    DetachSpec detached;
    bool hold_coarse = true;
};

/// `do = "erode"`: passes of flow, probe, extraction and new equilibrium. Figures 10 to 14.
struct ErodeSpec {
    int passes = 2; ///< at most; stops earlier when nothing more leaves
    double gradient = 0.05;
    std::vector<PassSpec> later_passes; ///< after the first, where they differ; the last is that of all that follow
    Vec3 direction = {0, 0, 1};
    ProbeSpec probe;
    DetachSpec detached;
    ConstrictionSize passes_constriction = ConstrictionSize::Mean;
    pores::VoidMerge merge = pores::VoidMerge::None; ///< of the voids between which constrictions are counted
    std::optional<double> transport_distance;        ///< along the flow; else the cell's length along it [m]
    std::optional<ForcedRemoval> forced;
    bool until_nothing_leaves = false;        ///< go on beyond `passes`
    std::optional<ErodedTarget> until_eroded; ///< no pass after the one that reaches it
    ResettleSpec resettle;
};

/// The erosion as its pass of this number (1-based) has it.
inline ErodeSpec at_pass(const ErodeSpec& spec, int pass) {
    ErodeSpec now = spec;
    if (pass > 1 && !spec.later_passes.empty()) {
        const std::size_t last = spec.later_passes.size() - 1;
        const PassSpec& later = spec.later_passes[std::min(static_cast<std::size_t>(pass - 2), last)];
        now.gradient = later.gradient;
        now.detached = later.detached;
        now.probe.hold_coarse = later.hold_coarse;
    }
    return now;
}

/// Whether a pass after this one (1-based) has other settings.
inline bool changes_after(const ErodeSpec& spec, int pass) {
    return static_cast<std::size_t>(pass) <= spec.later_passes.size();
}

/// Whether detached fines follow the water, and lodge where it holds them.
inline bool travels(const ErodeSpec& spec) {
    return spec.passes_constriction == ConstrictionSize::FlowPath && !spec.forced;
}

/// Which fines a removal takes; active ones have at least two contacts.
enum class RemovedFines { All, Inactive, Active };

/// Which of them go first, where not all go at once; among equals chance decides, by the seed.
enum class RemovalOrder {
    Random,
    Smallest,       ///< by diameter [MuirWood2010]
    LeastStressed,  ///< by the mean stress in the grain [Scholtes2010]
    FewestContacts, ///< [He2025]
};

/// `do = "remove"`: fines are taken out without water, and the rest finds a new equilibrium, in one pass or several.
struct RemoveSpec {
    RemovedFines grains = RemovedFines::All;
    double share = 1; ///< of their mass when the stage begins [-]
    RemovalOrder order = RemovalOrder::Random;
    int passes = 1; ///< equal parts of that mass, with a new equilibrium after each
    ResettleSpec resettle;

    /// The question of the paper's active fines content.
    [[nodiscard]] bool takes_all_fines_at_once() const {
        return grains == RemovedFines::All && share >= 1 && passes == 1;
    }
};

} // namespace suffuse::erosion
