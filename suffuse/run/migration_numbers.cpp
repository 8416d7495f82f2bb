#include "suffuse/run/migration_numbers.hpp"

#include "suffuse/base/words.hpp"
#include "suffuse/record/or_null.hpp"
#include "suffuse/record/result_json.hpp"
#include "suffuse/run/mobility_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace suffuse::run {

namespace {

/// Of the mass of all fines before.
double fixed_share(const erosion::Migration& migration) {
    const std::vector<double>& mass = migration.ledger.mass;
    const double all = std::accumulate(mass.begin(), mass.end(), 0.0);
    return mass_of(migration.ledger, erosion::Whereabouts::Fixed) / (all - migration.fed_mass);
}

/// Of layers.
nlohmann::json stack_numbers(const erosion::Migration& migration) {
    const erosion::Stack& stack = migration.stack;
    const erosion::LayerHeads &first = migration.at_first, &now = migration.now;
    const std::vector<erosion::MigrationRow>& rows = migration.result.rows;
    const double resting = migration.result.resting_permeability;
    return {
        {"base_thickness", stack.base_thickness()},
        {"filter_thickness", stack.filter_thickness()},
        {"exit", stack.exit - stack.face},
        {"screen_mass_share", fixed_share(migration)},
        {"base_permeability", resting / first.base},
        {"filter_permeability", resting / first.filter},
        {"interface_head_share", first.interface},
        {"interface_head_share_after", now.interface},
        {"base_permeability_after", rows.back().permeability / now.base},
        {"filter_permeability_after", rows.back().permeability / now.filter},
        {"filter_d15", migration.result.filter.filter_d15},
        {"base_d85", migration.result.filter.base_d85},
        {"base_gap", or_null(migration.result.filter.base_gap)},
        {"passed_mass_share", migration.result.filter.passed},
        {"size_ratio", migration.result.filter.filter_d15 / migration.result.filter.base_d85},
        {"controlling_constriction", migration.result.filter.constriction},
        {"largest_eroded", migration.result.filter.largest_eroded},
        {"base_stress", dem::mean_stress(migration.stress) / migration.scale.factor},
        {"ended", migration.result.holds.back().ended}};
}

/// What had entered with the water by the end of hold `k` [kg].
double fed_until(const erosion::MigrationResult& result, std::size_t k) {
    constexpr double rounding = 1 + 1e-9;
    double end = 0, fed = 0;
    for (std::size_t before = 0; before <= k; ++before) {
        end += result.holds[before].held_for;
    }
    for (const erosion::MigrationRow& row : result.rows) {
        fed = row.time <= rounding * end ? row.fed_mass : fed;
    }
    return fed;
}

std::string percent(double share) {
    return short_number(100 * share, 2) + " %";
}

/// Gradients whose motion had not ended, and what could hold them longer.
void remark_on_cuts(const erosion::MigrationResult& result, std::vector<std::string>& remarks) {
    const std::vector<erosion::MigrationHold>& holds = result.holds;
    const auto cut = std::ranges::find(holds, false, &erosion::MigrationHold::ended);
    if (cut == holds.end()) {
        return;
    }
    const auto cuts = std::ranges::count(holds, false, &erosion::MigrationHold::ended);
    const double fines = result.fines_mass, fed = fed_until(result, static_cast<std::size_t>(cut - holds.begin()));
    remarks.push_back(fmt::format(
        "at i = {:.3g}{} motion had not ended after {:.3g} s: {} of the fines' mass{} still moved, and what erodes at "
        "that gradient is a lower bound; a larger `{}` holds it longer",
        cut->gradient, cuts > 1 ? fmt::format(", the first of {} such gradients,", cuts) : "", cut->held_for,
        percent(cut->moving_mass_share * fines / (fines + fed)), fed > 0 ? ", with what the water brought," : "",
        name_of(cut->ended_by)
    ));
}

} // namespace

nlohmann::json migration_numbers(const erosion::Migration& migration) {
    using erosion::Whereabouts;
    const erosion::MigrationResult& result = migration.result;
    const auto of_fines = [&](Whereabouts where) { return mass_of(migration.ledger, where) / result.fines_mass; };
    nlohmann::json numbers{
        {"model", model_name(true)},
        {"eroded_mass_share", of_fines(Whereabouts::Eroded)},
        {"eroded_share_of_fines", of_fines(Whereabouts::Eroded)},
        {"eroded_share_of_solids", own_eroded_mass(migration.ledger) / migration.solids_mass},
        {"lodged_mass_share", of_fines(Whereabouts::Lodged)},
        {"moving_mass_share", of_fines(Whereabouts::Moving)},
        {"fixed_mass_share", fixed_share(migration)},
        {"fed_mass_share", migration.fed_mass / result.fines_mass},
        {"permeability_before", result.resting_permeability},
        {"permeability_after", result.rows.back().permeability},
        {"seconds", migration.time},
        {"flow_energy", migration.energy},
        {"holds", result.holds},
        {"rested", migration.rested},
        {"weight_scale", migration.scale.factor},
        {"hindrance", migration.hindrance},
        {"largest_overlap", migration.largest_overlap},
        {"flows", result.rows.size()},
        {"steps", migration.steps}};
    if (migration.stack.is_stack()) {
        numbers["stack"] = stack_numbers(migration);
    }
    return numbers;
}

std::vector<std::string> migration_remarks(const erosion::Migration& migration, const erosion::MigrateSpec& spec) {
    std::vector<std::string> remarks;
    constexpr double wide_overlap = 0.05;
    const std::vector<erosion::MigrationHold>& holds = migration.result.holds;
    remark_on_cuts(migration.result, remarks);
    if (migration.cut_by != erosion::HoldEnd::None) {
        remarks.push_back(fmt::format(
            "`{}` ended the stage at i = {:.3g}; the {} gradients after it were not applied", name_of(migration.cut_by),
            holds.back().gradient, spec.gradients.size() - holds.size()
        ));
    }
    if (holds.back().failed) {
        remarks.push_back(fmt::format(
            "after i = {:.3g} the skeleton does not carry its stresses any more, which ends the stage",
            holds.back().gradient
        ));
    }
    if (migration.feeding.waiting > *std::ranges::max_element(migration.ledger.mass)) {
        remarks.push_back(fmt::format(
            "{:.2g} kg of fines that the water brought had not entered when the stage ended: the face where it enters "
            "had no free place for them; a lower `feed` does not block it",
            migration.feeding.waiting
        ));
    }
    if (!migration.rested) {
        remarks.push_back(
            "the fines had not come to rest under their weight when the flow began: some fall through the skeleton "
            "without any flow"
        );
    }
    if (migration.largest_overlap > wide_overlap) {
        remarks.push_back(fmt::format(
            "fines that moved overlapped by up to {} of a radius: contacts are too soft; take a `softness` "
            "below {:.2g}",
            percent(migration.largest_overlap), spec.softness * wide_overlap / migration.largest_overlap
        ));
    }
    return remarks;
}

} // namespace suffuse::run
