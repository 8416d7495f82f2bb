#pragma once
// Passes of an erosion or a removal, and the probes before them.

#include "suffuse/erosion/result.hpp"
#include "suffuse/facts/ending_words.hpp"
#include "suffuse/facts/fact.hpp"

#include <algorithm>
#include <map>
#include <string>

namespace suffuse::facts {

/// Contacts, as text, -> grains that had so many: an object of stage.json.
inline std::map<std::string, std::int64_t> histogram_by_name(const std::map<int, std::int64_t>& coordination) {
    std::map<std::string, std::int64_t> histogram;
    for (const auto& [contacts, grains] : coordination) {
        histogram[std::to_string(contacts)] = grains;
    }
    return histogram;
}

inline std::map<std::string, erosion::ConstrictionSummary> constrictions_by_name(const erosion::PassResult& pass) {
    std::map<std::string, erosion::ConstrictionSummary> by_merge;
    for (std::size_t way = 0; way < pores::every_merge.size(); ++way) {
        by_merge[std::string(pores::name_of(pores::every_merge[way]))] = pass.constrictions_by_merge[way];
    }
    return by_merge;
}

inline std::int64_t count_of(const std::vector<std::uint8_t>& verdicts) {
    return std::count(verdicts.begin(), verdicts.end(), std::uint8_t{1});
}

/// Nothing where the network is not doubted.
inline std::optional<std::string_view> doubt_name(const flow::FlowSource& source) {
    return source.doubt == flow::Doubt::None ? std::nullopt : std::optional(flow::name_of(source.doubt));
}

/// Which flow a permeability and the forces on the grains are of.
inline constexpr std::tuple flow_source{
    row<&flow::FlowSource::solver>(
        "solver", "", "`network` or `resolved`: which flow gave permeability, mean velocity and forces"
    ),
    row<&flow::FlowSource::known_error>(
        "known_error", "",
        "largest relative errors measured for this kind of flow ([validation](../validation/size_ratio.md)): "
        "`permeability` (one direction of one sample), `force_sum` (sum of the forces on all fines), `force` (root "
        "mean square over single grains); null where no bound is known. For a resolved flow: half of what "
        "extrapolation from its two grids changed the permeability"
    ),
    row<&flow::FlowSource::raised_by_fines>(
        "raised_by_fines", "-",
        "the network's permeability over that of its coarse grains alone; null without both kinds. Above 1.02 the "
        "stage warns"
    ),
    row<&flow::FlowSource::is_limited>(
        "limited_to_coarse", "",
        "true where the network was above the coarse grains' permeability, and therefore gives theirs. By Yade's law "
        "it stays as it is"
    ),
    row<&doubt_name>(
        "doubt", "",
        "why `solver = \"auto\"` resolves: `fewer than 50 fines`, `at most 1 % fines`, `overlaps`, `channels`, `fines "
        "raise the network's permeability`; else null. In a soil without marked fines, the grains below the widest gap "
        "between neighboring sizes count as fines, if it is a factor of 1.5"
    ),
};

/// A probe: an object of `probes` of `detach`, and `probe` of a pass.
inline constexpr std::tuple probe{
    row<&erosion::ProbeResult::gradient>("gradient", "-", "hydraulic gradient"),
    row<[](const erosion::ProbeResult& p) { return p.id.size(); }>("fines", "-", "fine grains probed"),
    row<[](const erosion::ProbeResult& p) { return count_of(p.by_velocity); }>(
        "detachable_by_velocity", "-", "fines detachable by the velocity rule"
    ),
    row<[](const erosion::ProbeResult& p) { return count_of(p.by_displacement); }>(
        "detachable_by_displacement", "-", "fines detachable by the displacement rule"
    ),
    row<&erosion::ProbeResult::agreement>("agreement", "-", "2 × 2 counts, `[by velocity][by displacement]`"),
    row<&erosion::ProbeResult::hidden_by_noise>(
        "hidden_by_noise", "-", "fines that would be detachable by velocity if the twin were at rest"
    ),
    row<&erosion::ProbeResult::unbalanced_force>("unbalanced_force", "-", "at the start of the probe"),
    row<&erosion::ProbeResult::reached_floor>(
        "reached_floor", "", "whether the unbalance stopped falling before the specified one"
    ),
    row<&erosion::ProbeResult::relax_steps>("relax_steps", "-", "steps of the relaxation"),
    row<&erosion::ProbeResult::ramp>("ramp", "-", "steps in which the force rises"),
    row<&erosion::ProbeResult::watch>("watch", "-", "steps at full force"),
    row<&erosion::ProbeResult::time_step>("time_step", "s", "of the probe"),
    row<&erosion::ProbeResult::fluid_over_contact>(
        "fluid_over_contact", "-", "mean fluid force on a fine grain / mean contact force"
    ),
    row<&erosion::ProbeResult::signal_over_twin>(
        "signal_over_twin", "-", "median final speed / that of the twin; null where the twin's median grain is at rest"
    ),
    row<&erosion::ProbeResult::viscous_time>("viscous_time", "s", "of the median fine grain, m/(6πµr)"),
    row<&erosion::ProbeResult::beyond_viscous_time>(
        "beyond_viscous_time", "", "whether ramp and watch last longer: a constant force then overstates motion"
    ),
    saved_alone<&erosion::ProbeResult::flow>("flow"),
    saved_alone<&erosion::ProbeResult::id>("id"),
    saved_alone<&erosion::ProbeResult::diameter>("diameter"),
    saved_alone<&erosion::ProbeResult::fluid_force>("fluid_force"),
    saved_alone<&erosion::ProbeResult::coordination>("coordination"),
    saved_alone<&erosion::ProbeResult::speed>("speed"),
    saved_alone<&erosion::ProbeResult::twin_speed>("twin_speed"),
    saved_alone<&erosion::ProbeResult::displacement>("displacement"),
    saved_alone<&erosion::ProbeResult::free_speed>("free_speed"),
    saved_alone<&erosion::ProbeResult::free_displacement>("free_displacement"),
    saved_alone<&erosion::ProbeResult::twin_noise>("twin_noise"),
    saved_alone<&erosion::ProbeResult::by_velocity>("by_velocity"),
    saved_alone<&erosion::ProbeResult::by_displacement>("by_displacement"),
};

/// `transport` of a pass whose detached grains travel.
inline constexpr std::tuple transport{
    row<&erosion::Transport::distance>("distance", "m", "a grain that gets so far along the flow has left", ""),
    row<[](const erosion::Transport& t) { return std::ranges::count(t.fate, erosion::Fate::Left); }>(
        "left", "-", "grains that got so far"
    ),
    row<[](const erosion::Transport& t) { return std::ranges::count(t.fate, erosion::Fate::Lodged); }>(
        "lodged", "-", "grains held on their way"
    ),
    row<[](const erosion::Transport& t) { return std::ranges::count(t.fate, erosion::Fate::Stayed); }>(
        "stayed", "-", "grains held where they were"
    ),
    row<&erosion::filter_coefficient>(
        "filter_coefficient", "1/m", "mass held over the sum of mass times travel; null where no grain got anywhere"
    ),
};

/// A pass of whatever takes grains out: an object of `passes`.
inline constexpr std::tuple pass{
    row<&erosion::PassResult::pass>("pass", "-", "number of the pass, from 1"),
    row<&erosion::PassResult::removed>("removed", "-", "grains that left"),
    row<&erosion::PassResult::eroded_mass_percent>(
        "eroded_mass_percent", "%", "mass that left, of the mass before this pass"
    ),
    row<&erosion::PassResult::eroded_mass_percent_of_initial>(
        "eroded_mass_percent_of_initial", "%", "mass that left, of the initial mass"
    ),
    row<[](const erosion::PassResult& p) { return histogram_by_name(p.coordination_histogram); }>(
        "coordination_histogram", "-", "number of contacts → number of removed grains that had so many"
    ),
    row<&erosion::PassResult::stress_before>("stress_before", "Pa", "3 × 3, before the removal"),
    row<&erosion::PassResult::stress_after_removal>(
        "stress_after_removal", "Pa", "3 × 3, in the first step without the grains"
    ),
    row<&erosion::PassResult::stress_constant_volume>(
        "stress_constant_volume", "Pa", "3 × 3, at rest at constant volume"
    ),
    row<&erosion::PassResult::stress_after>("stress_after", "Pa", "3 × 3, at rest under the servo"),
    row<&erosion::PassResult::porosity_before>("porosity_before", "-", "before the removal"),
    row<&erosion::PassResult::porosity_after_removal>("porosity_after_removal", "-", "before the skeleton moves"),
    row<&erosion::PassResult::porosity_after>("porosity_after", "-", "at rest under the servo"),
    row<&erosion::PassResult::void_ratio_after>("void_ratio_after", "-", "at rest under the servo"),
    row<&erosion::PassResult::fines_content_after>("fines_content_after", "-", "by mass, after the pass"),
    row<&erosion::PassResult::volumetric_strain>("volumetric_strain", "-", "of this pass")
        .as(Shown{"volumetric strain", "εᵥ", "%", 3}),
    row<&erosion::PassResult::steps>("steps", "-", "of the new equilibrium alone"),
    row<&erosion::PassResult::wall_seconds>(
        "wall_seconds", "s",
        "by part: `relax`, `flow`, `probe`, `constrictions`, `extraction`, `constant volume`, `servo`"
    ),
    row<[](const erosion::PassResult& p) { return words_of(p.verdict); }>(
        "verdict", "", "why the procedure stops here; empty where it goes on"
    ),
    row<&erosion::PassResult::verdict>(
        "ended", "",
        "the same for programs: null, or `why` with its numbers: `nothing leaves`, `noise decides`, `skeleton doubt` "
        "(`coarse` grains, `width` of the cell in coarse diameters or 0), `skeleton failed` (`most_strain`), `skeleton "
        "restless` (`steps`, `carried`), `target reached` (`share`, `asked`, `of`, `doubt`), `none to remove` "
        "(`pass`, `passes`), `told otherwise`"
    ),
    saved_alone<&erosion::PassResult::coordination_histogram>("coordination_histogram"),
    saved_alone<&erosion::PassResult::time_step>("time_step"),
    saved_alone<&erosion::PassResult::failed>("failed"),
};

/// What a pass has beyond that where water takes the grains out.
inline constexpr std::tuple pass_with_water{
    row<&erosion::PassResult::detachable>("detachable", "-", "fines that the rule finds detachable"),
    row<&erosion::PassResult::held_back>(
        "held_back", "-", "detachable fines that do not fit through the constrictions"
    ),
    row<[](const erosion::PassResult& p) { return p.constrictions.mean; }>(
        "constriction_mean", "m", "mean diameter of the coarse skeleton's constrictions"
    ),
    row<[](const erosion::PassResult& p) { return p.constrictions.median; }>(
        "constriction_median", "m", "median of them"
    ),
    row<[](const erosion::PassResult& p) { return p.constrictions.d35; }>(
        "constriction_d35", "m", "35 % of them are smaller"
    ),
    row<[](const erosion::PassResult& p) { return p.constrictions.diameter.size(); }>(
        "constrictions", "-", "number of facets, or of windows between merged voids"
    ),
    row<&constrictions_by_name>(
        "constrictions_by_merge", "m",
        "`none`, `center`, `overlap`: `count`, `mean`, `median`, `d35` for each way of merging voids, whichever the "
        "case uses"
    ),
    row<&erosion::PassResult::permeability_before>("permeability_before", "m2", "along the flow, before the removal"),
    row<&erosion::PassResult::permeability_after>("permeability_after", "m2", "along the flow, at the end of the pass"),
    row<&erosion::PassResult::reynolds_before>(
        "reynolds_number_before", "-", "of the water at the stage's gradient, with the Sauter diameter",
        "reynolds_before"
    ),
    row<&erosion::PassResult::reynolds_after>(
        "reynolds_number_after", "-", "the same after the pass", "reynolds_after"
    ),
    row<&erosion::PassResult::tortuosity_before>(
        "tortuosity_before", "-", "mean speed from pore to pore over that of the mean motion"
    ),
    row<&erosion::PassResult::tortuosity_after>("tortuosity_after", "-", "the same after the pass"),
    row<[](const erosion::PassResult& p) { return p.throat_flux_before.half_carried_by; }>(
        "half_carried_by_before", "-", "share of the throats through which half of the flow goes"
    ),
    row<[](const erosion::PassResult& p) { return p.throat_flux_after.half_carried_by; }>(
        "half_carried_by_after", "-", "the same after the pass"
    ),
    row<&erosion::PassResult::reached_target>(
        "reached_target", "", "whether as much has left as `until_eroded` specifies"
    ),
    saved_alone<&erosion::PassResult::flow_after>("flow_after"),
    saved_alone<&erosion::PassResult::probe>("probe"),
    saved_alone<&erosion::PassResult::mobility>("mobility"),
    saved_alone<&erosion::PassResult::constrictions>("constrictions"),
    saved_alone<&erosion::PassResult::merge>("merge"),
    saved_alone<&erosion::PassResult::constrictions_by_merge>("constrictions_by_merge"),
    saved_alone<&erosion::PassResult::transport>("transport"),
    saved_alone<&erosion::PassResult::closed_voids>("closed_voids"),
    saved_alone<&erosion::PassResult::throat_flux_before>("throat_flux_before"),
    saved_alone<&erosion::PassResult::throat_flux_after>("throat_flux_after"),
};

} // namespace suffuse::facts
