#include "suffuse/answer/erosion_table.hpp"

#include "suffuse/base/words.hpp"
#include "suffuse/facts/ending_words.hpp"
#include "suffuse/facts/shown.hpp"
#include "suffuse/study/erosion_span.hpp"
#include "suffuse/study/trace_curves.hpp"

#include <fmt/format.h>

namespace suffuse::answer {
namespace {

std::vector<std::string> row_of(const record::FinishedStage& stage) {
    const erosion::ErosionResult& erosion = *stage.findings.erosion;
    const erosion::PassResult& last = erosion.passes.back();
    const study::ErosionSpan span = *study::span_of({&erosion});
    const std::optional<double> change = erosion::permeability_change(erosion);
    const erosion::PassResult* const worst = erosion::pass_of_largest_loss(erosion);
    double strain = 0;
    for (const erosion::PassResult& pass : erosion.passes) {
        strain += pass.volumetric_strain;
    }
    return {
        study::in_words_of_sample(stage),
        span.is_by_force() ? "forced" : span.gradients(),
        fmt::format("{}", erosion.passes.size()),
        fmt::format("{:.2f}", erosion::eroded_percent(erosion)),
        fmt::format("{:.4f}", last.porosity_after),
        change ? short_number(*change) : "–",
        percent_beyond_noise(worst == nullptr ? 0 : 100 * *erosion::stress_loss(*worst)),
        percent_beyond_noise(100 * strain),
        last.verdict ? facts::words_of(last.verdict) : "passes specified"};
}

} // namespace

std::optional<figures::PageTable> tabulate_erosions(const std::vector<record::FinishedStage>& stages) {
    figures::PageTable table;
    table.section = "Erosion";
    table.title = "All erosions";
    table.note =
        "Over all passes. The loss of mean stress is the largest of a pass, at constant volume, a gain negative; the "
        "strain is under the stresses held before, contraction positive. The figures of this section are of one of "
        "them.";
    table.header = {
        "stage",
        "gradient i",
        "passes",
        "mass that left [%]",
        "porosity after [-]",
        "permeability after / before [-]",
        "loss of mean stress [%]",
        facts::short_title("volumetric_strain"),
        "ended by"};
    table.numeric.assign(table.header.size(), true);
    table.numeric.front() = table.numeric.back() = false;
    for (const record::FinishedStage& stage : stages) {
        if (stage.findings.erosion && !stage.findings.erosion->passes.empty()) {
            table.rows.push_back(row_of(stage));
        }
    }
    return table.rows.size() < 2 ? std::nullopt : std::optional(std::move(table));
}

} // namespace suffuse::answer
