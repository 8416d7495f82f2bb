#include "apps/shortages.hpp"

#include "suffuse/base/amounts.hpp"

#include <fmt/format.h>

namespace suffuse::apps {

std::vector<std::string> shortages(const plan::RunPlan& plan, const std::filesystem::path& folder) {
    std::vector<std::string> found;
    std::error_code error;
    const auto space = std::filesystem::space(folder, error);
    if (!error && plan.disk > static_cast<double>(space.available)) {
        found.push_back(fmt::format(
            "the run will write about {}, and the disk has {} free: drop \"csv\" from [output] formats, or run "
            "elsewhere",
            size_text(plan.disk), size_text(static_cast<double>(space.available))
        ));
    }
    return found;
}

} // namespace suffuse::apps
