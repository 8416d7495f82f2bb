#include "suffuse/study/findings_reason.hpp"

#include "suffuse/base/words.hpp"
#include "suffuse/erosion/detachment.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace suffuse::study {
namespace {

using erosion::PassResult;

constexpr int active_from = 2; // contacts

std::string describe_pull(const PassResult& pass) {
    return pass.probe.fluid_over_contact > 0
               ? fmt::format(
                     " The seepage force on a fine grain is {} of the mean contact force, so loaded fines stay.",
                     short_number(pass.probe.fluid_over_contact, 2)
                 )
               : "";
}

} // namespace

std::int64_t left_with_at_least(const PassResult& pass, int contacts) {
    std::int64_t left = 0;
    for (const auto& [coordination, count] : pass.coordination_histogram) {
        left += coordination >= contacts ? count : 0;
    }
    return left;
}

std::string describe_noise(const PassResult* pass) {
    if (pass == nullptr || pass->removed == 0 || !erosion::takes_unaccepted(pass->probe)) {
        return "";
    }
    const auto [refused, accepted] = pass->probe.agreement[1];
    if (pass->detachable != refused + accepted) {
        return ""; // another rule took its grains
    }
    return fmt::format(
        "Of {} grains that pass {} found detachable, {} moved beyond their twin without water. The fines moved {} "
        "times as fast as the twin's in the median, at an unbalance of {}: {}.",
        grouped(refused + accepted), pass->pass, grouped(accepted), short_number(pass->probe.signal_over_twin),
        short_number(pass->probe.unbalanced_force, 2),
        erosion::has_clear_signal(pass->probe) ? "their contacts deform elastically, and they stay in place"
                                               : "the residual unbalanced forces move them, not the water"
    );
}

std::string describe_few_active(const erosion::ErosionResult& erosion, const PassResult* second) {
    if (second == nullptr) {
        return erosion.passes.empty() ? "Nothing was eroded." : "The erosion ended before a second pass.";
    }
    const std::int64_t active = left_with_at_least(*second, active_from);
    if (active == 0) {
        return fmt::format(
            "{}: pass 1 took what carries nothing, and {} left over.{}",
            second->removed == 0 ? "No grain left in pass 2" : "No grain that left in pass 2 carried load",
            second->removed == 0 ? "nothing was" : "only what it set free was", describe_pull(*second)
        );
    }
    const auto carrying =
        std::ranges::count_if(second->probe.coordination, [](int contacts) { return contacts >= active_from; });
    const std::string noise = describe_noise(second);
    return fmt::format(
        "Pass 2 took {}{} that carried load.{}{}", grouped(active),
        carrying > 0 ? fmt::format(" of {} fines", grouped(carrying)) : " fines",
        noise.empty() ? describe_pull(*second) : " ", noise
    );
}

std::string describe_active_in_first(const PassResult* first) {
    if (first == nullptr) {
        return "";
    }
    const std::int64_t active = left_with_at_least(*first, active_from);
    const std::string noise = describe_noise(first);
    return active == 0
               ? ""
               : fmt::format(
                     "Pass 1 took {} grains that carried load.{}{}", grouped(active), noise.empty() ? "" : " ", noise
                 );
}

} // namespace suffuse::study
