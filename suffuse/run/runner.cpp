#include "suffuse/run/runner.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/io/checkpoint.hpp"
#include "suffuse/io/packing_export.hpp"
#include "suffuse/io/tables.hpp"
#include "suffuse/io/vtk.hpp"
#include "suffuse/run/folder.hpp"
#include "suffuse/run/measure.hpp"
#include "suffuse/run/result_json.hpp"
#include "suffuse/run/stage_work.hpp"
#include "suffuse/run/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace suffuse::run {
namespace {

using nlohmann::json;

// Of the smaller radius. Hard shearing presses single fines far into their neighbors at this stiffness; beyond a fifth
// the linear law is no model of a contact any more.
constexpr double notable_overlap = 0.1, largest_good_overlap = 0.2;

bool writes(const casefile::OutputSpec& output, std::string_view format) {
    return std::find(output.formats.begin(), output.formats.end(), format) != output.formats.end();
}

/// Runs the stages of a run one after the other; what is finished lies in the folder.
class Runner {
public:
    Runner(const casefile::Case& what, const RunOptions& options)
        : what_(what), options_(options), control_(options, what.output.checkpoint) {
        for (const casefile::Study& study : what.studies) {
            for (const casefile::Variant& variant : study.variants) {
                stages_ += static_cast<int>(variant.stages.size());
            }
        }
    }

    RunReport run() {
        open_folder(options_.folder, what_, options_.case_text);
        log_event(options_.folder, {{"event", "run begins"}, {"command", options_.command}});
        RunReport report;
        try {
            run_studies(report);
        } catch (const Interrupted&) {
            report.outcome = control_.out_of_time() ? Outcome::TimeLimit : Outcome::Stopped;
        }
        write_json(options_.folder / "provenance.json", describe_provenance(what_, options_, control_.run_seconds()));
        const Summary summary = summarize_run(what_, options_.folder, options_.page_folder);
        report.report = summary.report;
        report.warnings = summary.warnings;
        report.flaws = summary.flaws;
        report.findings = summary.findings;
        if (report.outcome == Outcome::Done && !report.flaws.empty()) {
            report.outcome = Outcome::DoneWithFlaws;
        }
        log_event(options_.folder, {{"event", "run ends"}, {"wall_seconds", control_.run_seconds()}});
        return report;
    }

private:
    void run_studies(RunReport&) {
        for (const casefile::Study& study : what_.studies) {
            for (const casefile::Variant& variant : study.variants) {
                if (!run_variant(variant)) {
                    return;
                }
            }
        }
    }

    /// @return false when the stage asked for as the last is done.
    bool run_variant(const casefile::Variant& variant) {
        for (const casefile::Stage& stage : variant.stages) {
            ++stage_number_;
            const std::filesystem::path folder = stage_folder(options_.folder, variant, stage);
            if (!std::filesystem::exists(folder / "stage.json")) {
                run_stage(variant, stage, folder);
            }
            if (stage.name == options_.until) {
                return false;
            }
        }
        return true;
    }

    void
    run_stage(const casefile::Variant& variant, const casefile::Stage& stage, const std::filesystem::path& folder) {
        std::filesystem::create_directories(folder);
        const bool imported = starts_from_import(variant, stage);
        const bool last = &stage == &variant.stages.back();
        StageWork work{
            what_,
            variant,
            stage,
            folder,
            imported || last || writes(what_.output, "csv"),
            control_,
            start_of(variant, stage),
            History(stage.record_every.value_or(what_.output.histories_every)),
            json::object(),
            {},
            {},
            {},
            0,
            0,
            0,
            {}};
        if (std::filesystem::exists(folder / "partial.h5")) {
            take_up(work);
        }
        Progress where;
        where.study = variant.folder;
        where.stage = stage.name;
        where.verb = casefile::verb_of(stage.spec);
        where.stage_number = stage_number_;
        where.stages = stages_;
        control_.begin(std::move(where));
        try {
            do_stage(work);
        } catch (const Interrupted&) {
            log_event(options_.folder, {{"event", "stage interrupted"}, {"stage", stage_name(variant, stage)}});
            throw;
        } catch (const Error& error) {
            log_event(
                options_.folder,
                {{"event", "stage fails"}, {"stage", stage_name(variant, stage)}, {"what", error.what()}}
            );
            throw;
        }
        finish(work);
    }

    static void take_up(StageWork& work) {
        io::Checkpoint partial = io::load_world(work.folder / "partial.h5");
        const json saved = json::parse(partial.attributes.at("stage"));
        work.world = std::move(partial.world);
        work.history.restore(saved.at("history"));
        work.grain_steps = saved.at("grain_steps");
        work.earlier_seconds = saved.at("seconds");
        work.resumed = saved.at("state");
    }

    static bool starts_from_import(const casefile::Variant& variant, const casefile::Stage& stage) {
        const casefile::Stage* origin = &stage;
        while (origin->parent >= 0) {
            origin = &variant.stages[static_cast<std::size_t>(origin->parent)];
        }
        return std::holds_alternative<casefile::ImportSpec>(origin->spec);
    }

    dem::World start_of(const casefile::Variant& variant, const casefile::Stage& stage) const {
        dem::World world;
        if (stage.parent >= 0) {
            const casefile::Stage& parent = variant.stages[static_cast<std::size_t>(stage.parent)];
            world = io::load_world(stage_folder(options_.folder, variant, parent) / "state.h5").world;
        }
        world.material = what_.material;
        world.seed = variant.seed;
        world.reference_h = world.cell.h;
        return world;
    }

    static std::string stage_name(const casefile::Variant& variant, const casefile::Stage& stage) {
        return variant.folder + "/" + stage.name;
    }

    /// Everything a stage leaves behind; stage.json last, as the sign that the stage is complete.
    void finish(StageWork& work) {
        const dem::World& world = work.world;
        json numbers = measure_state(world);
        numbers["steps"] = 0;
        numbers.update(work.numbers);
        const double seconds = work.seconds();
        numbers["stage"] = work.stage.name;
        numbers["verb"] = casefile::verb_of(work.stage.spec);
        numbers["time_step"] = work.time_step;
        numbers["wall_seconds"] = seconds;
        numbers["particle_steps_per_second"] = seconds > 0 ? static_cast<double>(work.grain_steps) / seconds : 0.0;
        numbers["inertial_number_max"] = work.history.largest_inertial_number();
        if (const double overlap = numbers["max_overlap_ratio"]; overlap > notable_overlap) {
            (overlap > largest_good_overlap ? work.flaws : work.warnings)
                .push_back(fmt::format(
                    "{}: the largest overlap is {:.1f} % of the smaller radius; a higher contact.modulus or a lower "
                    "pressure makes it "
                    "smaller",
                    stage_name(work.variant, work.stage), 100 * overlap
                ));
        }
        numbers["warnings"] = work.warnings;
        numbers["flaws"] = work.flaws;

        io::save_world(work.folder / "state.h5", world, {{"stage", stage_name(work.variant, work.stage)}});
        work.history.write_csv(work.folder / "history.csv");
        if (work.write_tables) {
            io::write_grains_csv(work.folder / "grains.csv", world);
            io::write_contacts_csv(work.folder / "contacts.csv", world);
        }
        if (writes(what_.output, "vtp")) {
            io::write_grains_vtp(work.folder / "grains.vtp", world);
            io::write_contacts_vtp(work.folder / "contacts.vtp", world);
            io::write_cell_vtp(work.folder / "cell.vtp", world.cell);
        }
        if (writes(what_.output, "xyz")) {
            io::export_extended_xyz(work.folder / "grains.xyz", world.grains, world.cell);
        }
        save_findings(work);
        write_json(work.folder / "stage.json", numbers);
        std::filesystem::remove(work.folder / "partial.h5");
        log_event(
            options_.folder,
            {{"event", "stage done"}, {"stage", stage_name(work.variant, work.stage)}, {"wall_seconds", seconds}}
        );
        control_.finish(numbers);
    }

    static void save_findings(const StageWork& work) {
        json results = json::object();
        if (!work.findings.probes.empty()) {
            results["probes"] = work.findings.probes;
        }
        if (work.findings.erosion) {
            results["erosion"] = *work.findings.erosion;
        }
        if (!work.findings.curve.empty()) {
            results["curve"] = work.findings.curve;
        }
        if (!results.empty()) {
            write_cbor(work.folder / "results.cbor", results);
        }
    }

    const casefile::Case& what_;
    const RunOptions& options_;
    Control control_;
    int stage_number_ = 0, stages_ = 0;
};

} // namespace

RunReport run_case(const casefile::Case& what, const RunOptions& options) {
    return Runner(what, options).run();
}

} // namespace suffuse::run
