#include "suffuse/figures/figures_strength.hpp"

#include "suffuse/base/words.hpp"
#include "suffuse/study/trace_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace suffuse::figures {
namespace {

using nlohmann::json;
using study::StrengthChange;

/// A row for each point of each test.
struct TestRows {
    std::vector<std::string> state, sample;
    std::vector<double> strain, stress;

    void add(const record::FinishedStage& stage, const char* name, bool holds_deviator) {
        for (const triaxial::PathRow& row : stage.findings.curve) {
            state.emplace_back(name);
            sample.push_back(fmt::format("sample {}", stage.variant->replicate));
            strain.push_back(100 * row.axial_strain);
            stress.push_back(1e-3 * (holds_deviator ? row.excess_pore_pressure : row.deviator_stress));
        }
    }
};

/// Whether the stage is this test of one of the samples that the change compares.
bool is_test(const record::FinishedStage& stage, const StrengthChange& change, const casefile::Stage& test) {
    return stage.study == change.study && stage.stage->name == test.name &&
           study::sweep_values(*stage.study, *stage.variant) == study::sweep_values(*change.study, *change.variant);
}

} // namespace

std::optional<Figure> strength_before_and_after(
    const std::vector<StrengthChange>& changes, const std::vector<record::FinishedStage>& stages
) {
    const auto reported =
        std::ranges::find_if(changes, [](const StrengthChange& change) { return change.borne().change.seeds > 0; });
    if (reported == changes.end()) {
        return std::nullopt;
    }
    TestRows rows;
    for (const record::FinishedStage& stage : stages) {
        if (is_test(stage, *reported, *reported->before)) {
            rows.add(stage, "before", reported->holds_deviator());
        } else if (is_test(stage, *reported, *reported->after)) {
            rows.add(stage, "after", reported->holds_deviator());
        }
    }
    if (rows.strain.empty()) {
        return std::nullopt;
    }
    const study::BeforeAfter& borne = reported->borne();
    Figure figure;
    figure.id = "own-strength";
    figure.section = "Tests";
    figure.title = reported->holds_deviator() ? "Pore pressure that is borne, before and after the loss"
                                              : "The same test before and after the loss";
    const double before = std::round(borne.before.mean / 1e3), after = std::round(borne.after.mean / 1e3);
    const std::string values = study::values_name(*reported->study, *reported->variant);
    figure.claim = fmt::format(
        "{} {} from {} to {} kPa{}", reported->holds_deviator() ? "The pore pressure that is borne" : "Peak strength",
        after < before   ? "falls"
        : after > before ? "rises"
                         : "stays",
        short_number(before, 4), short_number(after, 4), values.empty() ? "" : ", " + values
    );
    figure.caption = fmt::format(
        "{} {} kPa before, {} kPa after{}.",
        reported->holds_deviator() ? "Maximum borne:" : "Peak:", short_number(before, 4), short_number(after, 4),
        borne.change.seeds > 1 ? fmt::format(", means of {} samples, a line each", borne.change.seeds) : "; one sample"
    );
    figure.table.add("state", std::move(rows.state));
    figure.table.add("sample", std::move(rows.sample));
    figure.table.add("axial_strain", "%", std::move(rows.strain));
    figure.table.add("stress", "kPa", std::move(rows.stress));
    figure.chart = json::parse(R"json({
        "width": 420, "height": 240,
        "mark": {"type": "line", "clip": true},
        "encoding": {
            "x": {"field": "axial_strain", "type": "quantitative"},
            "y": {"field": "stress", "type": "quantitative", "title": "deviator stress q [kPa]"},
            "color": {"field": "state", "type": "nominal", "title": null},
            "strokeDash": {"field": "state", "type": "nominal", "title": null},
            "detail": {"field": "sample"},
            "tooltip": [{"field": "state"}, {"field": "sample"},
                        {"field": "axial_strain"},
                        {"field": "stress", "title": "q [kPa]", "format": ".4g"}]
        }
    })json");
    json& encoding = figure.chart["encoding"];
    const json order = {"before", "after"};
    encoding["color"]["scale"] = {{"domain", order}, {"range", {color::quiet, color::staying}}};
    encoding["strokeDash"]["scale"] = {{"domain", order}, {"range", {{1, 0}, {6, 3}}}};
    if (reported->holds_deviator()) {
        encoding["y"]["title"] = "excess pore pressure u [kPa]";
    }
    return figure;
}

} // namespace suffuse::figures
