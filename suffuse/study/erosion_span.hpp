#pragma once
// What erosions were by, of one sample or of several: all that a sentence about them may say in one breath.

#include "suffuse/erosion/result.hpp"
#include "suffuse/study/erosion_story.hpp"

#include <optional>
#include <string>
#include <vector>

namespace suffuse::study {

struct ErosionSpan {
    int fewest_passes = 0, most_passes = 0;                     ///< of a sample
    std::optional<double> least_gradient, most_gradient;        ///< of the passes that water made; else nothing [-]
    bool has_forced = false;                                    ///< in a pass at least, fines were taken out by force
    bool before_is_too_high = false, after_is_too_high = false; ///< of a permeability: known of one sample at least

    [[nodiscard]] bool is_by_force() const { return has_forced && !least_gradient; }

    /// "0.05"; "0.1 to 1" where passes differ; empty where all fines were taken out by force.
    [[nodiscard]] std::string gradients() const;
};

/// "0.05"; "0.1 to 1" where the two differ.
std::string range_in_words(double least, double most);

/// Of erosions that follow each other; nothing without a pass.
std::optional<ErosionSpan>
span_of(const std::vector<const erosion::ErosionResult*>& parts, flow::Conductance conductance = {});

std::optional<ErosionSpan> span_of(const Erosions& chain, flow::Conductance conductance);

/// Whether fines were taken out of this pass of it by their contacts, whatever the water does.
bool is_forced(const erosion::ErosionResult& erosion, const erosion::PassResult& pass);

ErosionSpan joined(ErosionSpan a, const ErosionSpan& b);

/// Whether a permeability is known to be too high: fines seem to raise it, or the packing is too open for Yade's law.
bool is_too_high(const flow::FlowSource& source, double porosity, flow::Conductance conductance);

} // namespace suffuse::study
