#include "suffuse/run/water_figures.hpp"

#include "suffuse/report/figures_flux.hpp"
#include "suffuse/report/passes.hpp"

namespace suffuse::run {
namespace {

constexpr std::size_t most_states = 6; ///< as many as there are colors

void add(const std::string& name, const flow::ThroatFlux& flux, std::vector<report::FluxState>& states) {
    if (!flux.carried.empty() && states.size() < most_states) {
        states.push_back({name, flux});
    }
}

} // namespace

std::vector<report::Figure> draw_fluxes(const std::vector<FinishedStage>& stages, const ErosionStory& story) {
    std::vector<report::FluxState> states;
    if (const auto& passes = story.erosion.passes; !passes.empty()) {
        add("before erosion", passes.front().throat_flux_before, states);
        add("after " + report::pass_name(passes.front().pass), passes.front().throat_flux_after, states);
        if (passes.size() > 1) {
            add("after " + report::pass_name(passes.back().pass), passes.back().throat_flux_after, states);
        }
    }
    for (const FinishedStage& stage : stages) {
        if (stage.findings.throat_flux) {
            add(stage.name(), *stage.findings.throat_flux, states);
        }
    }
    std::vector<report::Figure> figures;
    for (auto draw : {report::flux_by_size, report::flux_shares}) {
        if (std::optional<report::Figure> figure = draw(states)) {
            figures.push_back(std::move(*figure));
        }
    }
    return figures;
}

} // namespace suffuse::run
