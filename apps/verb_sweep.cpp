// sweep: the samples of a case as tasks that any machine can run, and one run folder gathered from what they leave.

#include "suffuse/base/error.hpp"

#include "apps/sweep_collect.hpp"
#include "apps/sweep_emit.hpp"
#include "apps/verb.hpp"
#include "apps/verbs.hpp"
#include <memory>
#include <string>

namespace suffuse::apps {
namespace {

struct SweepVerb final : Verb {
    SweepVerb()
        : Verb(
              "sweep", "run the samples of a case as tasks of a cluster, and gather them",
              "suffuse sweep dyke/case.toml --emit slurm -o runs/dyke && sh runs/dyke/submit.sh\n"
              "suffuse sweep --collect runs/dyke"
          ) {}

    std::string subject;   ///< a case, or the folder of a run
    std::string collected; ///< folder of the run whose tasks are done
    EmitOptions emitted;

    void add_to(Options& options) override {
        const Option from =
            options.argument("CASE", subject, "the case file, or the folder of a run whose rest is to be run");
        const Option emit = emitted.add_to(options, from);
        options.value("--collect", collected, "gather what the tasks left in the folder DIR")
            .type("DIR")
            .excludes(emit)
            .excludes(from);
    }

    void check() const override {
        if (emitted.engine.empty() && collected.empty()) {
            throw UsageError("sweep: --emit slurm or another engine with a case, or --collect DIR; suffuse run CASE "
                             "runs all samples on this machine");
        }
        emitted.check();
    }

    [[nodiscard]] int act(const CommandLine& line, const Console& console) const override {
        return collected.empty() ? emit_tasks(subject, emitted, console)
                                 : collect_tasks(collected, line.typed, console);
    }
};

} // namespace

MadeVerb make_sweep_verb() {
    return std::make_unique<SweepVerb>();
}

} // namespace suffuse::apps
