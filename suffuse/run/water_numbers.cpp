#include "suffuse/run/water_numbers.hpp"

#include "suffuse/pores/constrictions.hpp"
#include "suffuse/record/result_json.hpp"
#include "suffuse/run/mobility_record.hpp"
#include "suffuse/run/pass_record.hpp"

#include <algorithm>

namespace suffuse::run {
namespace {

nlohmann::json transport_numbers(const erosion::Transport& transport) {
    const auto count = [&](erosion::Fate fate) {
        return std::count(transport.fate.begin(), transport.fate.end(), fate);
    };
    return {
        {"distance", transport.distance},
        {"left", count(erosion::Fate::Left)},
        {"lodged", count(erosion::Fate::Lodged)},
        {"stayed", count(erosion::Fate::Stayed)},
        {"filter_coefficient", or_null(erosion::filter_coefficient(transport))},
    };
}

} // namespace

nlohmann::json probe_numbers(const erosion::ProbeResult& probe) {
    const auto count = [](const auto& verdicts) {
        return std::count(verdicts.begin(), verdicts.end(), std::uint8_t{1});
    };
    return {
        {"gradient", probe.gradient},
        {"fines", probe.id.size()},
        {"detachable_by_velocity", count(probe.by_velocity)},
        {"detachable_by_displacement", count(probe.by_displacement)},
        {"agreement", probe.agreement},
        {"hidden_by_noise", probe.hidden_by_noise},
        {"unbalanced_force", probe.unbalanced_force},
        {"reached_floor", probe.reached_floor},
        {"relax_steps", probe.relax_steps},
        {"ramp", probe.ramp},
        {"watch", probe.watch},
        {"time_step", probe.time_step},
        {"fluid_over_contact", probe.fluid_over_contact},
        {"signal_over_twin", probe.signal_over_twin},
        {"viscous_time", probe.viscous_time},
        {"beyond_viscous_time", probe.beyond_viscous_time},
    };
}

nlohmann::json source_numbers(const flow::FlowSource& source) {
    nlohmann::json numbers = source;
    if (source.doubt == flow::Doubt::None) {
        numbers["doubt"] = nullptr;
    }
    return numbers;
}

nlohmann::json pass_numbers(const erosion::PassResult& pass) {
    nlohmann::json by_merge = nlohmann::json::object();
    for (std::size_t way = 0; way < pores::every_merge.size(); ++way) {
        by_merge[std::string(pores::name_of(pores::every_merge[way]))] = pass.constrictions_by_merge[way];
    }
    nlohmann::json numbers = pass_record(pass);
    if (pass.transport.distance > 0) {
        numbers["transport"] = transport_numbers(pass.transport);
    }
    numbers.update({
        {"detachable", pass.detachable},
        {"held_back", pass.held_back},
        {"constriction_mean", pass.constrictions.mean},
        {"constriction_median", pass.constrictions.median},
        {"constriction_d35", pass.constrictions.d35},
        {"constrictions", pass.constrictions.diameter.size()},
        {"constrictions_by_merge", by_merge},
        {"permeability_before", pass.permeability_before},
        {"permeability_after", pass.permeability_after},
        {"flow_before", source_numbers(pass.probe.flow)},
        {"flow_after", source_numbers(pass.flow_after)},
        {"reynolds_number_before", pass.reynolds_before},
        {"reynolds_number_after", pass.reynolds_after},
        {"tortuosity_before", pass.tortuosity_before},
        {"tortuosity_after", pass.tortuosity_after},
        {"half_carried_by_before", pass.throat_flux_before.half_carried_by},
        {"half_carried_by_after", pass.throat_flux_after.half_carried_by},
        {"reached_target", pass.reached_target},
        {"probe", probe_numbers(pass.probe)},
    });
    if (pass.mobility) {
        numbers.erase("probe");
        numbers.update(mobility_numbers(*pass.mobility));
    }
    return numbers;
}

} // namespace suffuse::run
