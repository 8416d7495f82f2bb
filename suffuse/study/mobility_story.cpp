#include "suffuse/study/mobility_story.hpp"

#include "suffuse/study/trace_curves.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace suffuse::study {
namespace {

const erosion::WeighedMotion& weighed_of(const casefile::Stage& stage) {
    if (const auto* const detach = std::get_if<erosion::DetachStageSpec>(&stage.spec)) {
        return detach->probe.weighed;
    }
    return std::get<erosion::ErodeSpec>(stage.spec).probe.weighed;
}

/// Of what the samples have, not a number where they do not.
template <class Value>
Scatter over_samples(const MobilityStory& story, Value value) {
    std::vector<double> of_sample;
    for (const erosion::MobilityResult* mobility : story.of_sample) {
        const std::optional<double> has = value(*mobility);
        of_sample.push_back(has.value_or(std::numeric_limits<double>::quiet_NaN()));
    }
    return scatter_of(std::move(of_sample));
}

void compare_samples(MobilityStory& story) {
    using erosion::MobilityResult;
    story.moves_1 = over_samples(story, [](const MobilityResult& m) { return m.moves_1; });
    story.moves_10 = over_samples(story, [](const MobilityResult& m) { return m.moves_10; });
    story.moves_50 = over_samples(story, [](const MobilityResult& m) { return m.moves_50; });
    for (const auto& [share, at_most] :
         {std::pair{0.01, &story.at_most_1}, {0.1, &story.at_most_10}, {0.5, &story.at_most_50}}) {
        *at_most = std::ranges::any_of(story.of_sample, [&, moved = share](const MobilityResult* mobility) {
            return is_upper_bound(*mobility, moved);
        });
    }
    story.ends_in_motion = std::ranges::any_of(story.of_sample, [](const MobilityResult* mobility) {
        const std::span<const erosion::MobilityStep> ramp = steps_below_heave(*mobility);
        return !mobility->moves_1 && !ramp.empty() && is_still_growing(ramp.back());
    });
    story.heave = over_samples(story, [](const MobilityResult& m) { return m.heave_gradient; });
    story.skempton_brogan = over_samples(story, [](const MobilityResult& m) { return m.skempton_brogan_gradient; });
    story.fines_heave = over_samples(story, [](const MobilityResult& m) { return m.fines_heave_gradient; });
    story.alpha_fines = over_samples(story, [](const MobilityResult& m) { return m.alpha_fines; });
    const auto safety_of = [&](const MobilityResult& m) {
        return story.specified_gradient ? erosion::factor_of_safety(m) : std::nullopt;
    };
    story.safety = over_samples(story, [&](const MobilityResult& m) {
        const std::optional<erosion::FactorOfSafety> safety = safety_of(m);
        return safety ? safety->factor : std::nullopt;
    });
    if (story.specified_gradient) {
        story.moved_at_specified =
            over_samples(story, [](const MobilityResult& m) { return mobile_share_at(m, *m.specified_gradient); });
        story.moved_at_specified_at_least = std::ranges::any_of(story.of_sample, [](const MobilityResult* m) {
            return is_lower_bound(*m, *m->specified_gradient);
        });
        story.lifted_at_specified =
            static_cast<std::size_t>(std::ranges::count_if(story.of_sample, [](const MobilityResult* m) {
                return floats(*m, *m->specified_gradient);
            }));
    }
    double least = std::numeric_limits<double>::infinity();
    bool is_bound = false;
    for (const MobilityResult* mobility : story.of_sample) {
        if (const std::optional<erosion::FactorOfSafety> safety = safety_of(*mobility)) {
            least = std::min(least, safety->at_least);
            is_bound = is_bound || !safety->factor;
        }
        story.sifts = story.sifts || mobility->sifts;
    }
    if (is_bound && least > 0) {
        story.safety_at_least = least;
    }
}

} // namespace

const grains::Surrogate* MobilityStory::surrogate() const {
    const std::optional<grains::Soil>& soil = first->variant->soil;
    return soil && soil->surrogate ? &*soil->surrogate : nullptr;
}

bool is_met(const Scatter& value, const MobilityStory& story) {
    return 2 * static_cast<std::size_t>(value.seeds) > story.of_sample.size();
}

const erosion::MobilityResult* mobility_of(const record::FinishedStage& stage) {
    if (stage.findings.mobility) {
        return &*stage.findings.mobility;
    }
    const erosion::MobilityResult* intact = nullptr;
    if (stage.findings.erosion) {
        for (const erosion::PassResult& pass : stage.findings.erosion->passes) {
            if (!pass.mobility) {
                break;
            }
            const bool is_higher =
                intact == nullptr || pass.mobility->ramp.back().gradient > intact->ramp.back().gradient;
            intact = is_higher ? &*pass.mobility : intact;
            if (pass.removed > 0) {
                break;
            }
        }
    }
    return intact;
}

std::optional<double> specified_gradient(const record::FinishedStage& stage) {
    const erosion::MobilityResult* const mobility = mobility_of(stage);
    const std::optional<double> specified = mobility == nullptr ? std::nullopt : mobility->specified_gradient;
    const bool has_higher = specified && stage.findings.erosion && !stage.findings.mobility &&
                            std::ranges::any_of(stage.findings.erosion->passes, [&](const erosion::PassResult& pass) {
                                return pass.probe.gradient > *specified;
                            });
    return has_higher ? std::nullopt : specified;
}

std::vector<MobilityStory> gather_mobility(const std::vector<record::FinishedStage>& stages) {
    std::vector<MobilityStory> stories;
    for (const record::FinishedStage& stage : stages) {
        const erosion::MobilityResult* const mobility = mobility_of(stage);
        if (mobility == nullptr || mobility->id.empty()) {
            continue;
        }
        const std::string name = in_words(stage);
        auto story = std::ranges::find(stories, name, &MobilityStory::name);
        if (story == stories.end()) {
            story = stories.insert(stories.end(), MobilityStory{});
            story->first = &stage;
            story->name = name;
            story->specified_gradient = specified_gradient(stage);
            story->moved = weighed_of(*stage.stage).moved;
            story->hold_at_most = weighed_of(*stage.stage).hold_at_most;
        }
        story->of_sample.push_back(mobility);
    }
    std::ranges::for_each(stories, compare_samples);
    return stories;
}

const MobilityStory* main_mobility(const std::vector<MobilityStory>& stories) {
    const auto specified = std::ranges::find_if(stories, [](const MobilityStory& story) {
        return story.first->findings.mobility && story.specified_gradient;
    });
    if (specified != stories.end()) {
        return &*specified;
    }
    const auto ramp = std::ranges::find_if(stories, [](const MobilityStory& story) {
        return story.first->findings.mobility.has_value();
    });
    return ramp != stories.end() ? &*ramp : stories.empty() ? nullptr : &stories.front();
}

} // namespace suffuse::study
