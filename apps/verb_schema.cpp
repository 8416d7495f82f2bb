// schema: every key that a case may have, and every result of a stage.

#include "suffuse/casefile/schema.hpp"
#include "suffuse/facts/every_fact.hpp"

#include "apps/exit_code.hpp"
#include "apps/json_text.hpp"
#include "apps/verb.hpp"
#include "apps/verbs.hpp"
#include <memory>

namespace suffuse::apps {
namespace {

struct SchemaVerb final : Verb {
    SchemaVerb()
        : Verb(
              "schema", "every key that a case may have, or every result of a stage, as Markdown",
              "suffuse schema > case-reference.md"
          ) {}

    bool prints_results = false;

    void add_to(Options& options) override {
        options.flag("--results", prints_results, "the numbers that stages write, with their units, in place of keys");
    }

    [[nodiscard]] int act(const CommandLine&, const Console& console) const override;
};

nlohmann::json key_json(const casefile::Key& key) {
    return {
        {"place", casefile::key_place(key)},
        {"table", key.table},
        {"name", key.name},
        {"value", casefile::value_text(key)},
        {"choices", key.choices},
        {"is_list", key.is_list},
        {"is_table", key.kind == casefile::ValueKind::Table},
        {"default", key.default_text},
        {"required", key.is_required},
        {"text", key.text}};
}

nlohmann::json results_json() {
    nlohmann::json results = nlohmann::json::array();
    for (const facts::Group& group : facts::every_group()) {
        for (const facts::Fact& fact : group.facts) {
            results.push_back({{"group", group.title}, {"key", fact.key}, {"unit", fact.unit}, {"text", fact.words}});
        }
    }
    return results;
}

int SchemaVerb::act(const CommandLine&, const Console& console) const {
    if (prints_results) {
        console.result(facts::results_markdown());
        console.document(json_text({{"results", results_json()}}));
        return Done;
    }
    nlohmann::json keys = nlohmann::json::array();
    for (const casefile::Key& key : casefile::schema()) {
        keys.push_back(key_json(key));
    }
    console.result(casefile::schema_markdown());
    console.document(json_text({{"keys", keys}}));
    return Done;
}

} // namespace

MadeVerb make_schema_verb() {
    return std::make_unique<SchemaVerb>();
}

} // namespace suffuse::apps
