// check, explain, schema: a case before it is run.

#include "suffuse/base/amounts.hpp"
#include "suffuse/casefile/schema.hpp"
#include "suffuse/job/explain_word.hpp"
#include "suffuse/record/read_import.hpp"

#include <fmt/format.h>

#include "apps/exit_code.hpp"
#include "apps/verbs.hpp"
#include "apps/wording.hpp"

namespace suffuse::apps {
namespace {

nlohmann::json key_json(const casefile::Key& key) {
    return {
        {"place", casefile::key_place(key)},
        {"table", key.table},
        {"name", key.name},
        {"value", casefile::value_text(key)},
        {"default", key.default_text},
        {"required", key.is_required},
        {"text", key.text}};
}

} // namespace

int check_verb(const CommandLine& line, const Console& console) {
    const casefile::LoadedCase loaded = casefile::load_case(line.subject, {line.preset, line.overrides, line.studies});
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
        console.talk(render(loaded.warnings, console.has_color()));
    }
    for (const std::string& said : record::check_imports(loaded.value).warnings) { // packings are data of the case, too
        console.talk("warning: " + said);
    }
    console.result(fmt::format(
        "{}: no errors{}; preset {}, {}, {} in all", line.subject,
        loaded.warnings.empty() ? "" : fmt::format(", {}", plural(std::ssize(loaded.warnings), "warning")),
        loaded.value.preset, plural(variants, "sample"), plural(stages, "stage")
    ));
    console.document(json_text(
        {{"case", line.subject},
         {"preset", loaded.value.preset},
         {"errors", 0},
         {"warnings", loaded.warnings.size()},
         {"samples", variants},
         {"stages", stages},
         {"problems", problems}}
    ));
    return Done;
}

int explain_verb(const CommandLine& line, const Console& console) {
    const std::string text = job::explain_word(line.subject);
    console.result(text);
    console.document(json_text({{"topic", line.subject}, {"text", text}}));
    return Done;
}

int schema_verb(const CommandLine&, const Console& console) {
    nlohmann::json keys = nlohmann::json::array();
    for (const casefile::Key& key : casefile::schema()) {
        keys.push_back(key_json(key));
    }
    console.result(casefile::schema_markdown());
    console.document(json_text({{"keys", keys}}));
    return Done;
}

} // namespace suffuse::apps
