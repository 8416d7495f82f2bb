// The verb migrate: fines travel with the water in true time, and what they leave to be read.

#include "suffuse/casefile/stack_fields.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/erosion/migration.hpp"
#include "suffuse/io/csv_writer.hpp"
#include "suffuse/record/result_json.hpp"
#include "suffuse/run/migration_numbers.hpp"
#include "suffuse/run/stage_work.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

namespace suffuse::run {
namespace {

/// A time, empty where it never came.
std::string time_field(double time) {
    return time < 0 ? "" : fmt::format("{}", time);
}

/// migration.csv: a row a solution of the flow. Shares are of the mass of all fines.
void write_rows(const std::filesystem::path& folder, const erosion::MigrationResult& result) {
    io::CsvWriter table(
        folder / "migration.csv",
        "time,gradient,sample_gradient,base_gradient,filter_gradient,permeability,eroded_mass,eroded_mass_share,"
        "moving_mass_share,lodged_mass_share,energy,fed_mass"
    );
    for (const erosion::MigrationRow& row : result.rows) {
        table.row(
            row.time, row.gradient, row.sample_gradient, row.base_gradient, row.filter_gradient, row.permeability,
            row.eroded_mass, row.eroded_mass / result.fines_mass, row.moving_mass / result.fines_mass,
            row.lodged_mass / result.fines_mass, row.energy, row.fed_mass
        );
    }
    table.finish();
}

/// profile.csv: a row a slice of a stack, at the beginning and at the end of each gradient. Depths are from where the
/// filter begins, solid fractions of the slice.
void write_profile(const std::filesystem::path& folder, const erosion::MigrationResult& result) {
    const erosion::BaseProfile& profile = result.profile;
    io::CsvWriter table(folder / "profile.csv", "gradient,from,to,base,filter");
    for (std::size_t state = 0; state < profile.base.size(); ++state) {
        const double gradient = state == 0 ? 0 : result.holds[state - 1].gradient;
        for (std::size_t k = 0; k < profile.filter.size(); ++k) {
            const double from = profile.first + static_cast<double>(k) * profile.step;
            table.row(gradient, from, from + profile.step, profile.base[state][k], profile.filter[k]);
        }
    }
    table.finish();
}

/// profile.csv: a row a slice of one soil, before and at the end of each gradient. Distances are from where the water
/// enters the cell.
void write_slices(const std::filesystem::path& folder, const erosion::MigrationResult& result) {
    const erosion::SampleProfile& profile = result.sample;
    io::CsvWriter table(folder / "profile.csv", "gradient,from,to,porosity,fines,permeability");
    for (std::size_t state = 0; state < profile.step.size(); ++state) {
        const double gradient = state == 0 ? 0 : result.holds[state - 1].gradient, step = profile.step[state];
        for (std::size_t k = 0; k < profile.slices; ++k) {
            const double from = static_cast<double>(k) * step;
            table.row(
                gradient, from, from + step, profile.porosity[state][k], profile.fines[state][k],
                profile.permeability[state][k]
            );
        }
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
    io::CsvWriter table(
        folder / "ledger.csv",
        "id,d,mass,entered,x0,y0,z0,departed,gradient,left,x,y,z,travel,throats,narrowest,fate,holders"
    );
    for (std::size_t k = 0; k < ledger.size(); ++k) {
        const auto held_by = holders.find(ledger.id[k]);
        const bool departed = ledger.departed[k] >= 0;
        table.row(
            ledger.id[k], ledger.diameter[k], ledger.mass[k], time_field(ledger.entered[k]), ledger.start[k],
            time_field(ledger.departed[k]), departed ? fmt::format("{}", ledger.departed_at[k]) : "",
            time_field(ledger.left[k]), ledger.end[k],
            dot(ledger.end[k] - ledger.start[k], direction) / norm(direction), ledger.passed[k].count,
            ledger.passed[k].narrowest > 0 ? fmt::format("{}", ledger.passed[k].narrowest) : "",
            name_of(ledger.where[k]), held_by == holders.end() ? "" : fmt::format("{}", fmt::join(held_by->second, " "))
        );
    }
    table.finish();
}

} // namespace

void do_migrate(StageWork& work, const erosion::MigrateSpec& given) {
    erosion::MigrateSpec spec = given;
    spec.stack = casefile::stack_of(work.variant, work.stage) != nullptr;
    const erosion::Surroundings around = work.surroundings();
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
    work.numbers.update(migration_numbers(migration));
    work.time_step = migration.time_step;
    work.count_steps(migration.steps);
    for (const std::string& remark : migration_remarks(migration, spec)) {
        work.warnings.push_back(work.place() + ": " + remark);
    }
    write_rows(work.folder, migration.result);
    write_ledger(work.folder, migration, spec.direction);
    if (spec.stack) {
        write_profile(work.folder, migration.result);
    } else if (migration.result.sample.slices > 0) {
        write_slices(work.folder, migration.result);
    }
    work.findings.migration = std::move(migration.result);
}

} // namespace suffuse::run
