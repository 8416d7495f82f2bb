#include "suffuse/run/sample_run.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/version.hpp"
#include "suffuse/casefile/prepared_as.hpp"
#include "suffuse/casefile/wide_checks.hpp"
#include "suffuse/io/checkpoint.hpp"
#include "suffuse/io/folders.hpp"
#include "suffuse/io/tables.hpp"
#include "suffuse/io/vtk.hpp"
#include "suffuse/record/documents.hpp"
#include "suffuse/record/earlier_endings.hpp"
#include "suffuse/record/folder.hpp"
#include "suffuse/record/known_state.hpp"
#include "suffuse/record/result_json.hpp"
#include "suffuse/record/stage_key.hpp"
#include "suffuse/record/stage_start.hpp"
#include "suffuse/record/stage_sums.hpp"
#include "suffuse/record/stored.hpp"
#include "suffuse/record/stored_findings.hpp"
#include "suffuse/run/grain_pictures.hpp"
#include "suffuse/run/measure.hpp"
#include "suffuse/run/picture_series.hpp"
#include "suffuse/run/preparation_found.hpp"
#include "suffuse/run/requested_measures.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

namespace suffuse::run {
namespace {

using nlohmann::json;

/// A file that means nothing next to a finished stage; it may as well stay where it cannot be removed.
void drop(const std::filesystem::path& file) {
    std::error_code error;
    std::filesystem::remove(file, error);
}

/// What a program of another version saved in the middle of a stage may have other names, or mean something else.
IoError strange_partial(const StageWork& work) {
    return IoError(fmt::format(
        "{0}: does not hold what this version, commit {1}, needs to go on with the stage; go on with the version that "
        "wrote it, or remove {0} and resume: the stage then begins anew",
        (work.folder / record::partial_file).string(), commit()
    ));
}

/// What the stage in `folder` ended with.
dem::World end_of(const std::filesystem::path& folder) {
    const record::KnownState end(folder / "state.h5");
    dem::World world = end.load().world;
    const json numbers = record::read_json(folder / "stage.json");
    end.check(world, record::take_from(folder / "stage.json", [&] { return numbers.value("end_state", ""); }));
    return world;
}

void take_up(StageWork& work) {
    const record::KnownState left(work.folder / record::partial_file, work.folder / record::partial_file);
    io::Checkpoint partial = left.load();
    try {
        const json saved = record::parse_cbor(partial.unfinished);
        left.check(partial.world, saved.value("world", ""));
        if (record::compare_keys(saved.value("key", ""), work.key) == record::SameStage::No) {
            left.refuse_other();
        }
        work.start = std::exchange(work.world, std::move(partial.world));
        work.pictures = StrainPictures(work.what.output, work.folder, work.world);
        work.history.restore(saved.at("history"));
        work.grain_steps = saved.at("grain_steps");
        work.earlier_seconds = saved.at("seconds");
        work.resumed = saved.at("state");
        if (const std::string writer = saved.value("commit", "unknown"); writer != commit()) {
            work.has_two_makers = true;
            work.warnings.push_back(fmt::format(
                "{}: begun by commit {} and continued by commit {}; its numbers may match neither version",
                work.place(), writer, commit()
            ));
        }
    } catch (const json::exception&) {
        throw strange_partial(work);
    }
}

/// The verb itself; what it saved is read there.
void do_stage_or_go_on(StageWork& work) {
    const bool goes_on = !work.resumed.is_null();
    try {
        do_stage(work);
    } catch (const json::exception&) {
        if (!goes_on) {
            throw;
        }
        throw strange_partial(work);
    }
}

/// stage.json, but for what is said of the whole run.
json describe_stage(StageWork& work) {
    json numbers = measure_state(work.world, record::has_fractions(work.variant));
    numbers["steps"] = 0;
    numbers.update(work.numbers);
    if (!work.stage.measure.empty()) {
        numbers["measured"] = requested_measures(work, numbers);
    }
    const double seconds = work.seconds();
    numbers["stage"] = work.stage.name;
    numbers["sample"] = work.variant.folder;
    if (!work.start_state.empty()) {
        numbers["start_state"] = work.start_state;
    }
    numbers["key"] = work.key;
    numbers["commit"] = commit();
    numbers["verb"] = casefile::verb_of(work.stage.spec);
    numbers["time_step"] = work.time_step;
    numbers["wall_seconds"] = seconds;
    numbers["particle_steps_per_second"] = seconds > 0 ? static_cast<double>(work.grain_steps) / seconds : 0.0;
    numbers["inertial_number_max"] = work.history.largest_inertial_number();
    const double overlap = numbers["max_overlap_ratio"];
    const bool is_wide = numbers.value("protocol", "") == packing::name_of(packing::Protocol::Wide);
    const double notable = is_wide ? casefile::good_squeezed : notable_overlap; // which is what wide promises
    if (const std::string words = words_on_overlap(overlap, work.world.material, notable); !words.empty()) {
        (overlap > largest_good_overlap ? work.flaws : work.warnings).push_back(work.place() + ": " + words);
    }
    numbers["end_state"] = record::describe_state(work.world);
    numbers["warnings"] = work.warnings;
    numbers["flaws"] = work.flaws;
    return numbers;
}

void write_pictures(const StageWork& work, const casefile::OutputSpec& output) {
    std::vector<io::GrainColumn> further = work.pictured;
    if (!work.mobile_gradient.empty()) {
        further.push_back({"mobile_gradient", 1, work.mobile_gradient});
    }
    write_grain_pictures(work.folder, "grains", work.world, output.formats, further);
    if (record::writes(output, "vtp")) {
        io::write_contacts_vtp(work.folder / "contacts.vtp", work.world);
        io::write_cell_vtp(work.folder / "cell.vtp", work.world.cell);
    }
}

void write_files(const StageWork& work, const casefile::OutputSpec& output) {
    const dem::World& world = work.world;
    io::save_world(work.folder / "state.h5", world, {{"stage", work.place()}}, work.made_by());
    work.history.write_csv(work.folder / "history.csv");
    if (work.write_tables) {
        io::write_grains_csv(work.folder / "grains.csv", world, work.mobile_gradient);
        io::write_contacts_csv(work.folder / "contacts.csv", world);
    }
    if (output.snapshots.when != casefile::Snapshots::When::Never) {
        write_pictures(work, output);
    }
    record::save_findings(work.folder, work.findings);
}

/// When each file of a stage's folder was written last.
std::map<std::string, std::filesystem::file_time_type> files_of(const std::filesystem::path& folder) {
    std::map<std::string, std::filesystem::file_time_type> times;
    for (const std::filesystem::directory_entry& file : std::filesystem::directory_iterator(folder)) {
        if (record::is_left_by_stage(file)) {
            times.emplace(file.path().filename(), file.last_write_time());
        }
    }
    return times;
}

/// Names of files with results that lay in the folder before the stage and were not written by it: by no key is it
/// known that they are its own.
std::vector<std::string> strange_files(const StageWork& work) {
    std::vector<std::string> names;
    for (const auto& [name, time] : files_of(work.folder)) {
        const std::filesystem::path file = work.folder / name;
        const auto before = work.there_before.find(name);
        const bool is_untouched = before != work.there_before.end() && before->second == time;
        const bool is_picture = file.extension() == ".vtp" || file.extension() == ".xyz";
        if (is_untouched && !is_picture && io::origin_of(file, "key") != work.key) {
            names.push_back(name);
        }
    }
    return names;
}

} // namespace

Progress SampleRun::place() const {
    Progress where;
    where.study = sample_.variant->folder;
    where.sample = sample_.number;
    where.stage_number = sample_.first_stage;
    if (stage_ != nullptr) {
        where.stage = stage_->name;
        where.verb = casefile::verb_of(stage_->spec);
        where.stage_number += static_cast<int>(stage_ - sample_.variant->stages.data());
    }
    return where;
}

void SampleRun::run() {
    for (int row = 0; row < sample_.stages; ++row) {
        stage_ = &sample_.variant->stages[static_cast<std::size_t>(row)];
        const std::filesystem::path folder = record::stage_folder(options_.folder, *sample_.variant, *stage_);
        if (!std::filesystem::exists(folder / "stage.json")) {
            run_stage(*stage_);
        } else {
            record::check_start(
                *sample_.variant, *stage_, options_.folder
            );                                   // the one before may have been computed anew
            drop(folder / record::failure_file); // of what came after the stage
            drop(folder / record::partial_file); // a kill came before its removal
            overview_.count_stage();
        }
    }
    write_picture_series(options_.folder, *sample_.variant);
}

void SampleRun::run_stage(const casefile::Stage& next_stage) {
    const std::filesystem::path folder = record::stage_folder(options_.folder, *sample_.variant, next_stage);
    record::check_is_in_place(options_.folder);
    io::make_folders(folder);
    std::filesystem::remove(folder / record::failure_file);
    const casefile::Stage stage = with_preparation_found(what_, options_, sample_, next_stage);
    dem::World start = start_of(stage);
    const std::string state = stage.parent >= 0 ? record::describe_state(start) : "";
    const record::Sums imported = record::sums_of_imported(next_stage);
    const std::string stage_key = record::key_of_stage(what_, *sample_.variant, next_stage, state, imported);
    std::string key; // of the cache
    const erosion::OwnRule* const own_rule = own_rule_of(stage);
    if (!options_.cache.empty() && record::StageCache::keeps(stage) && own_rule == nullptr) {
        key = record::StageCache::key_of(what_, *sample_.variant, stage, state);
        if (take_from_cache(stage, folder, key, stage_key)) {
            return;
        }
    }
    StageWork work = begin_work(stage, folder, std::move(start), state, stage_key);
    work.own_rule = own_rule;
    if (!imported.empty()) {
        work.numbers[record::imported_files_key] = imported;
    }
    if (casefile::is_prepared_as_another(*sample_.variant, next_stage)) {
        work.numbers["prepared_as"] =
            casefile::sample_to_prepare_by(*sample_.study, *sample_.variant, next_stage)->folder;
    }
    control_.begin(place());
    try {
        do_stage_or_go_on(work);
    } catch (const Interrupted&) {
        log("stage interrupted", stage);
        throw;
    } catch (const Error& error) {
        log("stage fails", stage, {{"what", error.what()}});
        throw;
    }
    finish(work);
    if (!work.has_two_makers) {
        keep_in_cache(stage, folder, key);
    }
}

const erosion::OwnRule* SampleRun::own_rule_of(const casefile::Stage& stage) const {
    const auto rule = options_.rules.find(sample_.study->name + "/" + stage.name);
    return rule == options_.rules.end() ? nullptr : &rule->second;
}

bool SampleRun::take_from_cache(
    const casefile::Stage& stage, const std::filesystem::path& folder, const std::string& key,
    const std::string& stage_key
) {
    const record::CacheAnswer answer = cache_.take(key, *sample_.variant, stage, folder, stage_key);
    if (!answer.damage.empty()) {
        log("damaged cache entry dropped", stage, {{"what", answer.damage}});
        overview_.remark(fmt::format(
            "{}: its entry in the cache is damaged and was dropped; the stage is computed anew ({})",
            record::stage_name(*sample_.variant, stage), answer.damage
        ));
    }
    if (!answer.is_taken) {
        return false;
    }
    drop(folder / record::partial_file);
    overview_.count_stage();
    log("stage taken from the cache", stage);
    Progress taken = place();
    taken.state = record::read_json(folder / "stage.json");
    taken.stage_finished = taken.from_cache = true;
    overview_.show(std::move(taken));
    return true;
}

/// A cache that cannot be written costs time later, and no result now.
void SampleRun::keep_in_cache(
    const casefile::Stage& stage, const std::filesystem::path& folder, const std::string& key
) {
    if (key.empty()) {
        return;
    }
    try {
        cache_.keep(key, folder);
    } catch (const IoError& error) {
        log("stage not kept in the cache", stage, {{"what", error.what()}});
        overview_.remark_not_cached(error.what());
    }
}

StageWork SampleRun::begin_work(
    const casefile::Stage& stage, const std::filesystem::path& folder, dem::World start, std::string start_state,
    std::string key
) {
    StrainPictures pictures(what_.output, folder, start);
    StageWork work{
        .what = what_,
        .variant = *sample_.variant,
        .stage = stage,
        .folder = folder,
        .write_tables = record::leaves_tables(what_, *sample_.variant, stage),
        .control = control_,
        .world = std::move(start),
        .history = History(stage.record_every.value_or(what_.output.histories_every)),
        .pictures = std::move(pictures),
        .start_state = std::move(start_state),
        .key = std::move(key),
        .there_before = files_of(folder)};
    if (std::filesystem::exists(folder / record::partial_file)) {
        take_up(work);
    }
    return work;
}

dem::World SampleRun::start_of(const casefile::Stage& stage) const {
    dem::World world;
    if (stage.parent >= 0) {
        const casefile::Stage& parent = sample_.variant->stages[static_cast<std::size_t>(stage.parent)];
        world = end_of(record::stage_folder(options_.folder, *sample_.variant, parent));
    }
    world.material = sample_.variant->material;
    world.seed = sample_.variant->seed;
    world.reference_h = world.cell.h;
    return world;
}

/// Everything a stage leaves behind.
void SampleRun::finish(StageWork& work) {
    json numbers = describe_stage(work);
    write_files(work, what_.output);
    const std::vector<std::string> strange = strange_files(work);
    if (!strange.empty()) {
        work.warnings.push_back(fmt::format(
            "{}: {} lay in its folder before and {} not of this stage: left out of its checksums", work.place(),
            fmt::join(strange, ", "), strange.size() == 1 ? "is" : "are"
        ));
        numbers["warnings"] = work.warnings;
    }
    record::seal_stage(work.folder, numbers, {}, strange);
    drop(work.folder / record::partial_file);
    overview_.count_stage();
    log("stage done", work.stage, {{"wall_seconds", numbers["wall_seconds"]}});
    control_.finish(numbers);
}

/// A line that the log cannot take costs no result.
void SampleRun::log(const std::string& event, const casefile::Stage& stage, json more) const {
    more["event"] = event;
    more["stage"] = record::stage_name(*sample_.variant, stage);
    try {
        overview_.log(std::move(more));
    } catch (const IoError&) {
    }
}

} // namespace suffuse::run
