// man: the man page.

#include "apps/man_page.hpp"
#include "apps/verb.hpp"
#include "apps/verbs.hpp"
#include <memory>

namespace suffuse::apps {
namespace {

struct ManVerb final : Verb {
    ManVerb() : Verb("man", "the man page, in roff", "suffuse man > suffuse.1 && man ./suffuse.1") {}

    [[nodiscard]] std::string printed(const CLI::App& program) const override {
        return man_page(command_table(program));
    }
};

} // namespace

MadeVerb make_man_verb() {
    return std::make_unique<ManVerb>();
}

} // namespace suffuse::apps
