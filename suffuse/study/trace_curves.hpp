#pragma once
// From finished stages to curves over the sweep of their study.

#include "suffuse/record/finished_stage.hpp"
#include "suffuse/study/study_curves.hpp"

namespace suffuse::study {

/// One for each study, over all its samples that are there; points in the order of their values, numbers before words.
std::vector<StudyCurves> trace_curves(const casefile::Case& what, const std::vector<record::FinishedStage>& stages);

/// Of a sample: its values of the study's swept keys.
SweepPoint point_of(const casefile::Study& study, const casefile::Variant& variant);

/// In the order of the values, numbers before words.
bool comes_before(const SweepPoint& a, const SweepPoint& b);

/// Values of the study's swept keys, as written in the case.
std::vector<std::string> sweep_values(const casefile::Study& study, const casefile::Variant& variant);

/// Whether a sample's stage is one of the seeds behind this point of the stage's curve.
bool is_behind(
    const record::FinishedStage& stage, const casefile::Study& study, const casefile::Stage& of, const SweepPoint& point
);

/// "FC 10 %", "gradient 0.1, friction 30 deg"; empty without a sweep.
std::string values_name(const std::vector<std::string>& keys, const SweepPoint& point);
std::string values_name(const casefile::Study& study, const casefile::Variant& variant);

/// "orders, removed, order random": a stage in words, the same of all its seeds, where name() is a place in the folder.
std::string in_words(const record::FinishedStage& stage);

/// With ", sample 2" behind it where the study has several.
std::string in_words_of_sample(const record::FinishedStage& stage);

/// As in summary.json: key -> value in SI, words as they are.
nlohmann::json values_json(const casefile::Study& study, const casefile::Variant& variant);

/// As in summary.json: mean, standard_deviation, of_seed; null where no seed has the number.
nlohmann::json scatter_json(const Scatter& value);

/// As in summary.json: study -> keys, replicates, stages -> points.
nlohmann::json curves_json(const std::vector<StudyCurves>& studies);

} // namespace suffuse::study
