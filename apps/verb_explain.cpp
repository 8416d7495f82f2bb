// explain: one screen on anything that has a name.

#include "suffuse/job/explain_word.hpp"

#include "apps/exit_code.hpp"
#include "apps/json_text.hpp"
#include "apps/verb.hpp"
#include "apps/verbs.hpp"
#include <memory>

namespace suffuse::apps {
namespace {

struct ExplainVerb final : Verb {
    ExplainVerb()
        : Verb(
              "explain",
              "explain a key, a table, a verb of a stage, a code, a figure, a finding, a criterion, or the conventions",
              "suffuse explain fines_content"
          ) {}

    std::string word;

    void add_to(Options& options) override {
        options.argument("WORD", word, "as in contact.modulus, erode, E310, figure-9, kezdi-1979, conventions")
            .required()
            .suggest(job::explained_words);
    }

    [[nodiscard]] int act(const CommandLine&, const Console& console) const override;
};

int ExplainVerb::act(const CommandLine&, const Console& console) const {
    const std::string text = job::explain_word(word);
    console.result(text);
    console.document(json_text({{"topic", word}, {"text", text}}));
    return Done;
}

} // namespace

MadeVerb make_explain_verb() {
    return std::make_unique<ExplainVerb>();
}

} // namespace suffuse::apps
