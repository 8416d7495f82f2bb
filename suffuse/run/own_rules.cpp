#include "suffuse/run/own_rules.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/spelling.hpp"
#include "suffuse/erosion/loop.hpp"
#include "suffuse/record/folder.hpp"
#include "suffuse/record/refine.hpp"
#include "suffuse/record/samples.hpp"
#include "suffuse/record/stored.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>

namespace suffuse::run {
namespace {

using nlohmann::json;
using record::Sample;

const char* const rules_file = "own_rules.json";

/// A rule for a stage that a rule cannot be for.
void check_stage(const casefile::Case& what, const std::string& name, const erosion::OwnRule& rule) {
    std::vector<std::string> known;
    for (const casefile::Study& study : what.studies) {
        for (const casefile::Stage& stage : study.stages) {
            const auto* const spec = std::get_if<erosion::ErodeSpec>(&stage.spec);
            if (spec == nullptr) {
                continue;
            }
            known.push_back(study.name + "/" + stage.name);
            if (known.back() == name) {
                erosion::check_own_rule(*spec, rule);
                return;
            }
        }
    }
    throw UsageError(fmt::format(
        "rules: found \"{}\", which is no stage that does \"erode\"{}; there are {}", name, near_hint(name, known),
        known.empty() ? "none" : fmt::format("{}", fmt::join(known, ", "))
    ));
}

std::string name_in(const json& rule) {
    const bool is_named = rule.is_object() && rule.contains("name") && rule.at("name").is_string();
    return rule.is_null() ? "the rule of the case"
                          : fmt::format("the rule {}", is_named ? rule.at("name").get<std::string>() : "?");
}

/// A stage that has a rule of its own, or had.
class RuledStage {
public:
    RuledStage(const std::filesystem::path& run, const Sample& sample, const casefile::Stage& stage)
        : name_(record::stage_name(*sample.variant, stage)),
          folder_(record::stage_folder(run, *sample.variant, stage)) {}

    /// @param own the rule of earlier calls for the stage, @param given what this one does; null: nothing
    void check(const json& own, const json& given) const {
        const std::filesystem::path numbers = folder_ / "stage.json";
        if (std::filesystem::exists(numbers)) {
            const json read = record::read_json(numbers);
            const json had = record::take_from(numbers, [&] { return read.value("own_rule", json()); });
            if (!given.is_null() && given != had) {
                throw UsageError(fmt::format(
                    "{}: was computed with {}{}, not with {}; give the run another folder", name_, name_in(had),
                    name_in(had) == name_in(given) ? " as its text was then" : "", name_in(given)
                ));
            }
        } else if (given.is_null() && !own.is_null()) {
            throw UsageError(fmt::format(
                "{}: was requested with {} from Python, and only Python can compute it: continue with "
                "suffuse.Run(...).resume(rules=...)",
                name_, name_in(own)
            ));
        }
    }

private:
    std::string name_;
    std::filesystem::path folder_;
};

} // namespace

json own_rule_numbers(const erosion::OwnRule& rule) {
    return {{"name", rule.name}, {"source", rule.source.empty() ? json() : json(rule.source)}};
}

void take_own_rules(const casefile::Case& what, const RunOptions& options) {
    const std::filesystem::path file = options.folder / rules_file;
    json own = json::object();
    if (std::filesystem::exists(file)) {
        own = record::read_json(file);
    }
    if (!own.is_object()) {
        throw record::not_as_stored(file, "not an object");
    }
    json given = json::object();
    for (const auto& [name, rule] : options.rules) {
        check_stage(what, name, rule);
        given[name] = own_rule_numbers(rule);
    }
    if (own.empty() && given.empty()) {
        return;
    }
    const casefile::Case refined = record::with_refinements(what, options.folder);
    for (const Sample& sample : record::list_samples(refined, options.until, options.sample)) {
        for (int row = 0; row < sample.stages; ++row) {
            const casefile::Stage& stage = sample.variant->stages[static_cast<std::size_t>(row)];
            const std::string name = sample.study->name + "/" + stage.name;
            RuledStage(options.folder, sample, stage).check(own.value(name, json()), given.value(name, json()));
        }
    }
    own.update(given);
    record::write_json(file, own);
}

} // namespace suffuse::run
