#include "suffuse/answer/surrogate_words.hpp"

#include "suffuse/answer/mobility_words.hpp"
#include "suffuse/answer/plain_numbers.hpp"
#include "suffuse/base/words.hpp"
#include "suffuse/grains/grading.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace suffuse::answer {
namespace {

using grains::Grading;
using study::MobilityStory;

const grains::Soil& soil_of(const MobilityStory& story) {
    return *story.first->variant->soil;
}

/// D90/D10 of the part of a curve between two shares of the mass; nothing where one of them was not measured.
std::optional<double> width_between(const Grading& curve, double from, double to) {
    constexpr double tenth = 0.1;
    const double low = from + tenth * (to - from), high = to - tenth * (to - from);
    if (low < curve.passing.front() || high > curve.passing.back()) {
        return std::nullopt;
    }
    return grains::size_at(curve, high) / grains::size_at(curve, low);
}

std::string width_text(const std::optional<double>& width) {
    return width ? short_number(*width, 2) : "unknown";
}

/// Both parts' widths as text: the coarse part, the fines.
std::pair<std::string, std::string> widths_of(const grains::Soil& soil) {
    return {
        width_text(width_between(*soil.measured, soil.fines_content, 1)),
        width_text(width_between(*soil.measured, 0, soil.fines_content))};
}

/// "4, 6.5 and 10".
std::string listed(const std::vector<std::string>& parts) {
    return parts.size() < 2 ? fmt::format("{}", fmt::join(parts, ""))
                            : fmt::format("{} and {}", fmt::join(parts.begin(), parts.end() - 1, ", "), parts.back());
}

/// Those of the reported stage, the size ratio rising.
std::vector<const MobilityStory*> stories_by_ratio(const std::vector<MobilityStory>& stories) {
    const MobilityStory* const main = study::main_mobility(stories);
    std::vector<const MobilityStory*> found;
    if (main == nullptr || main->surrogate() == nullptr) {
        return found;
    }
    for (const MobilityStory& story : stories) {
        if (story.surrogate() != nullptr && story.first->study == main->first->study &&
            story.first->stage->name == main->first->stage->name) {
            found.push_back(&story);
        }
    }
    std::ranges::sort(found, {}, [](const MobilityStory* story) { return story->surrogate()->size_ratio; });
    return found;
}

std::string ratios_of(const std::vector<const MobilityStory*>& stories) {
    std::vector<std::string> texts;
    texts.reserve(stories.size());
    for (const MobilityStory* const story : stories) {
        texts.push_back(short_number(story->surrogate()->size_ratio));
    }
    return listed(texts);
}

/// "0.40, 0.30 and 0.22", with "more than 1.2" where the ramp ends before.
std::string gradients_by_ratio(
    const std::vector<const MobilityStory*>& stories, study::Scatter MobilityStory::*gradient,
    bool MobilityStory::*at_most
) {
    std::vector<std::string> texts;
    texts.reserve(stories.size());
    for (const MobilityStory* const story : stories) {
        const study::Scatter& found = story->*gradient;
        texts.push_back(
            found.seeds == 0 ? fmt::format("more than {:.2f}", story->one().ramp.back().gradient)
                             : fmt::format("{}{:.2f}", story->*at_most ? "≤ " : "", found.mean)
        );
    }
    return listed(texts);
}

} // namespace

std::vector<std::string> left_out_of(const grains::Soil& soil, double largest_ratio) {
    constexpr double silt = 0.063e-3, as_good_as_equal = 1.001;
    const auto [coarse, fines] = widths_of(soil);
    std::vector<std::string> sentences = {
        fmt::format(
            "The width of both parts: D90/D10 is {} in the coarse part and {} in the fines. Each fraction of the "
            "surrogate has nearly equal grains.",
            coarse, fines
        ),
        "The shape of the grains: the model has spheres with rolling resistance.",
        "The density in the field: the sample is as dense as its preparation makes it."};
    if (soil.surrogate->ratio_of_soil > as_good_as_equal * largest_ratio) {
        sentences.push_back(fmt::format(
            "The size ratio of {}: the largest that was simulated is {}.", short_number(soil.surrogate->ratio_of_soil),
            short_number(largest_ratio)
        ));
    }
    if (const double finer = grains::passing(*soil.measured, silt); finer > 0) {
        sentences.push_back(fmt::format(
            "Cohesion: {} of the mass is finer than 0.063 mm, and the fines do not stick.", percent_text(finer)
        ));
    }
    return sentences;
}

const MobilityStory* nearest_surrogate(const std::vector<MobilityStory>& stories) {
    const std::vector<const MobilityStory*> by_ratio = stories_by_ratio(stories);
    return by_ratio.empty() ? nullptr : by_ratio.back();
}

std::vector<std::string> verdict_by_ratio(const std::vector<MobilityStory>& stories) {
    const std::vector<const MobilityStory*> by_ratio = stories_by_ratio(stories);
    if (by_ratio.size() < 2) {
        return {};
    }
    const MobilityStory& last = *by_ratio.back();
    std::vector<std::string> lines = {
        fmt::format(
            "{} moves 1 % of the fines at i = {} at size ratios of {}.", subject_of(last),
            gradients_by_ratio(by_ratio, &MobilityStory::moves_1, &MobilityStory::at_most_1), ratios_of(by_ratio)
        ),
        fmt::format(
            "It moves a tenth at {}.",
            gradients_by_ratio(by_ratio, &MobilityStory::moves_10, &MobilityStory::at_most_10)
        )};
    const double of_soil = last.surrogate()->ratio_of_soil, largest = last.surrogate()->size_ratio;
    if (of_soil > largest) {
        lines.push_back(
            fmt::format("The soil's ratio is {}: its own gradients are an extrapolation.", short_number(of_soil)) +
            (of_soil > sifting_ratio ? " Above 6.5 single fines sift through the skeleton without flow." : "")
        );
    }
    return lines;
}

std::optional<figures::PageTable> tabulate_surrogate(const std::vector<MobilityStory>& stories) {
    const std::vector<const MobilityStory*> by_ratio = stories_by_ratio(stories);
    if (by_ratio.empty()) {
        return std::nullopt;
    }
    const grains::Soil& soil = soil_of(*by_ratio.back());
    const grains::Surrogate& surrogate = *soil.surrogate;
    const auto [coarse, fines] = widths_of(soil);
    const std::string content = percent_text(soil.fines_content), equal = width_text(width_between(*soil.coarse, 0, 1));
    figures::PageTable table;
    table.section = "Soils";
    table.title = "The soil and its surrogate";
    table.note = "What the surrogate leaves out:";
    for (const std::string& sentence : left_out_of(soil, surrogate.size_ratio)) {
        table.note += " " + sentence;
    }
    table.header = {"", "soil", "surrogate"};
    table.numeric = {false, true, true};
    table.rows = {
        {"split [mm]", short_number(1e3 * surrogate.finer_than), "–"},
        {"fines content by mass", content, content},
        {"size ratio D50/d50 [-]", short_number(surrogate.ratio_of_soil), ratios_of(by_ratio)},
        {"D50 of the coarse part [mm]",
         short_number(1e3 * grains::size_at(*soil.measured, (1 + soil.fines_content) / 2)),
         short_number(1e3 * grains::size_at(*soil.coarse, 0.5))},
        {"D90/D10 of the coarse part [-]", coarse, equal},
        {"d90/d10 of the fines [-]", fines, equal}};
    return table;
}

} // namespace suffuse::answer
