// open: the report of a run in the browser.

#include "suffuse/base/error.hpp"
#include "suffuse/base/spelling.hpp"

#include <fmt/format.h>

#include "apps/browser.hpp"
#include "apps/exit_code.hpp"
#include "apps/json_text.hpp"
#include "apps/shared_options.hpp"
#include "apps/verb.hpp"
#include "apps/verbs.hpp"
#include <filesystem>
#include <memory>

namespace suffuse::apps {
namespace {

namespace fs = std::filesystem;

struct OpenVerb final : Verb {
    OpenVerb() : Verb("open", "show the report of a run in the browser", "suffuse open runs/dyke-0001") {}

    std::string run;

    void add_to(Options& options) override {
        options.argument("RUN", run, "the folder of a run, or a page").required();
    }

    [[nodiscard]] int act(const CommandLine&, const Console& console) const override;
};

int OpenVerb::act(const CommandLine&, const Console& console) const {
    const fs::path given = run, page = fs::is_directory(given) ? given / "report.html" : given;
    if (!fs::exists(page)) {
        throw IoError(fmt::format(
            "{} has no report.html: suffuse report {} writes it once a stage is finished", shown(run), shown(run)
        ));
    }
    const std::string path = fs::absolute(page).lexically_normal().string();
    const bool is_shown = open_in_browser(path);
    console.result(path);
    if (!is_shown) {
        console.talk("no browser could be opened (xdg-open): open this file in one");
    }
    console.document(json_text({{"page", path}, {"shown", is_shown}}));
    return Done;
}

} // namespace

MadeVerb make_open_verb() {
    return std::make_unique<OpenVerb>();
}

} // namespace suffuse::apps
