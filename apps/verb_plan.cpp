// plan: what a case would cost.

#include <fmt/format.h>

#include "apps/exit_code.hpp"
#include "apps/verbs.hpp"
#include "apps/wording.hpp"
#include <algorithm>
#include <filesystem>
#include <unistd.h>

namespace suffuse::apps {
namespace {

/// What this machine may lack.
std::vector<std::string> shortages(const run::RunPlan& plan) {
    std::vector<std::string> found;
    const double memory = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
    if (plan.memory > memory) {
        found.push_back(fmt::format(
            "the run needs up to {} of memory and this machine has {}: lower `particles`", size_text(plan.memory),
            size_text(memory)
        ));
    }
    std::error_code error;
    const auto space = std::filesystem::space(".", error);
    if (!error && plan.disk > static_cast<double>(space.available)) {
        found.push_back(fmt::format(
            "the run leaves about {} and the disk here has {} free: drop \"csv\" from [output] formats, or run "
            "elsewhere",
            size_text(plan.disk), size_text(static_cast<double>(space.available))
        ));
    }
    return found;
}

std::string table_of(const run::RunPlan& plan) {
    std::size_t width = 20;
    for (const run::StageEstimate& stage : plan.stages) {
        width = std::max(width, stage.study.size() + stage.stage.size() + 3);
    }
    std::string text = fmt::format(
        "{:{}}{:10}{:>8}  {:>16}  {:>12}  {}\n", "stage", width, "verb", "grains", "steps", "time", "basis"
    );
    for (const run::StageEstimate& stage : plan.stages) {
        text += fmt::format(
            "{:{}}{:10}{:>8}  {:>16}  {:>12}  {}\n", stage.study + "/" + stage.stage, width, stage.verb,
            count_text(stage.grains), steps_text(stage.steps), duration_range_text(stage.seconds), stage.basis
        );
    }
    return text;
}

} // namespace

int plan_verb(const CommandLine& line, const Console& console) {
    const casefile::Case what = load_asked_case(line, console);
    set_threads(line.threads);
    const run::RunPlan plan = run::plan_run(what, run::measure_speed(run::largest_sample(what)));
    const std::vector<std::string> warnings = shortages(plan);
    for (const std::string& warning : warnings) {
        console.talk("warning: " + warning);
    }
    console.result(table_of(plan));
    console.result(fmt::format("{}\n", plan_sentence(plan)));
    console.talk(fmt::format(
        "priced at {:.2g} grain-steps/s, measured now with {} on {} grains", plan.speed.particle_steps_per_second,
        plural(plan.speed.threads, "thread"), count_text(plan.speed.grains)
    ));
    nlohmann::json json = plan;
    json["case"] = line.subject;
    json["preset"] = what.preset;
    json["warnings"] = warnings;
    console.document(json_text(json));
    return Done;
}

} // namespace suffuse::apps
