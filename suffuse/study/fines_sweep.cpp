#include "suffuse/study/fines_sweep.hpp"

#include "suffuse/study/study_outcome.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace suffuse::study {
namespace {

constexpr const char* fines_key = "fines_content";

const packing::CompactSpec* compaction(const casefile::Stage& stage) {
    return std::get_if<packing::CompactSpec>(&stage.spec);
}

std::string loose_stage(const casefile::Study& study) {
    const casefile::Stage *first = nullptr, *first_rough = nullptr;
    for (const casefile::Stage& stage : study.stages) {
        const packing::CompactSpec* spec = compaction(stage);
        if (spec != nullptr && spec->prepare.adhesion_normal.value_or(0) > 0) {
            return stage.name;
        }
        first = first == nullptr && spec != nullptr ? &stage : first;
        first_rough = first_rough == nullptr && spec != nullptr && !spec->prepare.friction ? &stage : first_rough;
    }
    const casefile::Stage* loose = first_rough != nullptr ? first_rough : first;
    return loose == nullptr ? std::string{} : loose->name;
}

bool is_for_some_contents(const casefile::Stage& stage) {
    return std::ranges::any_of(stage.only, [](const casefile::Sweep& only) { return only.key == fines_key; });
}

std::vector<std::string>
stages_of_loose_state(const casefile::Study& study, const std::string& loose, const std::string& dense) {
    std::vector<std::string> names = {loose};
    const auto first = std::ranges::find(study.stages, loose, &casefile::Stage::name);
    if (first == study.stages.end() || !is_for_some_contents(*first)) {
        return names;
    }
    for (const casefile::Stage& stage : study.stages) {
        if (stage.name != loose && stage.name != dense && compaction(stage) != nullptr && is_for_some_contents(stage)) {
            names.push_back(stage.name);
        }
    }
    return names;
}

std::string densest_stage(const casefile::Study& study, const std::string& loose) {
    const casefile::Stage* densest = nullptr;
    const auto friction = [](const casefile::Stage& stage) { return *compaction(stage)->prepare.friction; };
    for (const casefile::Stage& stage : study.stages) {
        const packing::CompactSpec* spec = compaction(stage);
        if (spec != nullptr && spec->prepare.friction && stage.name != loose &&
            (densest == nullptr || friction(stage) < friction(*densest))) {
            densest = &stage;
        }
    }
    return densest == nullptr ? std::string{} : densest->name;
}

} // namespace

StageCurve sweep_points(const FinesSweep& sweep, const std::string& stage) {
    const StageCurve* all = sweep.traced.find(stage);
    StageCurve curve{stage, {}};
    if (all == nullptr) {
        return curve;
    }
    for (const SweepPoint& point : all->points) {
        bool is_along = true;
        for (std::size_t k = 0; k < point.written.size(); ++k) {
            is_along = is_along && (k == sweep.key || point.written[k] == all->points.front().written[k]);
        }
        if (is_along) {
            curve.points.push_back(point);
        }
    }
    return curve;
}

std::string other_values(const FinesSweep& sweep) {
    std::string words;
    if (const StageCurve* const loose = sweep.traced.find(sweep.loose); loose != nullptr && !loose->points.empty()) {
        for (std::size_t k = 0; k < sweep.traced.keys.size(); ++k) {
            if (k != sweep.key) {
                words += fmt::format(
                    "{}{} {}", words.empty() ? "" : ", ", key_in_words(sweep.traced.keys[k], sweep.traced.keys),
                    loose->points.front().written[k]
                );
            }
        }
    }
    return words;
}

StageCurve loose_points(const FinesSweep& sweep) {
    StageCurve curve{sweep.loose, {}};
    for (const std::string& stage : sweep.loose_stages) {
        for (SweepPoint& point : sweep_points(sweep, stage).points) {
            const bool is_known = std::ranges::any_of(curve.points, [&](const SweepPoint& known) {
                return known.value[sweep.key] == point.value[sweep.key];
            });
            if (!is_known) {
                curve.points.push_back(std::move(point));
            }
        }
    }
    std::ranges::stable_sort(curve.points, std::less{}, [&](const SweepPoint& p) { return p.value[sweep.key]; });
    return curve;
}

const casefile::Stage* loose_test(const FinesSweep& sweep) {
    for (const casefile::Stage& stage : sweep.study->stages) {
        const auto* spec = std::get_if<triaxial::TriaxialSpec>(&stage.spec);
        if (spec != nullptr && spec->path == triaxial::Path::Drained && stage.parent >= 0 &&
            std::ranges::count(sweep.loose_stages, sweep.study->stages[static_cast<std::size_t>(stage.parent)].name) >
                0) {
            return &stage;
        }
    }
    return nullptr;
}

std::optional<FinesSweep> find_fines_sweep(const casefile::Case& what, const std::vector<StudyCurves>& traced) {
    std::optional<FinesSweep> best;
    for (std::size_t s = 0; s < traced.size(); ++s) {
        const casefile::Study& study = what.studies[s];
        const auto key = std::find(traced[s].keys.begin(), traced[s].keys.end(), fines_key);
        if (key == traced[s].keys.end()) {
            continue;
        }
        FinesSweep sweep;
        sweep.study = &study;
        sweep.loose = loose_stage(study);
        sweep.dense = densest_stage(study, sweep.loose);
        sweep.loose_stages = stages_of_loose_state(study, sweep.loose, sweep.dense);
        sweep.key = static_cast<std::size_t>(key - traced[s].keys.begin());
        sweep.traced = traced[s];
        sweep.curves.study = study.name;
        sweep.curves.loose = loose_points(sweep);
        sweep.curves.dense.stage = sweep.dense;
        // The densest state at the same fines contents, in the same order; where it is missing it has no numbers.
        const StageCurve dense = sweep_points(sweep, sweep.dense);
        for (const SweepPoint& point : sweep.curves.loose.points) {
            sweep.curves.fines_content.push_back(point.value[sweep.key]);
            const auto same = std::find_if(dense.points.begin(), dense.points.end(), [&](const auto& other) {
                return other.value[sweep.key] == point.value[sweep.key];
            });
            if (!dense.points.empty()) {
                sweep.curves.dense.points.push_back(same == dense.points.end() ? SweepPoint{} : *same);
            }
        }
        if (!sweep.curves.loose.points.empty() &&
            (!best || sweep.curves.loose.points.size() > best->curves.loose.points.size())) {
            best = std::move(sweep);
        }
    }
    return best;
}

} // namespace suffuse::study
