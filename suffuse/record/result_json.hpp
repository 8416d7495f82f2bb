#pragma once
// Results and stage states as JSON: what stage files, checkpoints and the rebuilt report are read from. Numbers keep
// all their bits. Results that users see are rows of suffuse/facts; what is left is listed in the source.

#include "suffuse/dem/settle.hpp"
#include "suffuse/erosion/migration.hpp"
#include "suffuse/erosion/mobility.hpp"
#include "suffuse/erosion/pass_under_way.hpp"
#include "suffuse/erosion/removal.hpp"
#include "suffuse/packing/compact.hpp"
#include "suffuse/record/ending_json.hpp"
#include "suffuse/triaxial/response.hpp"
#include "suffuse/triaxial/stiffness.hpp"
#include "suffuse/triaxial/stress_probe.hpp"

#include <nlohmann/json.hpp>

// NOLINTBEGIN(bugprone-macro-parentheses): a type cannot have any
#define SUFFUSE_AS_JSON(TYPE)                                                                                          \
    void to_json(nlohmann::json& json, const TYPE& of);                                                                \
    void from_json(const nlohmann::json& json, TYPE& of);

// NOLINTEND(bugprone-macro-parentheses)

namespace suffuse {

SUFFUSE_AS_JSON(Vec3)
SUFFUSE_AS_JSON(Mat3)

namespace grains {
SUFFUSE_AS_JSON(Material)
} // namespace grains

namespace dem {
SUFFUSE_AS_JSON(Equilibrium)
SUFFUSE_AS_JSON(Lent)
SUFFUSE_AS_JSON(BalanceState)
SUFFUSE_AS_JSON(Relaxation)
SUFFUSE_AS_JSON(ComputedStep)
SUFFUSE_AS_JSON(Dissipation)
SUFFUSE_AS_JSON(EnergyParts)
SUFFUSE_AS_JSON(EnergyBalance)
} // namespace dem

namespace packing {
SUFFUSE_AS_JSON(CompactState)
} // namespace packing

namespace triaxial {
SUFFUSE_AS_JSON(PathRow)
SUFFUSE_AS_JSON(PathState)
NLOHMANN_JSON_SERIALIZE_ENUM(Answer, {{Answer::Rests, "rests"}, {Answer::Creeps, "creeps"}, {Answer::Fails, "fails"}})
SUFFUSE_AS_JSON(StressProbe)
SUFFUSE_AS_JSON(StrainProbe)
void to_json(nlohmann::json& json, const Stiffness& stiffness);
void to_json(nlohmann::json& json, const Instability& at);
void to_json(nlohmann::json& json, const Response& response);
} // namespace triaxial

namespace pores {
SUFFUSE_AS_JSON(Constrictions)
} // namespace pores

namespace flow {
SUFFUSE_AS_JSON(ClosedVoids)
NLOHMANN_JSON_SERIALIZE_ENUM(
    Solver, {{Solver::Network, name_of(Solver::Network)}, {Solver::Resolved, name_of(Solver::Resolved)}}
)
NLOHMANN_JSON_SERIALIZE_ENUM(
    Doubt, {{Doubt::None, name_of(Doubt::None)},
            {Doubt::FewFines, name_of(Doubt::FewFines)},
            {Doubt::LittleFines, name_of(Doubt::LittleFines)},
            {Doubt::Overlaps, name_of(Doubt::Overlaps)},
            {Doubt::Channels, name_of(Doubt::Channels)},
            {Doubt::RaisedByFines, name_of(Doubt::RaisedByFines)}}
)
SUFFUSE_AS_JSON(KnownError)
SUFFUSE_AS_JSON(FlowSource)
SUFFUSE_AS_JSON(ThroatFlux)
} // namespace flow

namespace erosion {
SUFFUSE_AS_JSON(ProbeResult)
NLOHMANN_JSON_SERIALIZE_ENUM(
    Phase, {{Phase::Removal, name_of(Phase::Removal)},
            {Phase::ConstantVolume, name_of(Phase::ConstantVolume)},
            {Phase::Servo, name_of(Phase::Servo)}}
)
SUFFUSE_AS_JSON(PathRow)
NLOHMANN_JSON_SERIALIZE_ENUM(
    Reason, {{Reason::Velocity, "velocity"},
             {Reason::Displacement, "displacement"},
             {Reason::Mobile, "mobile"},
             {Reason::Forced, "forced"},
             {Reason::OwnRule, "own rule"},
             {Reason::Removed, "removed"},
             {Reason::RemovedActive, "removed active"},
             {Reason::RemovedInactive, "removed inactive"},
             {Reason::RemovedActive, "removed, active"}, // of earlier runs
             {Reason::RemovedInactive, "removed, inactive"}}
)
SUFFUSE_AS_JSON(LedgerRow)
SUFFUSE_AS_JSON(ConstrictionSummary)
NLOHMANN_JSON_SERIALIZE_ENUM(Fate, {{Fate::Left, "left"}, {Fate::Lodged, "lodged"}, {Fate::Stayed, "stayed"}})
SUFFUSE_AS_JSON(Transport)
SUFFUSE_AS_JSON(MobilityStep)
SUFFUSE_AS_JSON(MobilityResult)
SUFFUSE_AS_JSON(MobilityRamp)
SUFFUSE_AS_JSON(PassResult)
SUFFUSE_AS_JSON(ErosionResult)
SUFFUSE_AS_JSON(Resettlement)
SUFFUSE_AS_JSON(PassUnderWay)
SUFFUSE_AS_JSON(RemovalResult)
NLOHMANN_JSON_SERIALIZE_ENUM(
    Whereabouts, {{Whereabouts::Stayed, "stayed"},
                  {Whereabouts::Lodged, "lodged"},
                  {Whereabouts::Moving, "moving"},
                  {Whereabouts::Eroded, "eroded"},
                  {Whereabouts::Fixed, "fixed"}}
)
NLOHMANN_JSON_SERIALIZE_ENUM(
    HoldEnd, {{HoldEnd::None, name_of(HoldEnd::None)},
              {HoldEnd::Rest, name_of(HoldEnd::Rest)},
              {HoldEnd::AllLeft, name_of(HoldEnd::AllLeft)},
              {HoldEnd::HoldLimit, name_of(HoldEnd::HoldLimit)},
              {HoldEnd::TimeLimit, name_of(HoldEnd::TimeLimit)},
              {HoldEnd::StepLimit, name_of(HoldEnd::StepLimit)}}
)
SUFFUSE_AS_JSON(Stack)
SUFFUSE_AS_JSON(LayerHeads)
SUFFUSE_AS_JSON(BaseProfile)
SUFFUSE_AS_JSON(StackCut)
SUFFUSE_AS_JSON(BaseSizes)
SUFFUSE_AS_JSON(FilterView)
SUFFUSE_AS_JSON(PassedThroats)
SUFFUSE_AS_JSON(SampleProfile)
SUFFUSE_AS_JSON(MigrationRow)
SUFFUSE_AS_JSON(MigrationHold)
SUFFUSE_AS_JSON(MigrationFrame)
SUFFUSE_AS_JSON(MigrationFates)
SUFFUSE_AS_JSON(GrainStory)
SUFFUSE_AS_JSON(MigrationResult)
SUFFUSE_AS_JSON(Feeding)
SUFFUSE_AS_JSON(Migration)
} // namespace erosion

} // namespace suffuse

#undef SUFFUSE_AS_JSON
