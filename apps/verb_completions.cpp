// completions: print a script with which a shell completes verbs and flags.

#include "apps/completions.hpp"
#include "apps/verb.hpp"
#include "apps/verbs.hpp"
#include <memory>

namespace suffuse::apps {
namespace {

struct CompletionsVerb final : Verb {
    CompletionsVerb()
        : Verb(
              "completions", "print a script with which a shell completes verbs and flags",
              "suffuse completions bash > ~/.local/share/bash-completion/completions/suffuse"
          ) {}

    std::string shell;

    void add_to(Options& options) override {
        options.argument("SHELL", shell, "bash, zsh or fish").required().suggest({"bash", "zsh", "fish"});
    }

    [[nodiscard]] std::string printed(const CLI::App& program) const override {
        return completions_for(shell, command_table(program));
    }
};

} // namespace

MadeVerb make_completions_verb() {
    return std::make_unique<CompletionsVerb>();
}

} // namespace suffuse::apps
