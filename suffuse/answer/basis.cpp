#include "suffuse/answer/basis.hpp"

#include "suffuse/answer/doubt.hpp"
#include "suffuse/answer/mobility_words.hpp"
#include "suffuse/answer/plain_numbers.hpp"
#include "suffuse/atlas/look_up.hpp"
#include "suffuse/base/factor_of_safety.hpp"
#include "suffuse/base/grouped.hpp"
#include "suffuse/base/words.hpp"
#include "suffuse/casefile/stage_loading.hpp"
#include "suffuse/grains/grading.hpp"
#include "suffuse/grains/sampling.hpp"
#include "suffuse/grains/surrogate.hpp"
#include "suffuse/stability/critical_gradient.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace suffuse::answer {
namespace {

using nlohmann::json;
using study::MobilityStory;

/// One estimate of the gradient that moves 1 % of the fines.
struct Estimate {
    double gradient = 0;
    std::string by;
};

/// The gradient that moves 1 % over that which lifts single grains: 1.07 with a spread of 11 % over 12 samples
/// (theory/surrogates.md), all under upward flow.
constexpr double moves_over_single = 1.07;

/// The two parts of what was simulated.
struct Parts {
    double size_ratio = 0, fines_content = 0;
};

std::optional<Parts> parts_of(const grains::Soil& soil) {
    if (soil.coarse && soil.fines) {
        return Parts{grains::size_at(*soil.coarse, 0.5) / grains::size_at(*soil.fines, 0.5), soil.fines_content};
    }
    if (!soil.whole || !soil.finer_than) {
        return std::nullopt;
    }
    const auto ratio = grains::size_ratio(*soil.whole, *soil.finer_than);
    return ratio ? std::optional(Parts{*ratio, grains::passing(*soil.whole, *soil.finer_than)}) : std::nullopt;
}

/// Nothing for flows that the atlas lacks.
std::optional<atlas::Flow> flow_of(const erosion::MobilityResult& mobility) {
    const double downward = dot(mobility.down, mobility.direction);
    return downward < -0.9999          ? std::optional(atlas::Flow::Up)
           : std::abs(downward) < 1e-4 ? std::optional(atlas::Flow::Level)
                                       : std::nullopt;
}

void add_atlas(const MobilityStory& story, const std::vector<atlas::Row>& rows, std::vector<Estimate>& estimates) {
    const std::optional<grains::Soil>& soil = story.first->variant->soil;
    const auto parts = soil ? parts_of(*soil) : std::nullopt;
    const auto flow = flow_of(story.one());
    if (!parts || !flow) {
        return;
    }
    for (const atlas::Density density : atlas::densities_of(rows, *flow)) {
        const atlas::Found found = atlas::look_up(rows, parts->size_ratio, parts->fines_content, density, *flow);
        if (found.node && found.node->moves_1) {
            const double heave =
                stability::terzaghi_gradient(found.node->porosity, story.first->variant->material.density);
            estimates.push_back(
                {heave * found.node->moves_1->mean,
                 fmt::format(
                     "atlas, {}{}", atlas::name_of(density), found.node->moves_1->is_at_most ? ", at most" : ""
                 )}
            );
        }
    }
}

std::vector<Estimate> all_estimates(const MobilityStory& story, const std::vector<atlas::Row>& rows) {
    std::vector<Estimate> estimates;
    if (story.skempton_brogan.seeds > 0) {
        estimates.push_back({story.skempton_brogan.mean, "α i_c, Skempton and Brogan"});
    }
    const erosion::MobilityResult& one = story.one();
    if (is_upward(one) && one.single_grain_gradient) {
        estimates.push_back({moves_over_single * *one.single_grain_gradient, "lift of single grains"});
    }
    add_atlas(story, rows, estimates);
    if (2 * static_cast<std::size_t>(story.moves_1.seeds) > story.of_sample.size()) { // as the verdict has it
        estimates.push_back({story.moves_1.mean, "simulated"});
    }
    return estimates;
}

double share_between(const grains::Grading& curve, const grains::Grading& part) {
    return grains::passing(curve, part.diameter.back()) - grains::passing(curve, part.diameter.front());
}

void doubt_model(const MobilityStory& story, std::vector<Doubt>& doubts) {
    const std::optional<grains::Soil>& soil = story.first->variant->soil;
    if (!soil || !soil->measured) {
        return;
    }
    if (const grains::Surrogate* const surrogate = story.surrogate()) {
        doubts.push_back(
            {surrogate->ratio_of_soil > 1.001 * surrogate->size_ratio ? 10.0 : 3.0,
             "Two fractions stand for the soil (see “The soil and its surrogate”). In trials at size ratios of 3 to "
             "6.5 "
             "their first gradient was 16 % too low to 10 % too high."}
        );
        return;
    }
    const double share = share_between(*soil->measured, *soil->whole);
    constexpr double enough = 0.95;
    if (share < enough) {
        doubts.push_back(
            {(1 - share) / (1 - enough),
             fmt::format(
                 "Only {} of the mass is modeled. For the size ratio of the whole curve: `suffuse new --psd FILE "
                 "--surrogate`.",
                 percent_text(share)
             )}
        );
    }
}

/// Grains of the sample on which a stage looked at its fines first: an erosion has removed some since.
std::int64_t grains_at_first(const json& numbers) {
    std::int64_t grains = numbers.at("grains").get<std::int64_t>();
    for (const json& pass : numbers.value("passes", json::array())) {
        grains += pass.at("removed").get<std::int64_t>();
    }
    return grains;
}

void doubt_size(const MobilityStory& story, std::vector<Doubt>& doubts) {
    constexpr double wide = 10, many = 200;
    const std::optional<grains::Soil>& soil = story.first->variant->soil;
    const json& numbers = story.first->numbers;
    if (!soil || !numbers.contains("cell") || !numbers.contains("grains")) {
        return;
    }
    const grains::Grading grading = grains::specified_grading(*soil);
    const json& cell = numbers.at("cell");
    double narrowest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < 3; ++k) {
        narrowest = std::min(narrowest, cell.at(k).at(k).get<double>());
    }
    const double width = narrowest / grading.diameter.back();
    const std::int64_t grains = grains_at_first(numbers), coarse = grains - std::ssize(story.one().id);
    const double weight =
        std::max(wide / width, std::sqrt(many / static_cast<double>(std::max<std::int64_t>(1, coarse))));
    if (weight <= 1) {
        return;
    }
    const double wider = std::pow(wide / width, 3),
                 more = many / static_cast<double>(std::max<std::int64_t>(1, coarse));
    const std::string to_have =
        wider > 1 && more > 1 ? fmt::format("{:g} and {:g}", wide, many) : fmt::format("{:g}", wider > 1 ? wide : many);
    const casefile::Study& study = *story.first->study;
    // The floor of `sample_size` is the rule that none of its others lowers.
    const std::string key = study.sample_size ? "sample_size.at_least" : "particles";
    const std::int64_t specified = study.sample_size ? study.sample_size->at_least : study.particles;
    const double count = std::max(wider, more) * static_cast<double>(std::max(grains, specified));
    doubts.push_back(
        {weight, fmt::format(
                     "The cell is {} largest grains wide and has {} coarse grains. To have {}: `--set study.{}.{}={}`.",
                     short_number(width, 2), grouped(coarse), to_have, study.name, key,
                     std::llround(std::ceil(count / 100) * 100)
                 )}
    );
}

void doubt_motion(const MobilityStory& story, std::vector<Doubt>& doubts) {
    const bool is_early = story.at_most_1 || story.ends_in_motion;
    if (is_early || story.at_most_10) {
        const char* const consequence = story.at_most_1        ? "these gradients may be lower"
                                        : story.ends_in_motion ? "1 % of them may move below the last gradient"
                                                               : "the gradient that moves a tenth may be lower";
        doubts.push_back(
            {is_early ? 4.0 : 1.5,
             fmt::format(
                 "Fines were still moving when the gradient rose, so that {}. To hold longer: `--set "
                 "study.{}.stage.{}.hold_at_most={:g}`.",
                 consequence, story.first->study->name, story.first->stage->name, 4 * story.hold_at_most
             )}
        );
    }
}

/// The compaction from which the stage comes, if it could have released its shear stresses.
const casefile::Stage* find_unreleased(const record::FinishedStage& finished) {
    const casefile::Stage* stage = finished.stage;
    while (stage->parent >= 0) {
        stage = &finished.variant->stages.at(static_cast<std::size_t>(stage->parent));
        if (casefile::could_release_shear(stage->spec)) {
            return stage;
        }
    }
    return nullptr;
}

void doubt_stress(const MobilityStory& story, std::vector<Doubt>& doubts) {
    constexpr double much = 0.1; // q/p of a sample that was compacted by equal stresses
    const json& numbers = story.first->numbers;
    if (!numbers.contains("deviator_stress") || !numbers.contains("mean_stress")) {
        return;
    }
    const double q = numbers.at("deviator_stress"), p = numbers.at("mean_stress");
    if (p > 0 && q > much * p) {
        const casefile::Stage* const compaction = find_unreleased(*story.first);
        doubts.push_back(
            {q / (much * p),
             fmt::format(
                 "The preparation left a shear stress of q = {} kPa at p = {} kPa; {}.", short_number(q / 1e3, 2),
                 short_number(p / 1e3),
                 compaction == nullptr ? "a larger sample has less"
                                       : fmt::format(
                                             "to release it: `--set study.{}.stage.{}.shear_stresses=released`",
                                             story.first->study->name, compaction->name
                                         )
             )}
        );
    }
}

} // namespace

std::string estimates_of(const MobilityStory& story, const std::vector<atlas::Row>& rows) {
    const std::vector<Estimate> estimates = all_estimates(story, rows);
    if (estimates.size() < 2) {
        return "";
    }
    std::vector<std::string> texts;
    texts.reserve(estimates.size());
    for (const Estimate& estimate : estimates) {
        texts.push_back(fmt::format("{:.2f} ({})", estimate.gradient, estimate.by));
    }
    const grains::Surrogate* const surrogate = story.surrogate();
    std::string text = fmt::format(
        "{} flow{} moves 1 % of the fines at estimated gradients of {}.", flow_in_words(story.one()),
        surrogate == nullptr ? "" : " at a size ratio of " + short_number(surrogate->size_ratio), fmt::join(texts, ", ")
    );
    if (story.specified_gradient && *story.specified_gradient > 0) {
        const auto [least, most] = std::ranges::minmax_element(estimates, {}, &Estimate::gradient);
        const double specified = *story.specified_gradient;
        text += fmt::format(
            " Over the specified {:g}: {} ({}) to {} ({}).", specified, factor_text(least->gradient / specified),
            least->by, factor_text(most->gradient / specified), most->by
        );
    }
    return text;
}

std::vector<std::string> doubts_about(const MobilityStory& story) {
    std::vector<Doubt> doubts;
    doubt_model(story, doubts);
    doubt_size(story, doubts);
    doubt_motion(story, doubts);
    doubt_stress(story, doubts);
    return largest_of(std::move(doubts));
}

} // namespace suffuse::answer
