#include "suffuse/record/result_json.hpp"

#include "suffuse/facts/migration.hpp"
#include "suffuse/facts/mobility.hpp"
#include "suffuse/facts/pass.hpp"
#include "suffuse/facts/test.hpp"
#include "suffuse/record/earlier_endings.hpp"
#include "suffuse/record/fact_json.hpp"
#include "suffuse/record/or_null.hpp"

// The library's macros that list members make inline functions: these are made once, here.
#define SUFFUSE_MEMBERS(TYPE, ...)                                                                                     \
    void to_json(nlohmann::json& nlohmann_json_j, const TYPE& nlohmann_json_t) {                                       \
        NLOHMANN_JSON_EXPAND(NLOHMANN_JSON_PASTE(NLOHMANN_JSON_TO, __VA_ARGS__))                                       \
    }                                                                                                                  \
    void from_json(const nlohmann::json& nlohmann_json_j, TYPE& nlohmann_json_t) {                                     \
        NLOHMANN_JSON_EXPAND(NLOHMANN_JSON_PASTE(NLOHMANN_JSON_FROM, __VA_ARGS__))                                     \
    }
// Members that earlier files lack keep their defaults.
#define SUFFUSE_MEMBERS_OR_DEFAULTS(TYPE, ...)                                                                         \
    void to_json(nlohmann::json& nlohmann_json_j, const TYPE& nlohmann_json_t) {                                       \
        NLOHMANN_JSON_EXPAND(NLOHMANN_JSON_PASTE(NLOHMANN_JSON_TO, __VA_ARGS__))                                       \
    }                                                                                                                  \
    void from_json(const nlohmann::json& nlohmann_json_j, TYPE& nlohmann_json_t) {                                     \
        const TYPE nlohmann_json_default_obj{};                                                                        \
        NLOHMANN_JSON_EXPAND(NLOHMANN_JSON_PASTE(NLOHMANN_JSON_FROM_WITH_DEFAULT, __VA_ARGS__))                        \
    }

namespace suffuse {

void to_json(nlohmann::json& json, const Vec3& v) {
    json = {v.x, v.y, v.z};
}

void from_json(const nlohmann::json& json, Vec3& v) {
    v = {json.at(0), json.at(1), json.at(2)};
}

void to_json(nlohmann::json& json, const Mat3& m) {
    json = {m.row(0), m.row(1), m.row(2)};
}

void from_json(const nlohmann::json& json, Mat3& m) {
    m = transpose(from_columns(json.at(0).get<Vec3>(), json.at(1).get<Vec3>(), json.at(2).get<Vec3>()));
}

namespace grains {
void to_json(nlohmann::json& json, const Material& material) {
    list_members(material, [&](const Member& member, const auto& value) { json[member.name] = value; });
}

void from_json(const nlohmann::json& json, Material& material) {
    list_members(material, [&](const Member& member, auto& value) { json.at(member.name).get_to(value); });
}
} // namespace grains

namespace dem {
SUFFUSE_MEMBERS(
    Equilibrium, unbalanced_force, unbalanced_force_all, mean_contact_force, kinetic_energy, max_overlap_ratio,
    contacts, rattlers, single_contact
)
SUFFUSE_MEMBERS_OR_DEFAULTS( // states of earlier runs lack the last two, and lent neither
    Lent, mass, rotation, gently, fines_rotation
)
SUFFUSE_MEMBERS(BalanceState, steps, balanced_steps, equilibrium, stress)
SUFFUSE_MEMBERS(Relaxation, unbalanced_force, steps, reached_floor, best, since_best)
SUFFUSE_MEMBERS(ComputedStep, time_step, known_contacts)
SUFFUSE_MEMBERS(Dissipation, slip, rolling, damping)
SUFFUSE_MEMBERS(EnergyParts, work, springs, motion, slip, rolling, damping)
SUFFUSE_MEMBERS(EnergyBalance, parts, springs_before, motion_before, rate, h, stress, time)
} // namespace dem

namespace packing {
SUFFUSE_MEMBERS( // whole or not at all: what went on with a default would be of neither version
    CompactState, phase, balance, time_step, known_contacts, material, damping, mode, median_diameter, start_porosity,
    lent, steps, void_ratio_compacted
)
} // namespace packing

namespace triaxial {
SUFFUSE_MEMBERS_OR_DEFAULTS( // curves of earlier runs lack some
    PathRow, axial_strain, volumetric_strain, stress, mean_stress, deviator_stress, void_ratio, coordination,
    mechanical_coordination, unbalanced_force, inertial_number, second_order_work, excess_pore_pressure, energy,
    hold_error, shear_strain, leg
)
SUFFUSE_MEMBERS( // whole or not at all, as CompactState
    PathState, phase, leg, sense, turn, start_h, start_stress, strain_rate, pace, least_pace, median_diameter, lent,
    time_step, known_contacts, balance, energy, steps, storage, skempton_b, water_rate, rows
)

SUFFUSE_MEMBERS(StressProbe, angle, stress, strain, second_order_work, normalized, answer, steps)

SUFFUSE_MEMBERS(StrainProbe, half, whole, steps)

void to_json(nlohmann::json& json, const Stiffness& stiffness) {
    json = record::facts_json(facts::stiffness, stiffness);
}

void to_json(nlohmann::json& json, const Instability& at) {
    json = {{"q", at.deviator_stress}, {"p", at.mean_stress}, {"strain", at.axial_strain}};
}

void to_json(nlohmann::json& json, const Response& response) {
    json = record::facts_json(facts::response, response);
}
} // namespace triaxial

namespace pores {
SUFFUSE_MEMBERS(Constrictions, diameter, center, mean, median, d35)
} // namespace pores

namespace flow {
SUFFUSE_MEMBERS(ClosedVoids, share, grain)

void to_json(nlohmann::json& json, const KnownError& error) {
    json = {
        {"permeability", or_null(error.permeability)},
        {"force_sum", or_null(error.force_sum)},
        {"force", or_null(error.force)}};
}

void from_json(const nlohmann::json& json, KnownError& error) {
    const auto read = [&](const char* name) {
        const nlohmann::json& value = json.at(name);
        return value.is_null() ? std::optional<double>() : value.get<double>();
    };
    error = {read("permeability"), read("force_sum"), read("force")};
}

void to_json(nlohmann::json& json, const FlowSource& source) {
    json = {
        {"solver", source.solver},
        {"known_error", source.known_error},
        {"raised_by_fines", or_null(source.raised_by_fines)},
        {"limited_to_coarse", source.is_limited},
        {"doubt", source.doubt}};
}

void from_json(const nlohmann::json& json, FlowSource& source) {
    json.at("solver").get_to(source.solver);
    json.at("known_error").get_to(source.known_error);
    json.at("doubt").get_to(source.doubt);
    source.is_limited = json.value("limited_to_coarse", false); // earlier runs had no such limit
    const nlohmann::json& raised = json.at("raised_by_fines");
    source.raised_by_fines = raised.is_null() ? std::optional<double>() : raised.get<double>();
}

SUFFUSE_MEMBERS(ThroatFlux, throats, mean, half_carried_by, quantile, carried, diameter, flux_10, flux_50, flux_90)
} // namespace flow

namespace erosion {
void to_json(nlohmann::json& json, const ProbeResult& of) {
    record::save_facts(json, facts::probe, of);
}

void from_json(const nlohmann::json& json, ProbeResult& of) {
    record::load_facts(json, facts::probe, of);
}

SUFFUSE_MEMBERS(PathRow, pass, phase, step, stress, volumetric_strain, porosity, unbalanced_force, eroded_mass)
SUFFUSE_MEMBERS(LedgerRow, grain, pass, diameter, mass, coordination, reason)
SUFFUSE_MEMBERS(ConstrictionSummary, count, mean, median, d35)
SUFFUSE_MEMBERS(Transport, distance, id, diameter, mass, travel, progress, path, throats, constriction, fate)

void to_json(nlohmann::json& json, const MobilityStep& of) {
    record::save_facts(json, facts::mobility_step, of);
}

void from_json(const nlohmann::json& json, MobilityStep& of) {
    record::load_facts(json, facts::mobility_step, of);
}

void to_json(nlohmann::json& json, const MobilityResult& of) {
    record::save_facts(json, facts::mobility, of);
}

void from_json(const nlohmann::json& json, MobilityResult& of) {
    record::load_facts(json, facts::mobility, of);
}

void to_json(nlohmann::json& json, const PassResult& of) {
    record::save_facts(json, facts::pass, of);
    record::save_facts(json, facts::pass_with_water, of);
    json["verdict"] = facts::words_of(of.verdict); // what earlier versions read
}

void from_json(const nlohmann::json& json, PassResult& of) {
    record::load_facts(json, facts::pass, of);
    record::load_facts(json, facts::pass_with_water, of);
    if (!json.contains("ended")) {
        of.verdict = record::ending_of_sentence(json.at("verdict"));
    } else if (auto* const other = std::get_if<OtherWording>(&of.verdict.why)) {
        other->words = json.at("verdict");
    }
}

SUFFUSE_MEMBERS(ErosionResult, passes, ledger, path, initial_mass)
SUFFUSE_MEMBERS(Resettlement, phase, steps, balance, computed, last_carrying, start_h, rows)
SUFFUSE_MEMBERS( // but for its world
    PassUnderWay, at, pass, relaxation, relaxation_step, ledger, resettlement
)

void to_json(nlohmann::json& json, const RemovalResult& of) {
    json = {{"erosion", of.erosion}, {"start_h", of.start_h}, {"asked_mass", of.requested_mass}};
}

void from_json(const nlohmann::json& json, RemovalResult& of) {
    json.at("erosion").get_to(of.erosion);
    json.at("start_h").get_to(of.start_h);
    json.at("asked_mass").get_to(of.requested_mass);
}
SUFFUSE_MEMBERS(WeightScale, factor, acceleration, time, drag)
SUFFUSE_MEMBERS( // but for the world, which is saved as a state, and the flow, which is solved anew
    MobilityRamp, scale, result, tried, rest, solved_at, over
)
SUFFUSE_MEMBERS(Stack, length, face, interface, base_grain, filter_grain, exit)
SUFFUSE_MEMBERS(LayerHeads, base, filter, interface)
SUFFUSE_MEMBERS(BaseProfile, first, step, filter, base)
SUFFUSE_MEMBERS(
    MigrationRow, time, gradient, sample_gradient, base_gradient, filter_gradient, permeability, eroded_mass,
    moving_mass, lodged_mass, energy, fed_mass
)

void to_json(nlohmann::json& json, const MigrationHold& of) {
    json = record::facts_json(facts::migration_hold, of);
}

void from_json(const nlohmann::json& json, MigrationHold& of) {
    record::load_facts(json, facts::migration_hold, of);
}

SUFFUSE_MEMBERS(StackCut, width, along, across, radius, is_base)
SUFFUSE_MEMBERS(BaseSizes, diameter, mass_share, entered, eroded)
SUFFUSE_MEMBERS(FilterView, filter_d15, base_d85, base_gap, passed, constriction, largest_eroded, before, after, sizes)
SUFFUSE_MEMBERS(SampleProfile, slices, step, porosity, fines, permeability)
SUFFUSE_MEMBERS(MigrationFrame, time, gradient, weight_scale)
SUFFUSE_MEMBERS(MigrationFates, id, where)
SUFFUSE_MEMBERS(GrainStory, id, diameter, departed, gradient, way, throats, narrowest, left, moves, holders)
SUFFUSE_MEMBERS_OR_DEFAULTS(
    MigrationResult, rows, holds, frames, fates, story, fines_mass, resting_permeability, profile, filter, sample
)
SUFFUSE_MEMBERS(PassedThroats, count, narrowest, last)
SUFFUSE_MEMBERS(
    MigrationLedger, id, diameter, mass, start, end, entered, to_exit, departed, departed_at, left, passed, where, goes,
    before
)
SUFFUSE_MEMBERS(Feeding, waiting, drawn)
SUFFUSE_MEMBERS( // but for the world, which is saved as a state
    Migration, scale, ledger, result, time, energy, looked, steps, time_step, largest_overlap, hindrance,
    coarse_permeability, solids_mass, friction, stress, stack, at_first, now, feeding, fed_mass, rested, settles, over,
    cut_by
)
} // namespace erosion

} // namespace suffuse
