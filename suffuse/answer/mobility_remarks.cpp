#include "suffuse/answer/mobility_remarks.hpp"

#include "suffuse/answer/mobility_text.hpp"
#include "suffuse/answer/plain_numbers.hpp"
#include "suffuse/base/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>

namespace suffuse::answer {
namespace {

using study::MobilityStory;

constexpr double as_good_as_equal = 1.3; // of two gradients: nearer than samples of one soil are

/// Where several samples are in the answer, and a number is of one alone.
std::string of_which(const MobilityStory& story) {
    return story.of_sample.size() > 1 ? " in the first sample" : "";
}

/// Of the shares that move at the specified gradient, others than the one that counts.
std::string compare_measures(const MobilityStory& story) {
    const std::span<const erosion::MobilityStep> ramp = steps_below_heave(story.one());
    const auto step = std::ranges::find_if(ramp, [&](const erosion::MobilityStep& level) {
        return level.gradient >= story.specified_gradient.value_or(level.gradient) &&
               level.displaced_mass_share >= 0.01;
    });
    return step == ramp.end()
               ? ""
               : fmt::format(
                     "The result depends on the definition of movement: at i = {:.2f}{}, {} of the mass moved {} along "
                     "the flow, {} half a diameter in any direction, {} a tenth of one along it.",
                     step->gradient, of_which(story), moved_text(step->mobile_mass_share), distance_text(story),
                     moved_text(step->displaced_mass_share), moved_text(step->lifted_mass_share)
                 );
}

/// Why the stress that fines carry gives another gradient than what moves them.
std::string compare_with_alpha(const MobilityStory& story) {
    if (story.skempton_brogan.seeds == 0) {
        return "";
    }
    const std::string by_alpha = fmt::format(
        "Skempton and Brogan's α i_c is {}, with the α = {:.2f} of {}", gradient_text(story.skempton_brogan),
        story.alpha_fines.mean, story.of_sample.size() == 1 ? "this sample" : "these samples"
    );
    if (!is_met(story.moves_1, story)) {
        return by_alpha + ".";
    }
    const double ratio = story.moves_1.mean / story.skempton_brogan.mean;
    if (ratio > as_good_as_equal) {
        return by_alpha +
               ". This is below the gradient that moves 1 % here: even fines that carry little stress sit in "
               "pockets of the skeleton, and the water has to lift them out.";
    }
    if (ratio < 1 / as_good_as_equal) {
        return by_alpha + ". This is above the gradient that moves 1 % here: α is a mean, and the first fines to move "
                          "carry nothing.";
    }
    return by_alpha + ". This is near the gradient that moves 1 % here.";
}

std::string compare_with_heave_of_fines(const MobilityStory& story) {
    if (story.fines_heave.seeds == 0) {
        return "";
    }
    return fmt::format(
        "The seepage force on all fines outweighs them at {} ({}, s = {:.2f}{}: the share of the force that acts on "
        "them).",
        gradient_text(story.fines_heave), is_upward(story.one()) ? "FC i_c/s" : "heave × FC/s", story.one().drag_share,
        of_which(story)
    );
}

/// Of the grains that move, those that the skeleton's constrictions hold back.
std::string compare_with_passage(const MobilityStory& story) {
    const std::span<const erosion::MobilityStep> ramp = steps_below_heave(story.one());
    const erosion::MobilityStep last = ramp.empty() ? erosion::MobilityStep{} : ramp.back();
    if (!last.leaving_mass_share || *last.leaving_mass_share > 0.9 * last.mobile_mass_share ||
        last.mobile_mass_share < 0.01) {
        return "";
    }
    return fmt::format(
        "Of the fines that move at i = {:.2f}{}, {:.0f} % by mass are wider than the mean constriction of the skeleton "
        "and do not leave.",
        last.gradient, of_which(story), 100 * (1 - *last.leaving_mass_share / last.mobile_mass_share)
    );
}

} // namespace

std::vector<std::string> remarks_on(const MobilityStory& story) {
    std::vector<std::string> remarks;
    for (std::string remark :
         {compare_measures(story), compare_with_alpha(story), compare_with_heave_of_fines(story),
          compare_with_passage(story)}) {
        if (!remark.empty()) {
            remarks.push_back(std::move(remark));
        }
    }
    if (story.sifts) {
        remarks.push_back(fmt::format(
            "{} of the fines' mass sift through the skeleton under their own weight, without flow: the soil segregates "
            "during placement.",
            as_sentence(sifting_text(story))
        ));
    }
    return remarks;
}

std::optional<std::string> disagreement(const MobilityStory& story) {
    if (!do_disagree(story)) {
        return std::nullopt;
    }
    const bool rule_warns = *safety_by_rule(story) < 1;
    return fmt::format(
        "Skempton and Brogan's α i_c = {:.2f} is {} the specified {:.2f} and calls it {}. {}",
        story.skempton_brogan.mean, rule_warns ? "below" : "above", *story.specified_gradient,
        rule_warns ? "unstable" : "stable",
        rule_warns ? "The rule considers the mean stress that the fines carry. The ramp also includes the coarse "
                     "grains that cage them."
                   : "The rule uses a mean over all fines. The ramp finds the first fines that carry nothing."
    );
}

} // namespace suffuse::answer
