#include "suffuse/answer/answer_fines.hpp"

#include "suffuse/base/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

namespace suffuse::answer {
namespace {

using study::FinesStudy;
using study::number_of;
using study::percent_name;
using study::Scatter;
using study::StageCurve;
using study::with_scatter;

struct Reading {
    double fines_content = 0; ///< [-]
    Scatter value;
};

/// The points of one number that were measured, or follow from their definition.
std::vector<Reading> readings(const FinesStudy& study, const StageCurve& curve, const std::string& number) {
    std::vector<Reading> all;
    for (std::size_t k = 0; k < curve.points.size(); ++k) {
        const Scatter value = number_of(curve.points[k], study.fines_content[k], number);
        if (value.seeds > 0) {
            all.push_back({study.fines_content[k], value});
        }
    }
    return all;
}

bool is_less(const Reading& a, const Reading& b) {
    return a.value.mean < b.value.mean;
}

std::optional<Reading> at(const std::vector<Reading>& all, double fines_content) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const Reading& each) {
        return std::abs(each.fines_content - fines_content) < 1e-9;
    });
    return found == all.end() ? std::nullopt : std::optional(*found);
}

std::string conditions(const study::FinesSweep& sweep) {
    const FinesStudy& study = sweep.curves;
    const auto pressure = readings(study, study.loose, "mean_stress");
    const auto grains = readings(study, study.loose, "grains");
    if (pressure.empty() || grains.empty()) {
        return {};
    }
    const auto [fewest, most] = std::minmax_element(grains.begin(), grains.end(), is_less);
    const auto [few, many] =
        std::ranges::minmax(study.loose.points, {}, [](const study::SweepPoint& point) { return point.seed.size(); });
    const std::string seeds = (few.seed.size() == many.seed.size() ? "" : fmt::format("{} to ", few.seed.size())) +
                              fmt::format("{} {}", many.seed.size(), many.seed.size() == 1 ? "sample" : "samples");
    const std::string others = study::other_values(sweep);
    const std::string count =
        fewest->value.mean == most->value.mean
            ? grouped(std::llround(most->value.mean))
            : grouped(std::llround(fewest->value.mean)) + " to " + grouped(std::llround(most->value.mean));
    return fmt::format(
        "Question: from which fines content on do the fines of the soil “{}” carry load? {} mixtures of {} to {} "
        "fines, {} of each with {} grains, were brought to {} kPa{}{}.",
        sweep.study->variants.front().soil_name, study.fines_content.size(), percent_name(study.fines_content.front()),
        percent_name(study.fines_content.back()), seeds, count, short_number(pressure.front().value.mean / 1e3),
        study.dense.points.empty() ? "" : fmt::format(" in the states “{}” and “{}”", sweep.loose, sweep.dense),
        others.empty() ? "" : ", all at " + others
    );
}

std::string density(const FinesStudy& study) {
    const auto loose = readings(study, study.loose, "void_ratio"), dense = readings(study, study.dense, "void_ratio");
    if (loose.size() < 2) {
        return {};
    }
    const Reading least = *std::min_element(loose.begin(), loose.end(), is_less);
    const bool falls = least.fines_content > loose.front().fines_content;
    const Reading& other = falls ? loose.front() : loose.back();
    std::string text = fmt::format(
        "The void ratio of the {} {} {} at FC = {} {} its least, {}, at FC = {}",
        study::name_of_loose(study.loose, study.dense), falls ? "falls from" : "is", with_scatter(other.value),
        percent_name(other.fines_content), falls ? "to" : "and has", with_scatter(least.value),
        percent_name(least.fines_content)
    );
    if (dense.size() > 1) {
        const Reading densest = *std::min_element(dense.begin(), dense.end(), is_less);
        text += fmt::format(
            "; the densest state has its least, e_min = {}, at FC = {}", with_scatter(densest.value),
            percent_name(densest.fines_content)
        );
    }
    return text + ".";
}

std::string structure(const FinesStudy& study) {
    const auto active = readings(study, study.loose, "active_fines_fraction");
    const auto e_g = readings(study, study.loose, "intergranular_void_ratio");
    std::string text;
    const auto half = std::ranges::find_if(active, [](const Reading& each) { return each.value.mean > 0.5; });
    if (half != active.end()) {
        const auto before = at(active, 0.15) ? at(active, 0.15) : active.front();
        text = fmt::format(
            "Of the volume of the fines {} % is active at FC = {}, and more than half of it {}",
            with_scatter(before->value, 100), percent_name(before->fines_content),
            half == active.begin() ? "everywhere"
                                   : fmt::format(
                                         "from somewhere between FC = {} and {} on",
                                         percent_name(std::prev(half)->fines_content), percent_name(half->fines_content)
                                     )
        );
    }
    const auto pure = at(e_g, 0), mixed = at(e_g, 0.2);
    if (pure && mixed && pure->value.mean > 0) {
        text += fmt::format(
            "{} intergranular void ratio at FC = 20 % is {} % {} that of the sand alone",
            text.empty() ? "The" : "; the", short_number(100 * std::abs(mixed->value.mean / pure->value.mean - 1), 2),
            mixed->value.mean >= pure->value.mean ? "above" : "below"
        );
    }
    return text.empty() ? text : text + ".";
}

std::string contacts(const FinesStudy& study) {
    const auto mixed = readings(study, study.loose, "contact_share.LS"),
               strong = readings(study, study.loose, "strong_contact_share.LS");
    if (mixed.size() < 2 || strong.size() < 2) {
        return {};
    }
    const Reading most = *std::max_element(mixed.begin(), mixed.end(), is_less);
    const Reading strongest = *std::max_element(strong.begin(), strong.end(), is_less);
    return fmt::format(
        "Contacts between large and small grains are most frequent at FC = {} ({} % of all), among the strong ones at "
        "FC = {} ({} %).",
        percent_name(most.fines_content), with_scatter(most.value, 100), percent_name(strongest.fines_content),
        with_scatter(strongest.value, 100)
    );
}

std::string strength(const study::FinesSweep& sweep) {
    const casefile::Stage* test = study::loose_test(sweep);
    const study::StageCurve curve = test == nullptr ? study::StageCurve{} : study::sweep_points(sweep, test->name);
    std::vector<Reading> peaks;
    for (const study::SweepPoint& point : curve.points) {
        const auto found = point.number.find("response.peak_deviator");
        if (found != point.number.end() && found->second.seeds > 0) {
            peaks.push_back({point.value[sweep.key], found->second});
        }
    }
    if (peaks.size() < 2) {
        return {};
    }
    return fmt::format(
        "In drained compression from the {} the highest deviator stress is {} kPa at FC = {} and {} kPa at FC = {}.",
        study::name_of_loose(sweep.curves.loose, sweep.curves.dense), with_scatter(peaks.front().value, 1e-3),
        percent_name(peaks.front().fines_content), with_scatter(peaks.back().value, 1e-3),
        percent_name(peaks.back().fines_content)
    );
}

} // namespace

std::vector<std::string> answer_of_fines(const study::FinesSweep& sweep) {
    std::vector<std::string> sentences = {
        conditions(sweep), density(sweep.curves), structure(sweep.curves), contacts(sweep.curves), strength(sweep)};
    std::erase_if(sentences, [](const std::string& sentence) { return sentence.empty(); });
    return sentences;
}

std::string thresholds_sentence(const std::optional<study::FinesResults>& results) {
    if (!results || results->thresholds.empty()) {
        return "";
    }
    const auto content = [](const study::Scatter& at) {
        const std::string scatter = at.seeds > 1 ? fmt::format(" ± {:.1f}", 100 * at.standard_deviation) : "";
        return fmt::format("{:.{}f}{} %", 100 * at.mean, at.seeds > 1 ? 1 : 0, scatter) + study::seeds_that_have(at);
    };
    const auto found = [&](study::ThresholdKind kind) {
        const study::ContentThreshold* const threshold = study::find_threshold(results->thresholds, kind);
        return threshold != nullptr && threshold->at.seeds > 0 ? std::optional(content(threshold->at)) : std::nullopt;
    };
    const auto lies = [&](study::ThresholdKind lowest) {
        const auto at = found(lowest);
        return at ? "is at FC = " + *at : "cannot be placed by these fines contents";
    };
    const auto begins = [&](study::ThresholdKind onset) {
        const auto at = found(onset);
        return at ? "begin to rise at " + *at : "show no onset";
    };
    using enum study::ThresholdKind;
    std::string text = fmt::format(
        "Through {} fines contents, by a parabola at its lowest points, the least void ratio of the {} {}",
        results->loose.points.size(), study::name_of_loose(results->loose, results->dense), lies(LowestLoose)
    );
    if (!results->dense.points.empty()) {
        text += fmt::format(", that of the dense one {}", lies(LowestDense));
    }
    return text + fmt::format(
                      "; active fines {}, strong contacts between coarse and fine grains {}.", begins(ActiveFines),
                      begins(StrongContacts)
                  );
}

std::optional<figures::PageTable> thresholds_table(const std::optional<study::FinesResults>& results) {
    if (!results || results->thresholds.empty()) {
        return std::nullopt;
    }
    figures::PageTable table;
    table.section = "Fines and structure";
    table.title = "Thresholds of the fines content";
    table.note = "FC_threshold: vertex of the parabola through the lowest point of the curve and its neighbors. "
                 "FC_active: break of two straight lines through the rising part of the curve; none where a quarter of "
                 "the rise is made before it, or where the curve has too few points to one side, or too distant ones, "
                 "to locate the break. Deviations are those of the seeds; the spacing of the sweep adds to them.";
    table.header = {"threshold", "read from", "fines content [%]", "deviation [%]", "seeds"};
    table.numeric = {false, false, true, true, true};
    for (const study::ContentThreshold& threshold : results->thresholds) {
        const study::Scatter& at = threshold.at;
        table.rows.push_back(
            {threshold.name(), threshold.from(), at.seeds > 0 ? fmt::format("{:.1f}", 100 * at.mean) : "none",
             at.seeds > 1 ? fmt::format("{:.1f}", 100 * at.standard_deviation) : "", fmt::format("{}", at.seeds)}
        );
    }
    return table;
}

} // namespace suffuse::answer
