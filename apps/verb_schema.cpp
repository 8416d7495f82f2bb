// schema: every key that a case may have.

#include "suffuse/casefile/schema.hpp"

#include "apps/exit_code.hpp"
#include "apps/json_text.hpp"
#include "apps/verb.hpp"
#include "apps/verbs.hpp"
#include <memory>

namespace suffuse::apps {
namespace {

struct SchemaVerb final : Verb {
    SchemaVerb()
        : Verb("schema", "every key that a case may have, as Markdown", "suffuse schema > case-reference.md") {}

    [[nodiscard]] int act(const CommandLine&, const Console& console) const override;
};

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

int SchemaVerb::act(const CommandLine&, const Console& console) const {
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
