#include "suffuse/plan/fit_memory.hpp"

#include "suffuse/base/amounts.hpp"
#include "suffuse/base/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace suffuse::plan {
namespace {

/// A bound printed shorter than it is would read as enough.
std::string two_digits_up(double bytes) {
    const double unit = std::pow(10.0, std::floor(std::log10(bytes)) - 1);
    return size_text(std::ceil(bytes / unit) * unit);
}

[[noreturn]] void refuse(const RunPlan& plan, double bytes) {
    const StageEstimate& greediest = *std::ranges::max_element(plan.stages, {}, &StageEstimate::memory);
    const double process = plan.memory - greediest.memory, room = std::max(0.0, bytes - process);
    const double fit = greediest.memory > 0 ? static_cast<double>(greediest.grains) * room / greediest.memory : 0;
    const auto fitting = static_cast<std::int64_t>(fit);
    throw IoError(fmt::format(
        "stage {}/{} needs up to {} of memory for its {} grains, and the run may use {}; {}run it on a machine that "
        "has more, or let it use more (--memory {}; memory= in Python)",
        greediest.study, greediest.stage, size_text(plan.memory), count_text(greediest.grains), size_text(bytes),
        fitting > 0 ? fmt::format("lower `particles` (about {} fit), ", count_text(fitting)) : "",
        two_digits_up(plan.memory)
    ));
}

} // namespace

int samples_within(const RunPlan& plan, double bytes) {
    RunPlan fewer = plan;
    while (fewer.memory > bytes && !fewer.stages.empty()) {
        if (fewer.speed.at_once == 1) {
            refuse(fewer, bytes);
        }
        --fewer.speed.at_once;
        sum_up(fewer);
    }
    return fewer.speed.at_once;
}

RunPlan plan_within(double bytes, int at_once, const std::function<RunPlan(int)>& make) {
    RunPlan plan = make(at_once);
    const int fitting = samples_within(plan, bytes);
    return fitting < plan.speed.at_once ? make(fitting) : plan;
}

} // namespace suffuse::plan
