// The verb migrate: fines travel with the water in true time, and what they leave to be read.

#include "suffuse/casefile/stack_fields.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/erosion/migration.hpp"
#include "suffuse/grains/sampling.hpp"
#include "suffuse/io/checkpoint.hpp"
#include "suffuse/io/csv_writer.hpp"
#include "suffuse/record/folder.hpp"
#include "suffuse/record/result_json.hpp"
#include "suffuse/run/migration_numbers.hpp"
#include "suffuse/run/stage_work.hpp"
#include "suffuse/stability/curve.hpp"

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
using Holders = std::map<std::uint32_t, std::set<std::uint32_t>>;

Holders find_holders(const dem::World& world) {
    const grains::Grains& grains = world.grains;
    Holders holders;
    for (const dem::ContactView& contact : dem::inspect_contacts(world)) {
        for (const auto& [g, other] : {std::pair(contact.i, contact.j), std::pair(contact.j, contact.i)}) {
            if (grains.fine[g] != 0) {
                holders[grains.id[g]].insert(grains.id[other]);
            }
        }
    }
    return holders;
}

erosion::GrainStory story_of_one_grain(const erosion::MigrationLedger& ledger, const Holders& holders) {
    const auto passed = std::ranges::max_element(ledger.passed, {}, &erosion::PassedThroats::count);
    if (passed == ledger.passed.end()) {
        return {};
    }
    const auto k = static_cast<std::size_t>(passed - ledger.passed.begin());
    erosion::GrainStory story{
        .id = ledger.id[k],
        .diameter = ledger.diameter[k],
        .departed = ledger.departed[k],
        .gradient = ledger.departed_at[k],
        .way = norm(ledger.end[k] - ledger.start[k]),
        .throats = passed->count,
        .narrowest = passed->narrowest,
        .left = ledger.left[k],
        .moves = ledger.where[k] == erosion::Whereabouts::Moving};
    if (const auto held_by = holders.find(story.id); held_by != holders.end()) {
        story.holders.assign(held_by->second.begin(), held_by->second.end());
    }
    return story;
}

/// Keeps the state for the view over time.
void keep_frame(const StageWork& work, erosion::Migration& migration) {
    std::vector<erosion::MigrationFrame>& frames = migration.result.frames;
    io::Attributes made_by = work.made_by();
    made_by["stage"] += fmt::format(", frame {}", frames.size());
    io::save_world(record::frame_file(work.folder, frames.size()), migration.world, {}, made_by);
    const auto& rows = migration.result.rows;
    frames.push_back({migration.time, rows.empty() ? 0 : rows.back().gradient, migration.scale.factor});
}

/// Goes on to the end, and keeps the states of frames_kept.
void migrate_and_keep_frames(
    const StageWork& work, const erosion::MigrateSpec& spec, const erosion::Surroundings& around,
    erosion::Migration& migration
) {
    const double longest = spec.hold_at_most * static_cast<double>(spec.gradients.size());
    const double interval = std::min(longest, spec.time_at_most.value_or(longest)) / erosion::frames_kept;
    const bool is_kept = work.what.output.snapshots.when != casefile::Snapshots::When::Never;
    if (is_kept && migration.result.frames.empty()) {
        keep_frame(work, migration);
    }
    while (!migration.over) {
        const bool settles = migration.settles; // the skeleton moves, and time does not go on
        const std::size_t holds = migration.result.holds.size();
        erosion::migrate_on(migration, spec, around);
        const bool ends = migration.over || migration.settles || migration.result.holds.size() != holds;
        if (is_kept && !settles && (ends || migration.time >= migration.result.frames.back().time + interval)) {
            keep_frame(work, migration);
        }
    }
}

/// ledger.csv: a row a fine grain of the sample before.
void write_ledger(
    const std::filesystem::path& folder, const erosion::Migration& migration, const Holders& holders,
    const Vec3& direction
) {
    const erosion::MigrationLedger& ledger = migration.ledger;
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

/// Grains above a gap let those below it pass between them, so a filter must hold the finer part; rules leave the
/// coarser one out, too (stability/filter_between.hpp).
std::optional<double> fine_end_of_gap(const grains::Soil& base) {
    const auto gap = stability::find_finest_gap(base.measured ? *base.measured : grains::specified_grading(base));
    return gap ? std::optional(gap->fine_end) : std::nullopt;
}

} // namespace

void do_migrate(StageWork& work, const erosion::MigrateSpec& given) {
    erosion::MigrateSpec spec = given;
    if (const packing::PackSpec* stack = casefile::stack_of(work.variant, work.stage)) {
        spec.stack = true;
        spec.base_gap = fine_end_of_gap(work.what.soils.at(stack->layers.front().soil));
    }
    const erosion::Surroundings around = work.surroundings();
    erosion::Migration migration;
    if (work.resumed.is_null()) {
        migration = erosion::begin_migration(work.world, spec, around);
    } else {
        migration = work.resumed.at("migration").get<erosion::Migration>();
        migration.world = work.world;
    }
    work.control.save_with([&] { work.save_partial({{"migration", migration}}, migration.world); });
    migrate_and_keep_frames(work, spec, around, migration);
    const Holders holders = find_holders(migration.world);
    migration.result.fates = {migration.ledger.id, migration.ledger.where};
    migration.result.story = story_of_one_grain(migration.ledger, holders);
    work.world = erosion::migrated_sample(migration, around.pulse);
    work.history.record(work.world, true);
    work.numbers.update(migration_numbers(migration));
    work.time_step = migration.time_step;
    work.count_steps(migration.steps);
    for (const std::string& remark : migration_remarks(migration, spec)) {
        work.warnings.push_back(work.place() + ": " + remark);
    }
    write_rows(work.folder, migration.result);
    write_ledger(work.folder, migration, holders, spec.direction);
    if (spec.stack) {
        write_profile(work.folder, migration.result);
    } else if (migration.result.sample.slices > 0) {
        write_slices(work.folder, migration.result);
    }
    work.findings.migration = std::move(migration.result);
}

} // namespace suffuse::run
