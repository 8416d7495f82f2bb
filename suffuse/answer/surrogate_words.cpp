#include "suffuse/answer/surrogate_words.hpp"

#include "suffuse/answer/mobility_text.hpp"
#include "suffuse/answer/mobility_words.hpp"
#include "suffuse/answer/plain_numbers.hpp"
#include "suffuse/base/words.hpp"
#include "suffuse/grains/grading.hpp"
#include "suffuse/grains/surrogate.hpp"
#include "suffuse/stability/measured_part.hpp"
#include "suffuse/study/trace_curves.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <span>

namespace suffuse::answer {
namespace {

using grains::Grading;
using study::MobilityStory;

const grains::Soil& soil_of(const MobilityStory& story) {
    return *story.first->variant->soil;
}

std::string width_text(const std::optional<double>& width) {
    return width ? short_number(*width, 2) : "unknown";
}

/// D90/D10 of the coarse part and of the fines as text.
struct Widths {
    std::string coarse, fines;
};

Widths widths_of(const grains::Soil& soil) {
    return {
        width_text(grains::width_between(*soil.measured, soil.fines_content, 1)),
        width_text(grains::width_between(*soil.measured, 0, soil.fines_content))};
}

Widths widths_of_surrogate(const grains::Soil& soil) {
    return {
        width_text(grains::width_between(*soil.coarse, 0, 1)), width_text(grains::width_between(*soil.fines, 0, 1))};
}

/// "4, 6.5 and 10".
std::string listed(const std::vector<std::string>& parts) {
    return parts.size() < 2 ? fmt::format("{}", fmt::join(parts, ""))
                            : fmt::format("{} and {}", fmt::join(parts.begin(), parts.end() - 1, ", "), parts.back());
}

/// Of one stage, the size ratio rising.
using ByRatio = std::vector<const MobilityStory*>;

/// Values of the swept keys of a sample's study, without the size ratio.
std::vector<std::string> other_values(const MobilityStory& story) {
    std::vector<std::string> values = study::sweep_values(*story.first->study, *story.first->variant);
    for (std::size_t k = values.size(); k-- > 0;) {
        if (story.first->study->sweep[k].key.ends_with("size_ratio")) {
            values.erase(values.begin() + static_cast<std::ptrdiff_t>(k));
        }
    }
    return values;
}

/// A stage of the reported study each, the reported one first, at its values of other keys; none where its soil is no
/// surrogate.
std::vector<ByRatio> stages_by_ratio(const std::vector<MobilityStory>& stories) {
    const MobilityStory* const main = study::main_mobility(stories);
    if (main == nullptr || main->surrogate() == nullptr) {
        return {};
    }
    std::vector<ByRatio> stages = {{}};
    std::map<std::string, std::size_t> row_of = {{main->first->stage->name, 0}};
    for (const MobilityStory& story : stories) {
        if (story.surrogate() == nullptr || story.first->study != main->first->study ||
            other_values(story) != other_values(*main)) {
            continue;
        }
        const auto [found, is_new] = row_of.emplace(story.first->stage->name, stages.size());
        if (is_new) {
            stages.emplace_back();
        }
        stages[found->second].push_back(&story);
    }
    for (ByRatio& stage : stages) {
        std::ranges::sort(stage, {}, [](const MobilityStory* story) { return story->surrogate()->size_ratio; });
    }
    return stages;
}

ByRatio reported_by_ratio(const std::vector<MobilityStory>& stories) {
    std::vector<ByRatio> stages = stages_by_ratio(stories);
    return stages.empty() ? ByRatio{} : stages.front();
}

std::string ratios_of(const ByRatio& stories) {
    std::vector<std::string> texts;
    texts.reserve(stories.size());
    for (const MobilityStory* const story : stories) {
        texts.push_back(short_number(story->surrogate()->size_ratio));
    }
    return listed(texts);
}

/// "0.40, 0.30 and 0.22", "none below heave (1.13)" or "more than 1.20" where most samples do not reach it.
std::string
gradients_by_ratio(const ByRatio& stories, study::Scatter MobilityStory::*gradient, bool MobilityStory::*at_most) {
    std::vector<std::string> texts;
    texts.reserve(stories.size());
    for (const MobilityStory* const story : stories) {
        const study::Scatter& found = story->*gradient;
        texts.push_back(
            is_met(found, *story)   ? fmt::format("{}{:.2f}", story->*at_most ? "≤ " : "", found.mean)
            : goes_to_heave(*story) ? fmt::format("none below heave ({:.2f})", story->heave.mean)
                                    : fmt::format("more than {:.2f}", end_of_ramp(*story))
        );
    }
    return listed(texts);
}

/// "a tenth at 0.60 and more than 1.20", "less than a tenth up to i = 1.20" where no ratio reaches it.
std::string moved_by_ratio(
    const ByRatio& stories, const char* share, const char* at, study::Scatter MobilityStory::*gradient,
    bool MobilityStory::*at_most
) {
    const std::string end = end_text(*stories.front());
    const auto is_never = [&](const MobilityStory* story) {
        return !is_met(story->*gradient, *story) && end_text(*story) == end;
    };
    return std::ranges::all_of(stories, is_never)
               ? fmt::format("less than {} {}", share, end)
               : fmt::format("{} at {}{}", share, at, gradients_by_ratio(stories, gradient, at_most));
}

std::string first_by_ratio(const ByRatio& stories, const char* share, const char* at) {
    return moved_by_ratio(stories, share, at, &MobilityStory::moves_1, &MobilityStory::at_most_1);
}

/// " Above 6.5 single fines may sift through the skeleton without flow; at 7.5 less than 0.1 % of their mass did."
std::string sifting_by_ratio(const MobilityStory& largest) {
    const double ratio = largest.surrogate()->size_ratio;
    return fmt::format(
        " Above {} single fines may sift through the skeleton without flow{}.", short_number(sifting_ratio),
        ratio > sifting_ratio ? fmt::format("; at {} {} of their mass did", short_number(ratio), sifting_text(largest))
                              : ""
    );
}

} // namespace

std::vector<std::string> left_out_of(const grains::Soil& soil, double largest_ratio) {
    constexpr double silt = 0.063e-3, as_good_as_equal = 1.001;
    const Widths own = widths_of(soil), modeled = widths_of_surrogate(soil);
    std::vector<std::string> sentences;
    if (own.coarse != modeled.coarse || own.fines != modeled.fines) {
        sentences.push_back(fmt::format(
            "The width of both parts: D90/D10 is {} in the coarse part and {} in the fines. The surrogate has {} and "
            "{}.",
            own.coarse, own.fines, modeled.coarse, modeled.fines
        ));
    }
    sentences.insert(
        sentences.end(), {"The shape of the grains: the model has spheres with rolling resistance.",
                          "The density in the field: the sample is as dense as its preparation makes it."}
    );
    if (soil.surrogate->ratio_of_soil > as_good_as_equal * largest_ratio) {
        sentences.push_back(fmt::format(
            "The size ratio of {}: the largest that was simulated is {}.", short_number(soil.surrogate->ratio_of_soil),
            short_number(largest_ratio)
        ));
    }
    if (const stability::Bounds finer = stability::share_bounds(*soil.measured, silt); finer.most > 0) {
        sentences.push_back(fmt::format(
            "Cohesion: {} of the mass {} finer than 0.063 mm{}, and the fines do not stick.",
            (finer.is_known() ? "" : "up to ") + percent_text(finer.most), finer.is_known() ? "is" : "may be",
            finer.is_known()
                ? ""
                : fmt::format(" (the curve ends at {} mm)", short_number(1e3 * soil.measured->diameter.front()))
        ));
    }
    return sentences;
}

const MobilityStory* nearest_surrogate(const std::vector<MobilityStory>& stories) {
    const ByRatio by_ratio = reported_by_ratio(stories);
    return by_ratio.empty() ? nullptr : by_ratio.back();
}

std::vector<std::string> verdict_by_ratio(const std::vector<MobilityStory>& stories) {
    const std::vector<ByRatio> stages = stages_by_ratio(stories);
    if (stages.empty() || stages.front().size() < 2 || !other_values(*stages.front().front()).empty()) {
        return {}; // a series at one value of another key does not stand for the others
    }
    const ByRatio& reported = stages.front();
    const MobilityStory& last = *reported.back();
    std::vector<std::string> lines = {fmt::format(
        "{} moves {} at size ratios of {}.", subject_of(last), first_by_ratio(reported, "1 % of the fines", "i = "),
        ratios_of(reported)
    )};
    if (stages.size() == 1) {
        lines.push_back(fmt::format(
            "It moves {}.",
            moved_by_ratio(reported, "a tenth", "", &MobilityStory::moves_10, &MobilityStory::at_most_10)
        ));
    }
    const double of_soil = last.surrogate()->ratio_of_soil, largest = last.surrogate()->size_ratio;
    if (of_soil > largest) {
        lines.push_back(
            fmt::format("The soil's ratio is {}: its own gradients are an extrapolation.", short_number(of_soil)) +
            (of_soil > sifting_ratio ? sifting_by_ratio(last) : "")
        );
    }
    for (const ByRatio& other : std::span(stages).subspan(1)) {
        lines.push_back(
            fmt::format("{} flow moves {}.", flow_in_words(other.back()->one()), first_by_ratio(other, "1 %", ""))
        );
    }
    return lines;
}

std::optional<figures::PageTable> tabulate_surrogate(const std::vector<MobilityStory>& stories) {
    const ByRatio by_ratio = reported_by_ratio(stories);
    if (by_ratio.empty()) {
        return std::nullopt;
    }
    const grains::Soil& soil = soil_of(*by_ratio.back());
    const grains::Surrogate& surrogate = *soil.surrogate;
    const Widths own = widths_of(soil), modeled = widths_of_surrogate(soil);
    const std::string content = percent_text(soil.fines_content);
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
        {"D90/D10 of the coarse part [-]", own.coarse, modeled.coarse},
        {"d90/d10 of the fines [-]", own.fines, modeled.fines}};
    return table;
}

} // namespace suffuse::answer
