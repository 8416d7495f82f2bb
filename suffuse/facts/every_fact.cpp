#include "suffuse/facts/every_fact.hpp"

#include "suffuse/facts/migration.hpp"
#include "suffuse/facts/mobility.hpp"
#include "suffuse/facts/pass.hpp"
#include "suffuse/facts/state.hpp"
#include "suffuse/facts/test.hpp"

#include <fmt/format.h>

#include <iterator>

namespace suffuse::facts {
namespace {

template <class... Rows>
std::vector<Fact> facts_of(const Rows&... rows) {
    std::vector<Fact> facts;
    const auto keep = [&](const Fact& fact) {
        if (!fact.key.empty()) {
            facts.push_back(fact);
        }
    };
    (for_each_row(rows, keep), ...);
    return facts;
}

std::vector<Fact> joined(std::vector<Fact> first, const std::vector<Fact>& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

// What single stages write by themselves.

const std::vector<Fact> of_every_stage = {
    {"stage", "", "name", "", Kind::Origin},
    {"verb", "", "`do` of the case", ""},
    {"sample", "", "folder of its sample in `studies/`", "", Kind::Origin},
    {"steps", "-", "time steps; 0 where a stage makes none", "", Kind::Computation},
    {"time_step", "s", "of the last steps (of an erosion: of its probe); 0 where a stage makes no steps", "",
     Kind::Computation},
    {"wall_seconds", "s", "over all parts of the stage, however often it was resumed", "", Kind::Origin},
    {"particle_steps_per_second", "1/s", "all grain steps of the stage over these seconds", "", Kind::Origin},
    {"inertial_number_max", "-", "over the rows of the history", "", Kind::Computation},
    {"checksums", "-", "how many files `SHA256SUMS` in its folder lists; a stage of an earlier version has neither", "",
     Kind::Origin},
    {"end_state", "",
     "16 hexadecimal digits: of all that a later stage can take from the state, storage order included; no stage is "
     "computed from a `state.h5` that has others",
     "", Kind::Origin},
    {"key", "",
     "which stage this is: `FORM:KEY`, KEY the SHA-256 of all that decides its numbers (settings of the stage, sample, "
     "seed, imported files, `start_state`; names have no part in it). A stage with another KEY than the run's case "
     "gives is refused. "
     "FORM is that of the keys and defaults of cases; keys of two forms are not compared. `state.h5`, `pass-K.h5` and "
     "`partial.h5` have it as the attribute `key` of the file",
     "", Kind::Origin},
    {"commit", "", "of the program that computed the stage", "", Kind::Origin},
    {"start_state", "",
     "`end_state` of the stage that it was computed from; where that one now has another, the two do not belong "
     "together, and `resume` and `report` say so",
     "", Kind::Origin},
    {"from_cache", "", "true where the stage was taken from the cache; its `wall_seconds` are those of the computation",
     "", Kind::Origin},
    {"warnings", "", "texts", "", Kind::Origin},
    {"flaws", "", "texts; a flaw is a quality bar that was missed (exit code 4)", "", Kind::Origin},
    {"measured", "", "where the stage has the key `measure`: each name → its numbers, below", ""},
};

const std::vector<Fact> of_import = {
    {"imported", "", "true", ""},
    {"imported_files", "",
     "SHA-256 of the files that were read, by `packing` and `contacts`; `run` and `resume` refuse others", "",
     Kind::Origin},
    {"imported_overlap_ratio", "-", "largest overlap / smaller radius, of the file", ""},
    {"imported_contacts", "-", "contacts whose shear forces and moments a file gave", ""},
};

const std::vector<Fact> of_pack = {
    {"grading_largest_difference", "-", "largest difference of percent passing, as a fraction, between sample and soil",
     ""},
    {"grading_tolerance", "-", "that the case allows", ""},
    {"fines_content_reached", "-", "by mass", ""},
    {"kenney_lau_split", "m", "with `fines_auto = \"kenney-lau\"`; or null", ""},
};

const std::vector<Fact> of_compact = {
    {"protocol", "", "`faithful`, `swift`, `slow`, `wide`", ""},
    {"start_porosity", "-", "when the first step was made", ""},
    {"void_ratio_compacted", "-", "before the final parameters", ""},
    {"preparation_friction", "rad", "with `void_ratio` or `intergranular_void_ratio`: found for it", ""},
    {"preparation_adhesion.normal", "Pa", "found for it", ""},
    {"preparation_adhesion.shear", "Pa", "found for it", ""},
    {"preparation_start_porosity", "-", "found for it, by `swift`", ""},
    {"preparation_trials", "-", "compactions of the search", ""},
    {"void_ratio_asked", "-", "the specified void ratio", ""},
    {"steps_of_trials", "-", "of the search; `steps` are the last one's", ""},
    {"prepared_as", "", "the sample whose preparation was taken", ""},
    {"skeleton.void_ratio", "-", "with `skeleton_first`: of the coarse grains alone", ""},
    {"skeleton.steps", "-", "theirs; `steps` of the stage are all", ""},
    {"skeleton.widening", "-", "of the cell's edges, for the fines to fit", ""},
};

const std::vector<Fact> of_triaxial = {
    {"strain_rate", "1/s", "axial", ""},
    {"inertia", "", "`lent` or `own`: that of the grains during the test", ""},
    {"skempton_b", "-",
     "undrained triaxial and cyclic tests: Skempton's B, 1 without `bulk_modulus` of `[fluid]`; `stiffness`: only with "
     "it",
     ""},
};

const std::vector<Fact> of_rows = {
    {"rows", "", "of its curve, each an object of the numbers below", ""},
};

const std::vector<Fact> of_shear_row = {
    {"shear_strain", "-", "displacement of the top over the height at the start", ""},
    {"shear_stress", "Pa", "along the planes that slide", ""},
    {"normal_stress", "Pa", "across them", ""},
    {"void_ratio", "-", "of the cell", ""},
};

const std::vector<Fact> of_cyclic_row = {
    {"cycle", "-", "completed before the row, in halves", ""},
    {"axial_strain", "-", "since the start", ""},
    {"deviator_stress", "Pa", "axial minus mean lateral stress", ""},
    {"mean_stress", "Pa", "effective", ""},
    {"pore_pressure_ratio", "-", "excess pore pressure over the lateral stress at the start", ""},
};

const std::vector<Fact> of_instability = {
    {"q", "Pa", "deviator stress", ""},
    {"p", "Pa", "mean stress", ""},
    {"strain", "-", "axial", ""},
};

const std::vector<Fact> of_energy = {
    {"work", "J/m3", "done on the sample", ""},
    {"springs", "J/m3", "held more than at the start", ""},
    {"motion", "J/m3", "held more than at the start", ""},
    {"slip", "J/m3", "taken", ""},
    {"rolling", "J/m3", "taken", ""},
    {"damping", "J/m3", "taken", ""},
};

const std::vector<Fact> of_stress_probe = {
    {"stress_probed", "Pa", "three numbers, along the axes of the cell", ""},
    {"drift", "-", "[stress probes](theory/stress-probes.md)", ""},
};

const std::vector<Fact> of_stress_probes = {
    {"angle", "rad", "of the increment, in the plane of lateral and axial stress", ""},
    {"stress", "Pa", "reached beyond the state probed, along the axes", ""},
    {"strain", "-", "along the axes, compression positive", ""},
    {"second_order_work", "J/m3", "stress · strain", ""},
    {"normalized", "-", "the same over the product of the norms, −1 to 1", ""},
    {"answer", "", "`rests`, `creeps`, `fails`", ""},
    {"steps", "-", "of the probe", ""},
};

const std::vector<Fact> of_flow = {
    {"gradient", "-", "hydraulic gradient", "", Kind::Result, {"hydraulic gradient", "i", "-"}},
    {"permeability",
     "m2",
     "along the direction; the 3 × 3 tensor where `tensor = true`",
     "",
     Kind::Result,
     {"permeability", "k", "m²"}},
    {"permeability_along", "m2", "along the direction, where `permeability` is the tensor", ""},
    {"mean_velocity", "m/s", "superficial", ""},
    {"tortuosity",
     "-",
     "mean speed from pore to pore over that of the mean motion; null at a gradient of 0",
     "",
     Kind::Result,
     {"tortuosity", "", "-"}},
    {"reynolds_number", "-", "of the mean velocity along the gradient and the Sauter diameter", ""},
    {"pressure_gradient", "Pa/m", "", ""},
    {"force_sum", "N", "of the water on the grains", ""},
    {"force_sum_error", "-", "relative to −V grad p", "", Kind::Computation},
    {"half_carried_by", "-",
     "share of the throats through which half of the flow goes; throats without a void are left out", ""},
    {"residual", "-", "of the solution", "", Kind::Computation},
    {"pores", "-", "number", ""},
    {"throats", "-", "number", ""},
    {"hidden_grains", "-", "buried in others: no pore touches them", ""},
    {"seconds", "s",
     "`triangulate`, `conductance`, `set_up`, `solve`, `forces`; the network's geometry counts as conductance", "",
     Kind::Origin},
    {"network_permeability", "m2", "where the flow was resolved: the network's", ""},
    {"resolved", "", "where the flow was resolved: below", ""},
};

const std::vector<Fact> of_resolved = {
    {"permeability", "m2", "of the flow between the grains themselves, as above", ""},
    {"permeability_along", "m2", "as above", ""},
    {"finer_permeability", "m2", "of the finer of its two grids, before extrapolation", ""},
    {"mean_velocity", "m/s", "superficial", ""},
    {"force_sum", "N", "of the water on the grains", ""},
    {"force_difference", "-",
     "root mean square of the network's forces less these, over that of these; null at a gradient of 0", ""},
    {"boxes", "-", "three numbers", ""},
    {"spacing", "m", "of the grid", ""},
    {"across_smallest", "-", "spacings across the smallest grain", ""},
    {"iterations", "-", "of the solver", ""},
    {"residual", "-", "of the solution", ""},
    {"seconds", "s", "", ""},
};

const std::vector<Fact> of_detach = {
    {"model", "", "`with weight` or `weightless`", ""},
    {"probes", "", "weightless: one object a gradient, below", ""},
};

const std::vector<Fact> of_mobility = {
    {"mobility", "", "one object a gradient of the ramp, its refinement included, below", ""},
    {"factor_of_safety_at_least", "-",
     "where the factor is null: the last gradient of the ramp below heave at which motion ended, over the specified "
     "one",
     ""},
};

const std::vector<Fact> of_mobility_step = {
    {"floats", "", "whether the gradient is at or above heave", ""},
};

const std::vector<Fact> of_erode = {
    {"model", "", "`with weight` or `weightless`", ""},
    {"own_rule", "", "`name`, `source`: of a stage whose detachment rule is a function of Python", ""},
    {"eroded_share_of_fines", "-", "mass that has left / mass of the fines before the first pass", ""},
    {"eroded_share_of_solids", "-", "mass that has left / mass of all grains before the first pass", ""},
    {"passes", "", "one object a pass, below", ""},
};

const std::vector<Fact> of_pass_with_water = {
    {"flow_before", "", "of the flow whose forces the probe had: the five keys of its source", ""},
    {"flow_after", "", "the same after the pass", ""},
    {"probe", "", "weightless: below", ""},
    {"transport", "", "where grains travel: below", ""},
};

const std::vector<Fact> of_remove = {
    {"removed", "-", "grains of all passes", ""},
    {"removed_mass_share", "-", "of the mass before", ""},
    {"coordination_histogram", "-", "number of contacts → number of removed grains that had so many", ""},
    {"stress_before", "Pa", "3 × 3, before the first pass", ""},
    {"stress_constant_volume", "Pa", "3 × 3, at rest at constant volume in the last pass", ""},
    {"stress_after", "Pa", "3 × 3, at the end", ""},
    {"stress_ratio_before", "-", "q/p with q between the axes of the cell", ""},
    {"stress_loss", "-", "of the mean stress at constant volume in the last pass", ""},
    {"strain", "-", "of the three edges", ""},
    {"largest_strain", "-", "of the three, in size", ""},
    {"volumetric_strain", "-", "of all passes", ""},
    {"porosity_before", "-", "before the first pass", ""},
    {"porosity_after_removal", "-", "before the skeleton moves in the last pass", ""},
    {"failed", "", "whether in a pass an edge strained by more than `max_strain`, or the skeleton found no rest", ""},
    {"passes", "", "one object a pass, below", ""},
};

const std::vector<Fact> of_stack = {
    {"base_thickness", "m", "from where the water enters to where the filter begins", ""},
    {"filter_thickness", "m", "of all layers behind the base", ""},
    {"exit", "m", "plane by which base grains leave, from where the water enters", ""},
    {"screen_mass_share", "-", "of the base's mass: held where the water enters", ""},
    {"base_permeability", "m2", "from the heads within it, while nothing has moved", ""},
    {"filter_permeability", "m2", "likewise", ""},
    {"interface_head_share", "-",
     "of the whole head: lost from half of the largest base grain before the filter to its largest grain behind its "
     "face",
     ""},
    {"interface_head_share_after", "-",
     "the same of the last solution: what base grains in the filter's face take adds to it", ""},
    {"base_permeability_after", "m2",
     "of the last solution, by all the head that is lost in the base: among its grains and by those that move", ""},
    {"filter_permeability_after", "m2", "likewise", ""},
    {"filter_d15", "m", "15 % of the filter's mass are finer", ""},
    {"base_d85", "m", "85 % of the base's mass are finer; of a base with a gap, of the part below it", ""},
    {"base_gap", "m", "fine end of that gap; null without one", ""},
    {"passed_mass_share", "-", "of the base's mass without the screen, or of that of the same part: crossed `exit`",
     ""},
    {"size_ratio", "-", "D15 of the filter over d85 of the base", ""},
    {"controlling_constriction", "m",
     "of the filter without its base: diameter of the largest sphere that finds a way through", ""},
    {"largest_eroded", "m", "diameter of the largest base grain that left; 0 where none did", ""},
    {"base_stress", "Pa", "mean stress of the sample over K: what presses the base, whose contacts are softer by K",
     ""},
    {"ended", "", "whether motion ended at the last gradient", ""},
};

const std::vector<Fact> of_layers = {
    {"soil", "", "name of the soil", ""},
    {"grains", "-", "drawn of it", ""},
    {"mass", "kg", "of them", ""},
    {"thickness", "m", "specified, settled at a porosity of 0.4", ""},
    {"grading_largest_difference", "-", "of percent passing between the layer and its grading", ""},
};

const std::vector<Fact> of_migrate = {
    {"model", "", "`with weight`", ""},
    {"eroded_mass_share", "-",
     "mass that crossed `exit`, with what the water had brought / mass of the fines before, in layers without the "
     "screen",
     ""},
    {"eroded_share_of_fines", "-", "the same", ""},
    {"eroded_share_of_solids", "-", "mass of the sample's own grains that crossed `exit` / mass of all grains before",
     ""},
    {"lodged_mass_share", "-", "of the fines' mass before: moved by half a diameter, and rests elsewhere", ""},
    {"moving_mass_share", "-", "of that mass: was moving when the stage ended", ""},
    {"fixed_mass_share", "-",
     "of the mass of all fines before: carries the skeleton's forces, or is the screen of layers, and was held", ""},
    {"fed_mass_share", "-", "mass that entered with the water by `feed` / mass of the fines before", ""},
    {"permeability_before", "m2", "along the flow, with all fines at rest", ""},
    {"permeability_after", "m2",
     "of the last solution, among grains that do not go with the water, as those that do slow it down", ""},
    {"seconds", "s", "of the soil's own time, over all gradients", ""},
    {"flow_energy", "J", "spent by the flow, the integral of rho g Q i L", ""},
    {"holds", "", "one object a gradient, below", ""},
    {"stack", "", "of layers: below", ""},
    {"rested", "", "whether the fines came to rest under their weight before the flow", ""},
    {"weight_scale", "-", "K, by which contacts are softer than the soil's", ""},
    {"hindrance", "-", "drag over Stokes', of the median resting fine grain in the last solution", ""},
    {"largest_overlap", "-", "over the smaller radius, of a grain that moved", ""},
    {"flows", "-", "solutions of the flow", "", Kind::Computation},
};

const std::vector<Fact> of_removal_pass = {
    {"stress_loss", "-", "of the mean stress at constant volume", ""},
};

const std::vector<Fact> of_measured = {
    {"permeability.mean", "m2", "`permeability`: a third of the trace", ""},
    {"permeability.tensor", "m2", "`permeability`: 3 × 3", ""},
    {"constrictions.mean", "m", "`constrictions`, of the coarse grains", ""},
    {"constrictions.median", "m", "of them", ""},
    {"constrictions.d35", "m", "35 % of them are smaller", ""},
    {"constrictions.count", "-", "their number", ""},
    {"grading.d10", "m", "`grading`, by mass", ""},
    {"grading.d30", "m", "", ""},
    {"grading.d50", "m", "", ""},
    {"grading.d60", "m", "", ""},
    {"grading.smallest", "m", "", ""},
    {"grading.largest", "m", "", ""},
    {"grading.uniformity", "-", "d60/d10", ""},
    {"volumetric-strain.volumetric_strain", "-", "`volumetric-strain`: of this stage, logarithmic", ""},
};

// Columns of tables, by unit; what is not here is a share, a ratio, a count or a text. Within an object that has a unit
// a count says so.

const std::vector<Fact> of_tables = {
    {"x", "m", "", ""},
    {"y", "m", "", ""},
    {"z", "m", "", ""},
    {"r", "m", "", ""},
    {"d", "m", "", ""},
    {"diameter", "m", "", ""},
    {"radius", "m", "", ""},
    {"overlap", "m", "", ""},
    {"hydraulic_radius", "m", "", ""},
    {"length", "m", "", ""},
    {"constriction", "m", "", ""},
    {"inscribed_radius", "m", "", ""},
    {"travel", "m", "", ""},
    {"progress", "m", "", ""},
    {"path", "m", "", ""},
    {"area", "m2", "", ""},
    {"volume", "m3", "", ""},
    {"void_volume", "m3", "", ""},
    {"flux", "m3/s", "", ""},
    {"vx", "m/s", "", ""},
    {"vy", "m/s", "", ""},
    {"vz", "m/s", "", ""},
    {"wx", "rad/s", "", ""},
    {"wy", "rad/s", "", ""},
    {"wz", "rad/s", "", ""},
    {"fx", "N", "", ""},
    {"fy", "N", "", ""},
    {"fz", "N", "", ""},
    {"fnx", "N", "", ""},
    {"fny", "N", "", ""},
    {"fnz", "N", "", ""},
    {"fsx", "N", "", ""},
    {"fsy", "N", "", ""},
    {"fsz", "N", "", ""},
    {"tx", "N m", "", ""},
    {"ty", "N m", "", ""},
    {"tz", "N m", "", ""},
    {"mx", "N m", "", ""},
    {"my", "N m", "", ""},
    {"mz", "N m", "", ""},
    {"mass", "kg", "", ""},
    {"pressure", "Pa", "", ""},
    {"axial_stress", "Pa", "", ""},
    {"stress_1", "Pa", "", ""},
    {"stress_2", "Pa", "", ""},
    {"stress_3", "Pa", "", ""},
    {"time", "s", "", ""},
    {"fc", "%", "", ""},
    {"count", "-", "", ""},
    {"axial_strain", "-", "", "", Kind::Result, {"axial strain", "ε₁", "%", 3}},
};

std::vector<Group> make_groups() {
    return {
        {"Every stage", "", joined(of_every_stage, facts_of(state))},
        {"Where grains touch", "", facts_of(network)},
        {"Soils with a fine fraction ([measures](theory/measures.md); null where a sample lacks the fraction)", "",
         facts_of(fines)},
        {"`import`", "", of_import},
        {"`pack`", "", of_pack},
        {"`layers` of `pack`", "layers", of_layers},
        {"`compact`", "", of_compact},
        {"Laboratory tests", "", of_triaxial},
        {"`response` of `triaxial` and `plane-strain`", "response", facts_of(response)},
        {"`oedometer` and `isotropic`", "", facts_of(compression)},
        {"`shear`", "", facts_of(shear)},
        {"`cyclic`", "", facts_of(cyclic)},
        {"`shear` and `cyclic`", "", of_rows},
        {"A row of `shear`", "rows", of_shear_row},
        {"A row of `cyclic`", "rows", of_cyclic_row},
        {"`instability` of a response", "instability", of_instability},
        {"`energy` of a response", "energy", of_energy},
        {"`stress-probe`", "", of_stress_probe},
        {"`stress_probes`, an object a direction", "stress_probes", of_stress_probes},
        {"`stiffness`", "", facts_of(stiffness)},
        {"Source of a flow: `flow`, `detach`, and `flow_before` and `flow_after` of a pass", "", facts_of(flow_source)},
        {"`flow`", "", of_flow},
        {"`resolved` of `flow`", "resolved", of_resolved},
        {"`detach`", "", of_detach},
        {"`probes` of `detach` and `probe` of a pass", "probe", facts_of(probe)},
        {"`detach` with weight, `erode` with weight and its passes ([theory](theory/weight.md))", "",
         joined(joined(of_mobility, facts_of(mobility)), facts_of(mobility_at_gradient))},
        {"`mobility`, an object a gradient", "mobility", joined(facts_of(mobility_step), of_mobility_step)},
        {"`erode`", "", of_erode},
        {"`remove`", "", of_remove},
        {"`migrate` ([theory](theory/migration.md))", "", of_migrate},
        {"`stack` of `migrate`", "stack", of_stack},
        {"`holds` of `migrate`, an object a gradient", "holds", facts_of(migration_hold)},
        {"`passes` of `erode` and `remove`, an object a pass", "passes", facts_of(pass)},
        {"`passes` of `erode`, beyond that", "passes", joined(facts_of(pass_with_water), of_pass_with_water)},
        {"`passes` of `remove`, beyond that", "passes", of_removal_pass},
        {"`transport` of a pass", "transport", facts_of(transport)},
        {"`measured`", "measured", of_measured},
        {"Columns of tables", std::string(columns_of_tables), of_tables},
    };
}

} // namespace

const std::vector<Group>& every_group() {
    static const std::vector<Group> groups = make_groups();
    return groups;
}

std::string results_markdown() {
    std::string text = "# Results of a stage\n\nEvery key of `stage.json`, printed by `suffuse schema --results`. "
                       "Numbers are in SI units; - marks "
                       "shares, ratios and counts. Compression is positive. What could not be measured is null.\n";
    auto out = std::back_inserter(text);
    for (const Group& group : every_group()) {
        if (group.within == columns_of_tables) {
            continue;
        }
        fmt::format_to(out, "\n## {}\n\n| key | unit | |\n|---|---|---|\n", group.title);
        for (const Fact& fact : group.facts) {
            fmt::format_to(out, "| `{}` | {} | {} |\n", fact.key, fact.unit, fact.words);
        }
    }
    return text;
}

} // namespace suffuse::facts
