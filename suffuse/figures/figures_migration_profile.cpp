// Ours: where along the flow fines are lost and gathered, and how permeable the soil is there.
#include "suffuse/base/words.hpp"
#include "suffuse/figures/figures_migration.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace suffuse::figures {
namespace {

using erosion::SampleProfile;
using nlohmann::json;

constexpr std::size_t most_states = 6; ///< as many as there are colors

/// The state before, the last, and some between them.
std::vector<std::size_t> shown_states(std::size_t states) {
    std::vector<std::size_t> shown;
    const std::size_t count = std::min(states, most_states);
    for (std::size_t k = 0; k < count; ++k) {
        shown.push_back(count < 2 ? 0 : k * (states - 1) / (count - 1));
    }
    return shown;
}

std::string name_of_state(const MigrationCurve& curve, std::size_t state) {
    if (state == 0) {
        return "before";
    }
    const std::vector<erosion::MigrationHold>& holds = curve.result.holds;
    const double gradient = holds[state - 1].gradient;
    const auto alike = std::ranges::count(holds, gradient, &erosion::MigrationHold::gradient);
    const auto so_far =
        std::count_if(holds.begin(), holds.begin() + static_cast<std::ptrdiff_t>(state), [&](auto& hold) {
            return hold.gradient == gradient;
        });
    return fmt::format(
        "after i = {}{}", short_number(gradient), alike > 1 ? fmt::format(", time {}", so_far) : std::string()
    );
}

json panel(const char* field, const char* title, const char* format) {
    return {
        {"width", 480},
        {"height", 140},
        {"mark", {{"type", "line"}, {"strokeWidth", 2}, {"point", {{"size", 18}, {"filled", true}}}}},
        {"encoding",
         {{"y", {{"field", field}, {"type", "quantitative"}, {"title", title}, {"scale", {{"zero", false}}}}},
          {"x", {{"field", "middle"}, {"type", "quantitative"}, {"title", "distance along the flow [mm]"}}},
          {"tooltip",
           {{{"field", "state"}, {"title", "state"}},
            {{"field", "middle"}, {"title", "at [mm]"}, {"format", ".3g"}},
            {{"field", field}, {"title", title}, {"format", format}}}}}}};
}

} // namespace

std::optional<Figure> migration_profiles(const std::vector<MigrationCurve>& curves) {
    const auto has_some = [](const MigrationCurve& curve) {
        const SampleProfile& profile = curve.result.sample;
        return profile.porosity.size() > 1 && profile.porosity.size() <= curve.result.holds.size() + 1;
    };
    const auto curve = std::ranges::find_if(curves, has_some);
    if (curve == curves.end()) {
        return std::nullopt;
    }
    const SampleProfile& profile = curve->result.sample;
    std::vector<std::string> state;
    std::vector<double> middle, porosity, fines, permeability;
    json names = json::array();
    for (const std::size_t s : shown_states(profile.porosity.size())) {
        names.push_back(name_of_state(*curve, s));
        for (std::size_t k = 0; k < profile.slices; ++k) {
            state.push_back(names.back());
            middle.push_back(1e3 * profile.step[s] * (static_cast<double>(k) + 0.5));
            porosity.push_back(profile.porosity[s][k]);
            fines.push_back(100 * profile.fines[s][k]);
            permeability.push_back(profile.permeability[s][k]);
        }
    }
    const auto [least, most] = std::ranges::minmax(profile.permeability.back());
    Figure figure;
    figure.id = "own-migration-profile";
    figure.section = "Water";
    figure.title = "Porosity, fines and permeability along the flow";
    figure.caption = fmt::format(
        "{}: at the end the permeability of slices is {} to {} m². The same water goes through all slices of {} mm; a "
        "slice's permeability follows from the head that the flow spends in it. Single slices are thinner than a "
        "coarse grain and scatter: compare a slice with itself before.",
        curve->name, short_number(least, 2), short_number(most, 2), short_number(1e3 * profile.step.front(), 2)
    );
    figure.table.add("state", std::move(state));
    figure.table.add("middle", "mm", std::move(middle));
    figure.table.add("porosity", "-", std::move(porosity));
    figure.table.add("fines", "%", std::move(fines));
    figure.table.add("permeability", "m²", std::move(permeability));
    figure.chart = {
        {"vconcat",
         {panel("porosity", "porosity [-]", ".3f"), panel("fines", "fines, solid volume [%]", ".3g"),
          panel("permeability", "permeability [m²]", ".3g")}},
        {"spacing", 16}};
    for (json& each : figure.chart["vconcat"]) {
        each["encoding"]["color"] = {
            {"field", "state"},
            {"type", "nominal"},
            {"title", nullptr},
            {"scale", {{"domain", names}, {"range", color::sequence()}}}};
    }
    figure.chart["vconcat"][2]["encoding"]["y"]["axis"] = {{"format", ".1e"}};
    return figure;
}

} // namespace suffuse::figures
