#pragma once
// Results and stage states as JSON: what stage files, checkpoints and the rebuilt report are read from. Numbers keep
// all their bits. Results that users see are rows of suffuse/facts; what is left is listed here.

#include "suffuse/dem/settle.hpp"
#include "suffuse/erosion/pass_under_way.hpp"
#include "suffuse/erosion/removal.hpp"
#include "suffuse/facts/mobility.hpp"
#include "suffuse/facts/pass.hpp"
#include "suffuse/facts/test.hpp"
#include "suffuse/packing/compact.hpp"
#include "suffuse/record/earlier_endings.hpp"
#include "suffuse/record/ending_json.hpp"
#include "suffuse/record/fact_json.hpp"
#include "suffuse/record/or_null.hpp"
#include "suffuse/triaxial/response.hpp"
#include "suffuse/triaxial/stress_probe.hpp"

#include <nlohmann/json.hpp>

namespace suffuse {

inline void to_json(nlohmann::json& json, const Vec3& v) {
    json = {v.x, v.y, v.z};
}

inline void from_json(const nlohmann::json& json, Vec3& v) {
    v = {json.at(0), json.at(1), json.at(2)};
}

inline void to_json(nlohmann::json& json, const Mat3& m) {
    json = {m.row(0), m.row(1), m.row(2)};
}

inline void from_json(const nlohmann::json& json, Mat3& m) {
    m = transpose(from_columns(json.at(0).get<Vec3>(), json.at(1).get<Vec3>(), json.at(2).get<Vec3>()));
}

namespace grains {
inline void to_json(nlohmann::json& json, const Material& material) {
    list_members(material, [&](const Member& member, const auto& value) { json[member.name] = value; });
}

inline void from_json(const nlohmann::json& json, Material& material) {
    list_members(material, [&](const Member& member, auto& value) { json.at(member.name).get_to(value); });
}
} // namespace grains

namespace dem {
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(
    Equilibrium, unbalanced_force, unbalanced_force_all, mean_contact_force, kinetic_energy, max_overlap_ratio,
    contacts, rattlers, single_contact
)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT( // states of earlier runs lack the last two, and lent neither
    Lent, mass, rotation, gently, fines_rotation
)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(BalanceState, steps, balanced_steps, equilibrium, stress)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Relaxation, unbalanced_force, steps, reached_floor, best, since_best)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ComputedStep, time_step, known_contacts)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Dissipation, slip, rolling, damping)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(EnergyParts, work, springs, motion, slip, rolling, damping)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(EnergyBalance, parts, springs_before, motion_before, rate, h, stress, time)
} // namespace dem

namespace packing {
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE( // whole or not at all: what went on with a default would be of neither version
    CompactState, phase, balance, time_step, known_contacts, material, damping, mode, median_diameter, start_porosity,
    lent, steps, void_ratio_compacted
)
} // namespace packing

namespace triaxial {
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT( // curves of earlier runs lack some
    PathRow, axial_strain, volumetric_strain, stress, mean_stress, deviator_stress, void_ratio, coordination,
    mechanical_coordination, unbalanced_force, inertial_number, second_order_work, excess_pore_pressure, energy
)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE( // whole or not at all, as CompactState
    PathState, phase, start_h, start_stress, strain_rate, pace, least_pace, median_diameter, lent, time_step,
    known_contacts, balance, energy, steps, rows
)

NLOHMANN_JSON_SERIALIZE_ENUM(Answer, {{Answer::Rests, "rests"}, {Answer::Creeps, "creeps"}, {Answer::Fails, "fails"}})
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(StressProbe, angle, stress, strain, second_order_work, normalized, answer, steps)

inline void to_json(nlohmann::json& json, const Instability& at) {
    json = {{"q", at.deviator_stress}, {"p", at.mean_stress}, {"strain", at.axial_strain}};
}

inline void to_json(nlohmann::json& json, const Response& response) {
    json = record::facts_json(facts::response, response);
}
} // namespace triaxial

namespace pores {
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Constrictions, diameter, center, mean, median, d35)
} // namespace pores

namespace flow {
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ClosedVoids, share, grain)
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

inline void to_json(nlohmann::json& json, const KnownError& error) {
    json = {
        {"permeability", or_null(error.permeability)},
        {"force_sum", or_null(error.force_sum)},
        {"force", or_null(error.force)}};
}

inline void from_json(const nlohmann::json& json, KnownError& error) {
    const auto read = [&](const char* name) {
        const nlohmann::json& value = json.at(name);
        return value.is_null() ? std::optional<double>() : value.get<double>();
    };
    error = {read("permeability"), read("force_sum"), read("force")};
}

inline void to_json(nlohmann::json& json, const FlowSource& source) {
    json = {
        {"solver", source.solver},
        {"known_error", source.known_error},
        {"raised_by_fines", or_null(source.raised_by_fines)},
        {"limited_to_coarse", source.is_limited},
        {"doubt", source.doubt}};
}

inline void from_json(const nlohmann::json& json, FlowSource& source) {
    json.at("solver").get_to(source.solver);
    json.at("known_error").get_to(source.known_error);
    json.at("doubt").get_to(source.doubt);
    source.is_limited = json.value("limited_to_coarse", false); // earlier runs had no such limit
    const nlohmann::json& raised = json.at("raised_by_fines");
    source.raised_by_fines = raised.is_null() ? std::optional<double>() : raised.get<double>();
}

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(
    ThroatFlux, throats, mean, half_carried_by, quantile, carried, diameter, flux_10, flux_50, flux_90
)
} // namespace flow

namespace erosion {
inline void to_json(nlohmann::json& json, const ProbeResult& of) {
    record::save_facts(json, facts::probe, of);
}

inline void from_json(const nlohmann::json& json, ProbeResult& of) {
    record::load_facts(json, facts::probe, of);
}

NLOHMANN_JSON_SERIALIZE_ENUM(
    Phase, {{Phase::Removal, name_of(Phase::Removal)},
            {Phase::ConstantVolume, name_of(Phase::ConstantVolume)},
            {Phase::Servo, name_of(Phase::Servo)}}
)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(
    PathRow, pass, phase, step, stress, volumetric_strain, porosity, unbalanced_force, eroded_mass
)
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
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(LedgerRow, grain, pass, diameter, mass, coordination, reason)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ConstrictionSummary, count, mean, median, d35)
NLOHMANN_JSON_SERIALIZE_ENUM(Fate, {{Fate::Left, "left"}, {Fate::Lodged, "lodged"}, {Fate::Stayed, "stayed"}})
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(
    Transport, distance, id, diameter, mass, travel, progress, path, throats, constriction, fate
)

inline void to_json(nlohmann::json& json, const MobilityStep& of) {
    record::save_facts(json, facts::mobility_step, of);
}

inline void from_json(const nlohmann::json& json, MobilityStep& of) {
    record::load_facts(json, facts::mobility_step, of);
}

inline void to_json(nlohmann::json& json, const MobilityResult& of) {
    record::save_facts(json, facts::mobility, of);
}

inline void from_json(const nlohmann::json& json, MobilityResult& of) {
    record::load_facts(json, facts::mobility, of);
}

inline void to_json(nlohmann::json& json, const PassResult& of) {
    record::save_facts(json, facts::pass, of);
    record::save_facts(json, facts::pass_with_water, of);
    json["verdict"] = facts::words_of(of.verdict); // what earlier versions read
}

inline void from_json(const nlohmann::json& json, PassResult& of) {
    record::load_facts(json, facts::pass, of);
    record::load_facts(json, facts::pass_with_water, of);
    if (!json.contains("ended")) {
        of.verdict = record::ending_of_sentence(json.at("verdict"));
    } else if (auto* const other = std::get_if<OtherWording>(&of.verdict.why)) {
        other->words = json.at("verdict");
    }
}

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ErosionResult, passes, ledger, path, initial_mass)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Resettlement, phase, steps, balance, computed, last_carrying, start_h, rows)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE( // but for its world
    PassUnderWay, at, pass, relaxation, relaxation_step, ledger, resettlement
)

inline void to_json(nlohmann::json& json, const RemovalResult& of) {
    json = {{"erosion", of.erosion}, {"start_h", of.start_h}, {"asked_mass", of.requested_mass}};
}

inline void from_json(const nlohmann::json& json, RemovalResult& of) {
    json.at("erosion").get_to(of.erosion);
    json.at("start_h").get_to(of.start_h);
    json.at("asked_mass").get_to(of.requested_mass);
}
} // namespace erosion

} // namespace suffuse
