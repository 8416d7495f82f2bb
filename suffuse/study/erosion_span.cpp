#include "suffuse/study/erosion_span.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace suffuse::study {

std::string ErosionSpan::gradients() const {
    return least_gradient ? range_in_words(*least_gradient, *most_gradient) : "";
}

std::string range_in_words(double least, double most) {
    return least == most ? fmt::format("{:g}", least) : fmt::format("{:g} to {:g}", least, most);
}

std::optional<ErosionSpan>
span_of(const std::vector<const erosion::ErosionResult*>& parts, flow::Conductance conductance) {
    std::optional<ErosionSpan> span;
    for (const erosion::ErosionResult* part : parts) {
        for (const erosion::PassResult& pass : part->passes) {
            ErosionSpan one;
            one.has_forced = is_forced(*part, pass);
            if (!one.has_forced) {
                one.least_gradient = one.most_gradient = pass.probe.gradient;
            }
            if (!span) {
                one.before_is_too_high = is_too_high(pass.probe.flow, pass.porosity_before, conductance);
            }
            const int passes = span ? span->most_passes + 1 : 1;
            span = span ? joined(*span, one) : one;
            span->fewest_passes = span->most_passes = passes;
            span->after_is_too_high = is_too_high(pass.flow_after, pass.porosity_after, conductance); // of the last
        }
    }
    return span;
}

std::optional<ErosionSpan> span_of(const Erosions& chain, flow::Conductance conductance) {
    std::vector<const erosion::ErosionResult*> parts;
    for (const record::FinishedStage* stage : chain) {
        parts.push_back(&*stage->findings.erosion);
    }
    return span_of(parts, conductance);
}

bool is_forced(const erosion::ErosionResult& erosion, const erosion::PassResult& pass) {
    return std::ranges::any_of(erosion.ledger, [&](const erosion::LedgerRow& row) {
        return row.pass == pass.pass && row.reason == erosion::Reason::Forced;
    });
}

ErosionSpan joined(ErosionSpan a, const ErosionSpan& b) {
    a.fewest_passes = std::min(a.fewest_passes, b.fewest_passes);
    a.most_passes = std::max(a.most_passes, b.most_passes);
    if (b.least_gradient) {
        a.least_gradient = std::min(a.least_gradient.value_or(*b.least_gradient), *b.least_gradient);
        a.most_gradient = std::max(a.most_gradient.value_or(*b.most_gradient), *b.most_gradient);
    }
    a.has_forced = a.has_forced || b.has_forced;
    a.before_is_too_high = a.before_is_too_high || b.before_is_too_high;
    a.after_is_too_high = a.after_is_too_high || b.after_is_too_high;
    return a;
}

bool is_too_high(const flow::FlowSource& source, double porosity, flow::Conductance conductance) {
    constexpr double open_packing = 0.55; // validation/permeability.md: Yade's law is too permeable below
    const bool is_open = conductance == flow::Conductance::Yade && 1 - porosity < open_packing;
    const bool is_raised = source.raised_by_fines.value_or(0) > flow::most_raised && !source.is_limited;
    return source.solver == flow::Solver::Network && (is_raised || is_open);
}

} // namespace suffuse::study
