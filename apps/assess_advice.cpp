#include "apps/assess_advice.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/shell_word.hpp"

#include <fmt/format.h>

#include "apps/own_filter.hpp"
#include "apps/own_soil.hpp"
#include "apps/own_surrogate.hpp"

namespace suffuse::apps {
namespace {

/// Whether a model of the user's curves can be made: what cannot is refused with a CaseError.
template <class MakeModel>
bool is_in_reach(const MakeModel& make_model) {
    try {
        make_model();
        return true;
    } catch (const CaseError&) {
        return false;
    }
}

} // namespace

std::string advise_run(const std::string& words) {
    return fmt::format("to find how many grains are free to move, simulate: suffuse run {}", words);
}

std::string advise_new(
    const grains::Grading& measured, const std::string& words, const std::string& fines,
    const std::optional<double>& finer_than
) {
    const std::string command =
        fmt::format("suffuse new --psd {}{}", words, fines.empty() ? "" : " --fines " + shell_word(fines));
    if (is_in_reach([&] { model_own_soil(measured, "", {{}, {}, finer_than}); })) {
        return "to find how many grains are free to move, simulate: " + command;
    }
    if (is_surrogate_in_reach(measured, finer_than, most_quick_grains)) {
        return fmt::format(
            "this soil is too wide to simulate whole; a surrogate shows which gradient moves its fines: {} --surrogate",
            command
        );
    }
    return "neither this soil nor a surrogate of it can be simulated as it was measured; what to do says: " + command;
}

std::string advise_stack(const grains::Grading& base, const grains::Grading& filter, const std::string& words) {
    return is_in_reach([&] { model_own_stack(base, "base", filter, "filter", ""); })
               ? fmt::format("how far the base gets into this filter, simulated: suffuse new {}", words)
               : "";
}

} // namespace suffuse::apps
