// check: a case before it is run, and all that is wrong with it.

#include "suffuse/base/amounts.hpp"
#include "suffuse/base/render_within.hpp"
#include "suffuse/casefile/calibration_case.hpp"
#include "suffuse/casefile/load_case.hpp"
#include "suffuse/casefile/weight_words.hpp"
#include "suffuse/record/read_import.hpp"

#include <fmt/format.h>

#include "apps/conduct_calibration.hpp"
#include "apps/exit_code.hpp"
#include "apps/json_text.hpp"
#include "apps/shared_options.hpp"
#include "apps/verb.hpp"
#include "apps/verbs.hpp"
#include <cstdint>
#include <memory>

namespace suffuse::apps {
namespace {

struct CheckVerb final : Verb {
    CheckVerb() : Verb("check", "check a case and list all errors in it", "suffuse check my-dyke/case.toml") {}

    std::string given; ///< a case, or the folder that holds one
    CaseChanges changes;

    void add_to(Options& options) override {
        options.argument("CASE", given, case_text).required();
        changes.add_to(options);
    }

    [[nodiscard]] int act(const CommandLine&, const Console& console) const override;
};

int CheckVerb::act(const CommandLine&, const Console& console) const {
    const std::string file = case_in(given);
    if (casefile::calibrates(file)) {
        return check_calibration({.case_file = file, .overrides = changes.overrides}, console);
    }
    const casefile::LoadedCase loaded = casefile::load_case(file, changes);
    std::int64_t variants = 0, stages = 0;
    for (const casefile::Study& study : loaded.value.studies) {
        variants += std::ssize(study.variants);
        for (const casefile::Variant& variant : study.variants) {
            stages += std::ssize(variant.stages);
        }
    }
    nlohmann::json problems = nlohmann::json::array();
    for (const Diagnostic& warning : loaded.warnings) {
        problems.push_back(problem_json(warning));
    }
    if (!loaded.warnings.empty() && !console.wants_json()) {
        console.talk(render_within(loaded.warnings, console.has_color(), source_width()));
    }
    for (const std::string& import_warning :
         record::check_imports(loaded.value).warnings) { // packings are data of the case, too
        console.talk("warning: " + import_warning);
    }
    console.result(fmt::format(
        "{}: no errors{}; preset {}, {}, {} in all", file,
        loaded.warnings.empty() ? "" : fmt::format(", {}", plural(std::ssize(loaded.warnings), "warning")),
        loaded.value.preset, plural(variants, "sample"), plural(stages, "stage")
    ));
    const std::string weight = casefile::weight_sentence(loaded.value);
    if (!weight.empty()) {
        console.talk(weight);
    }
    console.document(json_text(
        {{"case", file},
         {"preset", loaded.value.preset},
         {"errors", 0},
         {"warnings", loaded.warnings.size()},
         {"samples", variants},
         {"stages", stages},
         {"problems", problems}}
    ));
    return Done;
}

} // namespace

MadeVerb make_check_verb() {
    return std::make_unique<CheckVerb>();
}

} // namespace suffuse::apps
