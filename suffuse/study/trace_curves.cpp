#include "suffuse/study/trace_curves.hpp"

#include "suffuse/casefile/sweep_value.hpp"
#include "suffuse/study/fines_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace suffuse::study {
namespace {

using nlohmann::json;

/// All numbers of a stage, those of inner objects by joined names. Lists are no single numbers.
void collect_numbers(const json& from, const std::string& prefix, std::map<std::string, double>& numbers) {
    for (const auto& [key, value] : from.items()) {
        if (value.is_number()) {
            numbers[prefix + key] = value.get<double>();
        } else if (value.is_object()) {
            collect_numbers(value, prefix + key + ".", numbers);
        }
    }
}

/// The samples of one stage at one set of values.
struct Gathered {
    SweepPoint point;
    std::vector<std::map<std::string, double>> of_seed;
};

SweepPoint summed_up(Gathered gathered) {
    std::set<std::string> names;
    for (const auto& numbers : gathered.of_seed) {
        for (const auto& [name, value] : numbers) {
            names.insert(name);
        }
    }
    for (const std::string& name : names) {
        std::vector<double> values;
        for (const auto& numbers : gathered.of_seed) {
            const auto found = numbers.find(name);
            values.push_back(found == numbers.end() ? std::nan("") : found->second);
        }
        gathered.point.number[name] = scatter_of(std::move(values));
    }
    return std::move(gathered.point);
}

StageCurve
trace_stage(const casefile::Study& study, const std::string& name, const std::vector<record::FinishedStage>& stages) {
    std::vector<Gathered> gathered;
    for (const record::FinishedStage& stage : stages) {
        if (stage.study != &study || stage.stage->name != name) {
            continue;
        }
        SweepPoint point = point_of(study, *stage.variant);
        auto place = std::find_if(gathered.begin(), gathered.end(), [&](const Gathered& other) {
            return other.point.written == point.written;
        });
        if (place == gathered.end()) {
            place = gathered.insert(gathered.end(), {std::move(point), {}});
        }
        place->point.seed.push_back(stage.variant->seed);
        json numbers = stage.numbers;
        numbers.erase("checksums"); // how many files a stage left is no result
        collect_numbers(numbers, "", place->of_seed.emplace_back());
    }
    StageCurve curve{name, {}};
    for (Gathered& one : gathered) {
        curve.points.push_back(summed_up(std::move(one)));
    }
    std::stable_sort(curve.points.begin(), curve.points.end(), comes_before);
    return curve;
}

std::vector<std::string> keys_of(const casefile::Study& study) {
    std::vector<std::string> keys;
    for (const casefile::Sweep& sweep : study.sweep) {
        keys.push_back(sweep.key);
    }
    return keys;
}

json values_json(const std::vector<std::string>& keys, const SweepPoint& point) {
    json values = json::object();
    for (std::size_t k = 0; k < keys.size(); ++k) {
        values[keys[k]] = std::isnan(point.value[k]) ? json(point.written[k]) : json(point.value[k]);
    }
    for (const auto& [key, value] : point.of_row) {
        const std::optional<Quantity> quantity = casefile::quantity_of(value);
        values[key] = quantity ? json(quantity->value) : json(casefile::written(value));
    }
    return values;
}

json point_json(const StudyCurves& study, const SweepPoint& point) {
    json numbers = json::object();
    for (const auto& [name, scatter] : point.number) {
        numbers[name] = scatter_json(scatter);
    }
    return {{"values", values_json(study.keys, point)}, {"seeds", point.seed}, {"numbers", numbers}};
}

} // namespace

bool comes_before(const SweepPoint& a, const SweepPoint& b) {
    for (std::size_t k = 0; k < a.value.size(); ++k) {
        const bool is_word_a = std::isnan(a.value[k]), is_word_b = std::isnan(b.value[k]);
        if (is_word_a != is_word_b) {
            return is_word_b;
        }
        if (!is_word_a && a.value[k] != b.value[k]) {
            return a.value[k] < b.value[k];
        }
        if (is_word_a && a.written[k] != b.written[k]) {
            return a.written[k] < b.written[k];
        }
    }
    return false;
}

SweepPoint point_of(const casefile::Study& study, const casefile::Variant& variant) {
    SweepPoint point;
    for (const casefile::Sweep& sweep : study.sweep) {
        const casefile::Scalar& value = variant.values.at(sweep.key);
        const std::optional<Quantity> quantity = casefile::quantity_of(value);
        point.value.push_back(quantity ? quantity->value : std::nan(""));
        point.written.push_back(casefile::written(value));
    }
    for (const casefile::Sweep& column : study.rows) {
        point.of_row[column.key] = variant.values.at(column.key);
    }
    return point;
}

std::vector<StudyCurves> trace_curves(const casefile::Case& what, const std::vector<record::FinishedStage>& stages) {
    std::vector<StudyCurves> studies;
    for (const casefile::Study& study : what.studies) {
        StudyCurves curves{study.name, keys_of(study), study.replicates, {}};
        for (const casefile::Stage& stage : study.stages) {
            curves.stages.push_back(trace_stage(study, stage.name, stages));
        }
        studies.push_back(std::move(curves));
    }
    return studies;
}

std::vector<std::string> sweep_values(const casefile::Study& study, const casefile::Variant& variant) {
    return point_of(study, variant).written;
}

bool is_behind(
    const record::FinishedStage& stage, const casefile::Study& study, const casefile::Stage& of, const SweepPoint& point
) {
    return stage.study == &study && stage.stage->name == of.name &&
           sweep_values(study, *stage.variant) == point.written;
}

std::string values_name(const std::vector<std::string>& keys, const SweepPoint& point) {
    std::string name;
    for (std::size_t k = 0; k < keys.size(); ++k) {
        name += name.empty() ? "" : ", ";
        name += keys[k] == "fines_content" ? "FC " + percent_name(point.value[k])
                                           : key_in_words(keys[k], keys) + " " + point.written[k];
    }
    return name;
}

std::string values_name(const casefile::Study& study, const casefile::Variant& variant) {
    return values_name(keys_of(study), point_of(study, variant));
}

std::string in_words(const record::FinishedStage& stage) {
    const std::string values = values_name(*stage.study, *stage.variant);
    return fmt::format("{}, {}{}{}", stage.study->name, stage.stage->name, values.empty() ? "" : ", ", values);
}

std::string in_words_of_sample(const record::FinishedStage& stage) {
    const bool is_only = stage.study->replicates == 1;
    return in_words(stage) + (is_only ? "" : fmt::format(", sample {}", stage.variant->replicate));
}

json values_json(const casefile::Study& study, const casefile::Variant& variant) {
    return values_json(keys_of(study), point_of(study, variant));
}

json scatter_json(const Scatter& value) {
    if (value.seeds == 0) {
        return nullptr;
    }
    return {{"mean", value.mean}, {"standard_deviation", value.standard_deviation}, {"of_seed", value.of_seed}};
}

json curves_json(const std::vector<StudyCurves>& studies) {
    json all = json::object();
    for (const StudyCurves& study : studies) {
        json stages = json::object();
        for (const StageCurve& curve : study.stages) {
            json points = json::array();
            for (const SweepPoint& point : curve.points) {
                points.push_back(point_json(study, point));
            }
            stages[curve.stage] = points;
        }
        all[study.study] = {{"swept", study.keys}, {"replicates", study.replicates}, {"stages", stages}};
    }
    return all;
}

} // namespace suffuse::study
