#include "suffuse/answer/samples_table.hpp"

#include "suffuse/answer/headlines.hpp"
#include "suffuse/answer/plain_numbers.hpp"
#include "suffuse/base/grouped.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <vector>

namespace suffuse::answer {
namespace {

using study::OutcomePoint;
using study::Result;
using study::Scatter;
using study::StudyOutcome;

constexpr std::size_t no_point = static_cast<std::size_t>(-1);

/// The point whose samples differ most in a result; none where no two differ.
std::size_t most_scattered(const StudyOutcome& outcome, Result which) {
    std::size_t found = no_point;
    double largest = 0;
    for (std::size_t k = 0; k < outcome.points.size(); ++k) {
        if (const Scatter* const value = outcome.points[k].find(which); value && value->standard_deviation > largest) {
            largest = value->standard_deviation, found = k;
        }
    }
    return found;
}

/// The point before the largest step of a result; none where the sweep does not change it, or has but one step.
std::size_t before_largest_step(const StudyOutcome& outcome, Result which) {
    std::size_t found = no_point;
    double largest = 0;
    for (std::size_t k = 0; k + 1 < outcome.points.size(); ++k) {
        const Scatter *here = outcome.points[k].find(which), *next = outcome.points[k + 1].find(which);
        if (here != nullptr && next != nullptr && std::abs(next->mean - here->mean) > largest) {
            largest = std::abs(next->mean - here->mean), found = k;
        }
    }
    return outcome.keys.size() == 1 && outcome.points.size() > 2 && study::depends_on_sweep(outcome, which) ? found
                                                                                                            : no_point;
}

/// The folder of the sample that lies farthest from the mean of its point.
std::string farthest_sample(const OutcomePoint& point, Result which) {
    const Scatter& value = *point.find(which);
    const auto farthest = std::ranges::max_element(value.of_seed, {}, [&](double of_seed) {
        return std::isfinite(of_seed) ? std::abs(of_seed - value.mean) : -1;
    });
    const casefile::Variant* const sample = point.samples[static_cast<std::size_t>(farthest - value.of_seed.begin())];
    return sample == nullptr ? "" : "studies/" + sample->folder;
}

std::string which_to_look_at(const StudyOutcome& outcome, std::size_t row, std::optional<Result> main) {
    const OutcomePoint& point = outcome.points[row];
    if (!main) {
        return "";
    }
    std::vector<std::string> remarks;
    const Scatter* const value = point.find(*main);
    if (value == nullptr) {
        return "no result: see " + std::string("studies/") + point.samples.front()->folder;
    }
    if (value->seeds < static_cast<int>(value->of_seed.size())) {
        remarks.push_back(fmt::format("{} of {} samples have a result", value->seeds, value->of_seed.size()));
    }
    if (row == most_scattered(outcome, *main)) {
        remarks.push_back("its samples differ most: see " + farthest_sample(point, *main));
    }
    if (row == before_largest_step(outcome, *main)) {
        remarks.emplace_back("largest step, to the next value");
    }
    std::string text;
    for (const std::string& remark : remarks) {
        text += (text.empty() ? "" : "; ") + remark;
    }
    return text;
}

std::string cell(const OutcomePoint& point, Result which, const flow::Fluid& fluid) {
    const Scatter* const value = point.find(which);
    if (value == nullptr) {
        return "–";
    }
    const std::string spread = result_spread(which, *value, fluid);
    return mean_text(point, which, fluid) + (spread.empty() ? "" : " " + spread);
}

/// A number of the loose state, as reported with its deviation; "–" where no seed has it.
std::string structure_text(const study::FinesStudy& fines, std::size_t row, const char* number, int decimals) {
    const Scatter value = study::number_of(fines.loose.points[row], fines.fines_content[row], number);
    const std::string spread = spread_text(value, 1, decimals);
    return value.seeds == 0 ? "–" : fixed(value.mean, decimals) + (spread.empty() ? "" : " " + spread);
}

/// "56 / 41 / 3": shares of contacts between coarse grains, coarse and fine, fines.
std::string contacts_text(const study::FinesStudy& fines, std::size_t row) {
    std::string text;
    for (const char* const kind : {"contact_share.LL", "contact_share.LS", "contact_share.SS"}) {
        const Scatter value = study::number_of(fines.loose.points[row], fines.fines_content[row], kind);
        text += (text.empty() ? "" : " / ") + (value.seeds == 0 ? std::string("–") : fixed(100 * value.mean, 0));
    }
    return text;
}

constexpr std::array structure_header = {"e_g", "e_eq", "active fines b", "LL / LS / SS [%]"};

/// What fines make of the structure at the fines content of a point; cells of `structure_header`.
std::vector<std::string> structure_of(const OutcomePoint& point, const study::FinesSweep& sweep) {
    const study::FinesStudy& fines = sweep.curves;
    const auto is_same = [&](const study::SweepPoint& loose) { return loose.written == point.at.written; };
    const auto row =
        static_cast<std::size_t>(std::ranges::find_if(fines.loose.points, is_same) - fines.loose.points.begin());
    if (row >= fines.loose.points.size()) {
        return std::vector<std::string>(structure_header.size(), "–");
    }
    return {
        structure_text(fines, row, "intergranular_void_ratio", 3),
        structure_text(fines, row, "equivalent_void_ratio", 3), structure_text(fines, row, "active_fines_fraction", 2),
        contacts_text(fines, row)};
}

std::string seeds_of(const OutcomePoint& point) {
    return std::to_string(point.samples.size());
}

} // namespace

std::optional<figures::PageTable>
tabulate_samples(const StudyOutcome& outcome, const flow::Fluid& fluid, const study::FinesSweep* fines) {
    const bool has_structure = fines != nullptr && outcome.study == fines->study;
    if (outcome.points.size() < 2) {
        return std::nullopt;
    }
    std::vector<Result> shown;
    for (int k = 0; k < study::results; ++k) {
        if (outcome.has(static_cast<Result>(k))) {
            shown.push_back(static_cast<Result>(k));
        }
    }
    const std::optional<Result> main = study::main_result(outcome);
    figures::PageTable table;
    table.section = "Samples";
    table.title = fmt::format("Samples of the study “{}”", outcome.study == nullptr ? "" : outcome.study->name);
    table.note = outcome.seeds() > 1 ? "Means of the samples, ± one standard deviation." : "One sample each.";
    if (outcome.points.size() < outcome.all_points()) {
        table.note += fmt::format(" {} of {} points have a result.", outcome.points.size(), outcome.all_points());
    }
    const auto has_bound = [](const OutcomePoint& point) { return !point.at_most.empty(); };
    if (std::ranges::any_of(outcome.points, has_bound)) {
        table.note += " ≤: motion had not ended when the gradient rose.";
    }
    if (!outcome.first_probe.empty()) {
        table.note += fmt::format(" First movements are those of the stage “{}”.", outcome.first_probe);
    }
    for (const std::string& key : outcome.keys) {
        table.header.push_back(study::key_in_words(key, outcome.keys));
    }
    table.header.emplace_back("seeds");
    for (const Result which : shown) {
        table.header.push_back(result_label(which));
    }
    if (has_structure) {
        table.header.insert(table.header.end(), structure_header.begin(), structure_header.end());
    }
    table.header.emplace_back("which to look at");
    table.numeric.assign(table.header.size(), true);
    table.numeric.back() = false;
    for (std::size_t row = 0; row < outcome.points.size(); ++row) {
        const OutcomePoint& point = outcome.points[row];
        std::vector<std::string> cells;
        for (std::size_t key = 0; key < outcome.keys.size(); ++key) {
            cells.push_back(value_in_words(point.at, key));
        }
        cells.push_back(seeds_of(point));
        for (const Result which : shown) {
            cells.push_back(cell(point, which, fluid));
        }
        if (has_structure) {
            std::ranges::move(structure_of(point, *fines), std::back_inserter(cells));
        }
        cells.push_back(which_to_look_at(outcome, row, main));
        table.rows.push_back(std::move(cells));
    }
    return table;
}

} // namespace suffuse::answer
