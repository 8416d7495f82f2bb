#include "suffuse/job/water_figures.hpp"

#include "suffuse/figures/figures_filter.hpp"
#include "suffuse/figures/figures_flux.hpp"
#include "suffuse/figures/figures_migration.hpp"
#include "suffuse/figures/figures_mobility.hpp"
#include "suffuse/study/passes.hpp"

namespace suffuse::job {
namespace {

constexpr std::size_t most_states = 6; ///< as many as there are colors

void add(const std::string& name, const flow::ThroatFlux& flux, std::vector<figures::FluxState>& states) {
    if (!flux.carried.empty() && states.size() < most_states) {
        states.push_back({name, flux});
    }
}

} // namespace

std::vector<figures::Figure>
draw_fluxes(const std::vector<record::FinishedStage>& stages, const study::ErosionStory& story) {
    std::vector<figures::FluxState> states;
    if (const auto& passes = story.erosion.passes; !passes.empty()) {
        add("before erosion", passes.front().throat_flux_before, states);
        add("after " + study::pass_name(passes.front().pass), passes.front().throat_flux_after, states);
        if (passes.size() > 1) {
            add("after " + study::pass_name(passes.back().pass), passes.back().throat_flux_after, states);
        }
    }
    for (const record::FinishedStage& stage : stages) {
        if (stage.findings.throat_flux) {
            add(stage.name(), *stage.findings.throat_flux, states);
        }
    }
    std::vector<figures::Figure> figures;
    for (auto draw : {figures::flux_by_size, figures::flux_shares}) {
        if (std::optional<figures::Figure> figure = draw(states)) {
            figures.push_back(std::move(*figure));
        }
    }
    return figures;
}

std::vector<figures::Figure> draw_migration(const std::vector<record::FinishedStage>& stages) {
    std::vector<figures::MigrationCurve> curves;
    for (const record::FinishedStage& stage : stages) {
        if (stage.findings.migration && curves.size() < most_states) {
            curves.push_back({stage.name(), *stage.findings.migration});
        }
    }
    std::vector<figures::Figure> figures;
    for (auto draw :
         {figures::migration_by_gradient, figures::migration_in_time, figures::migration_by_power,
          figures::migration_profiles, figures::filter_profile, figures::filter_cut, figures::filter_sizes}) {
        if (std::optional<figures::Figure> figure = draw(curves)) {
            figures.push_back(std::move(*figure));
        }
    }
    return figures;
}

std::vector<figures::Figure> draw_mobility(const std::vector<study::MobilityStory>& stories) {
    std::vector<figures::Figure> figures;
    for (std::optional<figures::Figure> figure :
         {figures::mobility_curves(stories), figures::mobile_sizes(study::main_mobility(stories))}) {
        if (figure) {
            figures.push_back(std::move(*figure));
        }
    }
    return figures;
}

} // namespace suffuse::job
