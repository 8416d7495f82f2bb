// The verb migrate: fines travel with the water in true time, and what they leave to be read.

#include "suffuse/dem/inspect.hpp"
#include "suffuse/erosion/migration.hpp"
#include "suffuse/io/csv_writer.hpp"
#include "suffuse/record/result_json.hpp"
#include "suffuse/run/mobility_record.hpp"
#include "suffuse/run/stage_work.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

namespace suffuse::run {
namespace {

using nlohmann::json;

/// A time, empty where it never came.
std::string time_field(double time) {
    return time < 0 ? "" : fmt::format("{}", time);
}

/// migration.csv: a row a solution of the flow. Shares are of the mass of all fines.
void write_rows(const std::filesystem::path& folder, const erosion::MigrationResult& result) {
    io::CsvWriter table(
        folder / "migration.csv",
        "time,gradient,permeability,eroded_mass,eroded_mass_share,moving_mass_share,lodged_mass_share,energy"
    );
    for (const erosion::MigrationRow& row : result.rows) {
        table.row(
            row.time, row.gradient, row.permeability, row.eroded_mass, row.eroded_mass / result.fines_mass,
            row.moving_mass / result.fines_mass, row.lodged_mass / result.fines_mass, row.energy
        );
    }
    table.finish();
}

/// Grains that touch each fine grain which is still there, by ids.
std::map<std::uint32_t, std::set<std::uint32_t>> find_holders(const dem::World& world) {
    const grains::Grains& grains = world.grains;
    std::map<std::uint32_t, std::set<std::uint32_t>> holders;
    for (const dem::ContactView& contact : dem::inspect_contacts(world)) {
        for (const auto& [g, other] : {std::pair(contact.i, contact.j), std::pair(contact.j, contact.i)}) {
            if (grains.fine[g] != 0) {
                holders[grains.id[g]].insert(grains.id[other]);
            }
        }
    }
    return holders;
}

/// ledger.csv: a row a fine grain of the sample before.
void write_ledger(const std::filesystem::path& folder, const erosion::Migration& migration, const Vec3& direction) {
    const erosion::MigrationLedger& ledger = migration.ledger;
    const auto holders = find_holders(migration.world);
    io::CsvWriter table(folder / "ledger.csv", "id,d,mass,x0,y0,z0,departed,gradient,left,x,y,z,travel,fate,holders");
    for (std::size_t k = 0; k < ledger.size(); ++k) {
        const auto held_by = holders.find(ledger.id[k]);
        const bool departed = ledger.departed[k] >= 0;
        table.row(
            ledger.id[k], ledger.diameter[k], ledger.mass[k], ledger.start[k], time_field(ledger.departed[k]),
            departed ? fmt::format("{}", ledger.departed_at[k]) : "", time_field(ledger.left[k]), ledger.end[k],
            dot(ledger.end[k] - ledger.start[k], direction) / norm(direction), name_of(ledger.where[k]),
            held_by == holders.end() ? "" : fmt::format("{}", fmt::join(held_by->second, " "))
        );
    }
    table.finish();
}

json numbers_of(const erosion::Migration& migration) {
    using erosion::Whereabouts;
    const erosion::MigrationResult& result = migration.result;
    const double eroded = erosion::eroded_mass(migration.ledger);
    return {
        {"model", model_name(true)},
        {"eroded_mass_share", eroded / result.fines_mass},
        {"eroded_share_of_fines", eroded / result.fines_mass},
        {"eroded_share_of_solids", eroded / migration.solids_mass},
        {"lodged_mass_share", erosion::mass_share(migration.ledger, Whereabouts::Lodged)},
        {"moving_mass_share", erosion::mass_share(migration.ledger, Whereabouts::Moving)},
        {"fixed_mass_share", erosion::mass_share(migration.ledger, Whereabouts::Fixed)},
        {"permeability_before", result.rows.front().permeability},
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
}

/// Says what the user must know to read the numbers.
void note_migration(StageWork& work, const erosion::MigrateSpec& spec, const erosion::Migration& migration) {
    constexpr double wide_overlap = 0.05;
    const std::vector<erosion::MigrationHold>& holds = migration.result.holds;
    const auto cut = std::ranges::find_if(holds, [](const erosion::MigrationHold& hold) { return !hold.ended; });
    if (cut != holds.end()) {
        work.warnings.push_back(fmt::format(
            "{}: at i = {:.3g} motion had not ended after {:.3g} s: {:.2g} % of the fines' mass still moved, and what "
            "erodes from there on is a lower bound; a longer `hold_at_most` holds it longer",
            work.place(), cut->gradient, cut->held_for, 100 * cut->moving_mass_share
        ));
    }
    if (holds.size() < spec.gradients.size() && holds.back().held_for > 0 && !holds.back().ended) {
        work.warnings.push_back(fmt::format(
            "{}: `time_at_most` or `steps_at_most` ended the stage at i = {:.3g}; the {} gradients after it were not "
            "applied",
            work.place(), holds.back().gradient, spec.gradients.size() - holds.size()
        ));
    }
    if (!migration.rested) {
        work.warnings.push_back(fmt::format(
            "{}: the fines had not come to rest under their weight when the flow began: some fall through the skeleton "
            "without any flow",
            work.place()
        ));
    }
    if (migration.largest_overlap > wide_overlap) {
        work.warnings.push_back(fmt::format(
            "{}: fines that moved overlapped by up to {:.2g} % of a radius: contacts are too soft; take a `softness` "
            "below {:.2g}",
            work.place(), 100 * migration.largest_overlap, spec.softness * wide_overlap / migration.largest_overlap
        ));
    }
}

} // namespace

void do_migrate(StageWork& work, const erosion::MigrateSpec& spec) {
    const erosion::MigrationSurroundings around{work.what.fluid, work.control.pulse()};
    erosion::Migration migration;
    if (work.resumed.is_null()) {
        migration = erosion::begin_migration(work.world, spec, around);
    } else {
        migration = work.resumed.at("migration").get<erosion::Migration>();
        migration.world = work.world;
    }
    work.control.save_with([&] { work.save_partial({{"migration", migration}}, migration.world); });
    while (!migration.over) {
        erosion::migrate_on(migration, spec, around);
    }
    work.world = erosion::migrated_sample(migration, around.pulse);
    work.history.record(work.world, true);
    work.numbers.update(numbers_of(migration));
    work.time_step = migration.time_step;
    work.count_steps(migration.steps);
    note_migration(work, spec, migration);
    write_rows(work.folder, migration.result);
    write_ledger(work.folder, migration, spec.direction);
    work.findings.migration = std::move(migration.result);
}

} // namespace suffuse::run
