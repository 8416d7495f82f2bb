// runs: all runs of a folder, each in a line.

#include "suffuse/base/amounts.hpp"
#include "suffuse/base/shell_word.hpp"
#include "suffuse/job/run_list.hpp"

#include <fmt/format.h>

#include "apps/exit_code.hpp"
#include "apps/json_text.hpp"
#include "apps/verb.hpp"
#include "apps/verbs.hpp"
#include <array>
#include <filesystem>
#include <memory>

namespace suffuse::apps {
namespace {

struct RunsVerb final : Verb {
    RunsVerb()
        : Verb("runs", "list the runs of a folder, how far each got and its result", "suffuse runs --sort time") {}

    std::string folder;
    std::string order = "finished";

    void add_to(Options& options) override {
        options.argument("FOLDER", folder, "that holds runs; runs unless given");
        options.value("--sort", order, "finished, name, time, samples or title; finished, the last first, unless given")
            .type("WORD")
            .one_of({"finished", "name", "time", "samples", "title"});
    }

    [[nodiscard]] int act(const CommandLine&, const Console& console) const override;
};

job::RunOrder order_of(const std::string& word) {
    using enum job::RunOrder;
    for (const auto& [name, order] :
         {std::pair{"name", Name}, {"time", Time}, {"samples", Samples}, {"title", Title}}) {
        if (word == name) {
            return order;
        }
    }
    return Finished;
}

int RunsVerb::act(const CommandLine&, const Console& console) const {
    const std::filesystem::path within = folder.empty() ? "runs" : folder;
    const std::vector<job::ListedRun> runs = job::list_runs(within, order_of(order));
    if (runs.empty()) {
        console.talk(fmt::format("{} holds no run", within.string()));
    } else {
        console.result(job::text_of(runs, terminal_width()));
        console.talk(fmt::format("{} in {}", plural(std::ssize(runs), "run"), within.string()));
        if (runs.size() > 1) {
            console.talk(fmt::format(
                "to compare two: suffuse compare {} {}", shell_word((within / runs[0].name).string()),
                shell_word((within / runs[1].name).string())
            ));
        }
    }
    console.document(json_text({{"folder", within.string()}, {"runs", job::json_of(runs)}}));
    return Done;
}

} // namespace

MadeVerb make_runs_verb() {
    return std::make_unique<RunsVerb>();
}

} // namespace suffuse::apps
