#include "suffuse/job/filter_atlas.hpp"

#include "suffuse/answer/filter_words.hpp"
#include "suffuse/answer/plain_numbers.hpp"
#include "suffuse/base/words.hpp"
#include "suffuse/record/or_null.hpp"
#include "suffuse/stability/filter_between.hpp"
#include "suffuse/stability/measured_part.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>

namespace suffuse::job {
namespace {

using answer::percent_text;
using atlas::FilterFound;
using atlas::FilterNode;
using nlohmann::json;

constexpr const char* limits_text =
    "uniform filters, four grains deep; a base 1.3 D15 thick, which bears no load: of a "
    "thicker base a smaller share passes";

std::string extent_of(const std::vector<atlas::FilterRow>& rows) {
    const auto [finest, coarsest] = std::ranges::minmax(rows, {}, &atlas::FilterRow::ratio);
    return fmt::format(
        "D15/d85 of {} to {} and d85/d15 up to {}", short_number(finest.ratio), short_number(coarsest.ratio),
        short_number(std::ranges::max(rows, {}, &atlas::FilterRow::width).width)
    );
}

/// "D15/d85 4.6, d85/d15 1.5".
std::string place_text(double ratio, double width) {
    return fmt::format("D15/d85 {}, d85/d15 {}", short_number(ratio), short_number(width));
}

/// "2.7 % passes", "at least 30 % passes", "nothing passes".
std::string passage_text(const FilterNode& node) {
    const std::string share = node.passed.mean == 0 ? "nothing" : percent_text(node.passed.mean);
    return fmt::format("{}{} passes", node.ended || node.passed.mean == 0 ? "" : "at least ", share);
}

/// "the filter holds after a loss: at i = 5, 2.7 % passes, then motion ends".
std::string verdict_text(double gradient, const FilterNode& node) {
    const answer::FilterVerdict verdict = answer::judge_filter(node.passed.mean, node.ended);
    return fmt::format(
        "{}: at i = {}, {}, {}",
        verdict == answer::FilterVerdict::Undecided ? "not decided" : answer::words_of(verdict), short_number(gradient),
        passage_text(node), node.ended ? "then motion ends" : "and motion goes on"
    );
}

/// Without their points. Where the nearest filter holds, a finer filter and a narrower base than all of the atlas are
/// on the safe side of it. Where it does not, a finer one may hold or not.
std::vector<std::string>
sentences_outside(const BaseOnFilter& pair, const std::string& extent, const FilterFound& found) {
    const FilterNode& nearest = found.nearest;
    const bool holds = nearest.ended && nearest.passed.mean <= answer::most_lost;
    const bool is_safe = holds && pair.ratio < nearest.ratio && pair.width <= nearest.width;
    return {
        fmt::format(
            "No simulated base is like this one ({}): the atlas of filters has {}", place_text(pair.ratio, pair.width),
            extent
        ),
        fmt::format(
            "Of the nearest ({}) {}{}", place_text(nearest.ratio, nearest.width), verdict_text(found.gradient, nearest),
            is_safe ? "" : "; that is no answer for yours"
        )};
}

std::vector<std::string> sentences_of(const FilterAtlasAnswer& answer) {
    if (!answer.pair) {
        return {"No simulated base can be compared: D15 of the filter, or d15 or d85 of the base, was not measured"};
    }
    const FilterFound& found = answer.found.back(); // the highest gradient, which the lower ones came before
    if (!found.node) {
        return sentences_outside(*answer.pair, answer.extent, found);
    }
    return {fmt::format(
        "Simulated bases like this one ({}): {}", place_text(answer.pair->ratio, answer.pair->width),
        verdict_text(found.gradient, *found.node)
    )};
}

/// "i = 5: 2.7 % passes, 1 % still moves; 3 samples, standard deviation 2 %".
std::string line_of(const FilterFound& found) {
    const FilterNode& node = found.node.value_or(found.nearest);
    const auto& deviation = node.passed.deviation;
    return fmt::format(
        "i = {}: {}, {} moves at the end; {} sample{}{}", short_number(found.gradient), passage_text(node),
        percent_text(node.moving), node.rows.size(), node.rows.size() == 1 ? "" : "s",
        deviation ? fmt::format(", standard deviation {}", percent_text(*deviation)) : ""
    );
}

json found_json(const FilterFound& found) {
    const FilterNode& node = found.node.value_or(found.nearest);
    return {
        {"gradient", found.gradient},
        {"inside", found.node.has_value()},
        {"interpolated", found.is_interpolated},
        {"size_ratio", node.ratio},
        {"base_width", node.width},
        {"passed", node.passed.mean},
        {"deviation", or_null(node.passed.deviation)},
        {"moving", node.moving},
        {"ended", node.ended},
        {"samples", node.rows.size()}};
}

} // namespace

FilterAtlasAnswer consult_filter_atlas(
    const grains::Grading& base, const grains::Grading& filter, const std::vector<atlas::FilterRow>& rows
) {
    FilterAtlasAnswer answer;
    const stability::BaseSoil soil = stability::characterize_base(base);
    const auto d15 = stability::size_within(filter, 0.15);
    if (rows.empty() || !soil.d85.is_known() || !soil.width || !d15) {
        return answer;
    }
    answer.pair = BaseOnFilter{*d15 / soil.d85.least, *soil.width};
    answer.extent = extent_of(rows);
    answer.found = atlas::look_up_filter(rows, answer.pair->ratio, answer.pair->width);
    for (const FilterFound& found : answer.found) {
        const auto error = atlas::error_of_filters(rows, found.gradient);
        answer.error = error ? std::optional(std::max(*error, answer.error.value_or(0))) : answer.error;
    }
    return answer;
}

std::string summary_of(const FilterAtlasAnswer& answer) {
    return fmt::format("{}.", fmt::join(sentences_of(answer), ". "));
}

std::string text_of(const FilterAtlasAnswer& answer) {
    std::string text;
    for (const std::string& sentence : sentences_of(answer)) {
        text += "  " + sentence + "\n";
    }
    if (answer.pair && answer.found.back().node) {
        for (const FilterFound& found : answer.found) {
            text += "      " + line_of(found) + "\n";
        }
        text += fmt::format("      {}\n", limits_text);
        if (answer.error) {
            text += fmt::format(
                "      between samples these shares are off by {} of the base\n", percent_text(*answer.error)
            );
        }
    }
    return text;
}

json filter_atlas_json(const FilterAtlasAnswer& answer) {
    json list = json::array();
    std::ranges::transform(answer.found, std::back_inserter(list), found_json);
    return {
        {"summary", summary_of(answer)},
        {"size_ratio", answer.pair ? json(answer.pair->ratio) : json(nullptr)},
        {"base_width", answer.pair ? json(answer.pair->width) : json(nullptr)},
        {"error", or_null(answer.error)},
        {"gradients", list}};
}

} // namespace suffuse::job
