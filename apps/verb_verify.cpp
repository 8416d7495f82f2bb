// verify: whether a run is what it was when it ended.

#include "suffuse/base/amounts.hpp"
#include "suffuse/base/shell_word.hpp"
#include "suffuse/base/spelling.hpp"
#include "suffuse/job/calibration_folder.hpp"
#include "suffuse/job/verify_calibration.hpp"
#include "suffuse/record/checksums.hpp"

#include <fmt/format.h>

#include "apps/exit_code.hpp"
#include "apps/json_text.hpp"
#include "apps/shared_options.hpp"
#include "apps/verb.hpp"
#include "apps/verbs.hpp"
#include <memory>

namespace suffuse::apps {
namespace {

struct VerifyVerb final : Verb {
    VerifyVerb()
        : Verb(
              "verify", "check whether a run's files are complete and unchanged since it ended",
              "suffuse verify runs/dyke-0001"
          ) {}

    std::string run;

    void add_to(Options& options) override { options.argument("DIR", run, folder_text).required(); }

    [[nodiscard]] int act(const CommandLine&, const Console& console) const override;
};

/// Of stages of an earlier version, which the checksums of the run alone speak for.
std::string without_checksums(std::size_t without, int stages) {
    return without == 0 ? ""
                        : fmt::format(
                              "; {} of {}, of an earlier version, {} no checksums from {} end", without,
                              plural(stages, "stage"), without == 1 ? "has" : "have", without == 1 ? "its" : "their"
                          );
}

/// Of stages that no key ties to the case of the run.
std::string unverified(std::size_t without, int stages) {
    return without == 0 ? ""
                        : fmt::format(
                              "; unverified: {} of {}, of an earlier version, without a key of this case", without,
                              plural(stages, "stage")
                          );
}

int VerifyVerb::act(const CommandLine&, const Console& console) const {
    look_at_run(run, io::Purpose::Read, console);
    const record::Verification found =
        job::is_calibration(run) ? job::verify_calibration(run) : record::verify_run(run);
    for (const record::Damage& damage : found.damages) {
        console.result(fmt::format("  {} {}", damage.file, damage.what));
    }
    const bool is_complete = found.missing.names.empty();
    console.result(fmt::format(
        "{}: {} compared with their checksums, {} with the records of their stages{}{}",
        !found.damages.empty() ? plural(std::ssize(found.damages), "difference")
        : is_complete          ? "whole and unchanged"
                               : "unchanged, but not complete",
        plural(found.files, "file"), plural(found.states, "state"),
        without_checksums(found.without_checksums.size(), found.stages),
        unverified(found.unverified.size(), found.stages)
    ));
    if (!is_complete) {
        console.result(fmt::format(
            "{}{}; continue with suffuse resume {}",
            found.until.empty() ? "" : fmt::format("the run ended with stage {}, as requested; ", shown(found.until)),
            describe_missing(found.missing), shell_word(run)
        ));
    }
    for (const std::string& name : found.more) {
        console.detail("no checksum: " + name);
    }
    if (!found.more.empty()) {
        console.talk(fmt::format(
            "{} without a checksum, which came later or which an unfinished stage left; -v lists them",
            plural(std::ssize(found.more), "file")
        ));
    }
    console.document(json_text(found));
    return found.damages.empty() && is_complete ? Done : Differs;
}

} // namespace

MadeVerb make_verify_verb() {
    return std::make_unique<VerifyVerb>();
}

} // namespace suffuse::apps
