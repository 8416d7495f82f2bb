#include "apps/failures.hpp"

#include "suffuse/base/amounts.hpp"
#include "suffuse/base/shell_word.hpp"

#include <fmt/format.h>

#include "apps/exit_code.hpp"
#include "apps/wording.hpp"
#include <algorithm>

namespace suffuse::apps {

int code_of(const std::vector<record::FailedSample>& failures) {
    const std::string& kind = failures.front().kind;
    const bool is_one_kind =
        std::all_of(failures.begin(), failures.end(), [&](const auto& failure) { return failure.kind == kind; });
    return !is_one_kind ? Failed : kind == "case" ? BadCase : kind == "io" || kind == "memory" ? InputOutput : Failed;
}

void print_failures(
    const std::vector<record::FailedSample>& failures, std::int64_t samples, const std::filesystem::path& folder,
    const Console& console
) {
    for (const record::FailedSample& failure : failures) {
        console.error(fmt::format("{}, stage {}: {}", failure.sample, failure.stage, failure.message));
    }
    console.talk(fmt::format(
        "{} of {} failed; the others are in the report. After removing the cause: suffuse resume {}", failures.size(),
        plural(samples, "sample"), shell_word(folder.string())
    ));
}

} // namespace suffuse::apps
