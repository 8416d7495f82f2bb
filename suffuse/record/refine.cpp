#include "suffuse/record/refine.hpp"

#include "suffuse/casefile/load_case.hpp"
#include "suffuse/casefile/refine.hpp"
#include "suffuse/casefile/sweep_value.hpp"
#include "suffuse/casefile/variants.hpp"
#include "suffuse/record/folder.hpp"
#include "suffuse/record/stored.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace suffuse::record {
namespace {

using casefile::Scalar;
using casefile::Study;
using casefile::Variant;
using nlohmann::json;
using Values = std::map<std::string, Scalar>;

/// What helps where the case that a run was begun with is refused now.
std::string what_to_do(const Diagnostic& problem, const std::filesystem::path& run) {
    if (problem.code == "E501") {
        const std::string began_with = case_that_began(run);
        return began_with.empty() ? ""
                                  : fmt::format("; the run began with {}: restore the file that it names", began_with);
    }
    return "; the run began with a version of suffuse that took this: " +
           (problem.code == "E407"
                ? fmt::format(
                      "remove the word from {} and call again; the stage never measured it, so nothing else changes",
                      problem.file
                  )
                : fmt::format("correct {} and call again, or start a new run", problem.file));
}

json scalar_json(const Scalar& value) {
    return std::visit([](const auto& held) { return json(held); }, value);
}

Scalar scalar_of(const json& value) {
    if (value.is_boolean()) {
        return value.get<bool>();
    }
    if (value.is_number_integer()) {
        return value.get<std::int64_t>();
    }
    return value.is_number() ? Scalar(value.get<double>()) : Scalar(value.get<std::string>());
}

/// One point of a curve.
struct Point {
    Scalar value;
    double size = 0; ///< of the value, in SI
    double sum = 0;  ///< of the number, over the seeds
    int seeds = 0;
};

/// "contact_share.LS" of a stage.
std::optional<double> number_at(json numbers, const std::string& name) {
    for (std::size_t begin = 0; begin <= name.size();) {
        const std::size_t end = std::min(name.find('.', begin), name.size());
        const std::string key = name.substr(begin, end - begin);
        if (!numbers.is_object() || !numbers.contains(key)) {
            return std::nullopt;
        }
        numbers = json(numbers.at(key));
        begin = end + 1;
    }
    return numbers.is_number() ? std::optional(numbers.get<double>()) : std::nullopt;
}

/// The curves of one stage, one for each combination of the other swept keys, by size; nothing where a sample is
/// missing. Values at which the stage has no such number are left out.
std::optional<std::map<Values, std::vector<Point>>>
trace(const Study& study, const std::string& stage_name, const std::filesystem::path& run) {
    std::map<Values, std::vector<Point>> curves;
    const std::size_t listed = casefile::count_variants(study); // those that were refined before stand behind
    for (std::size_t k = 0; k < std::min(listed, study.variants.size()); ++k) {
        const Variant& variant = study.variants[k];
        const auto stage = std::find_if(variant.stages.begin(), variant.stages.end(), [&](const casefile::Stage& s) {
            return s.name == stage_name;
        });
        if (stage == variant.stages.end()) {
            continue; // not run for these values
        }
        const std::filesystem::path file = stage_folder(run, variant, *stage) / "stage.json";
        if (!std::filesystem::exists(file)) {
            return std::nullopt;
        }
        Values others = variant.values;
        const Scalar value = others.at(study.refine->key);
        others.erase(study.refine->key);
        if (const std::optional<double> number = number_at(read_json(file), study.refine->of)) {
            std::vector<Point>& curve = curves[others];
            auto point = std::find_if(curve.begin(), curve.end(), [&](const Point& p) { return p.value == value; });
            if (point == curve.end()) {
                point = curve.insert(curve.end(), {value, casefile::quantity_of(value).value().value, 0, 0});
            }
            point->sum += *number;
            ++point->seeds;
        }
    }
    for (auto& [others, curve] : curves) {
        std::sort(curve.begin(), curve.end(), [](const Point& a, const Point& b) { return a.size < b.size; });
    }
    return curves;
}

/// Values evenly between the extreme of a curve and its neighbors.
std::vector<Scalar> values_around(const std::vector<Point>& curve, std::size_t extreme, int add) {
    std::vector<Scalar> values;
    for (const std::size_t left : {extreme - 1, extreme}) {
        if (left >= curve.size() || left + 1 >= curve.size()) { // at an end of the curve
            continue;
        }
        for (int k = 1; k <= add; ++k) {
            values.push_back(
                casefile::value_between(curve[left].value, curve[left + 1].value, static_cast<double>(k) / (add + 1))
            );
        }
    }
    return values;
}

void refine_stage(
    const Study& study, const std::string& stage, const std::map<Values, std::vector<Point>>& curves,
    std::vector<Refinement>& found
) {
    const casefile::Refine& refine = *study.refine;
    for (const auto& [others, curve] : curves) {
        const auto is_lower = [&](const Point& a, const Point& b) {
            const double x = a.sum / a.seeds, y = b.sum / b.seeds;
            return refine.maximum ? x > y : x < y;
        };
        const auto extreme =
            static_cast<std::size_t>(std::min_element(curve.begin(), curve.end(), is_lower) - curve.begin());
        for (const Scalar& value : values_around(curve, extreme, refine.add)) {
            Refinement one{study.name, others, {}};
            one.values[refine.key] = value;
            one.reason = fmt::format(
                "{} of {} is {} at {} = {}", refine.of, stage, refine.maximum ? "highest" : "lowest", refine.key,
                casefile::written(curve[extreme].value)
            );
            const bool is_new = std::none_of(found.begin(), found.end(), [&](const Refinement& other) {
                return other.study == one.study && other.values == one.values;
            });
            if (is_new) {
                found.push_back(std::move(one));
            }
        }
    }
}

/// A case of a run folder has its refined samples already.
void add_unknown(Study& study, std::vector<Variant> more) {
    for (Variant& variant : more) {
        const bool is_known = std::any_of(study.variants.begin(), study.variants.end(), [&](const Variant& known) {
            return known.folder == variant.folder;
        });
        if (!is_known) {
            study.variants.push_back(std::move(variant));
        }
    }
}

/// @param list of refinement.json
casefile::Case with_listed(casefile::Case what, const json& list) {
    const casefile::Case listed = what;
    for (const json& one : list) {
        Values values;
        for (const auto& [key, value] : one.at("values").items()) {
            values[key] = scalar_of(value);
        }
        const std::string name = one.at("study");
        for (Study& study : what.studies) {
            if (study.name == name) {
                add_unknown(study, casefile::variants_at(listed, name, values));
            }
        }
    }
    return what;
}

} // namespace

std::vector<Refinement> find_refinements(const casefile::Case& what, const std::filesystem::path& run) {
    std::vector<Refinement> found;
    for (const Study& study : what.studies) {
        if (!study.refine) {
            continue;
        }
        for (const std::string& stage : study.refine->at) {
            if (const auto curves = trace(study, stage, run)) {
                refine_stage(study, stage, *curves, found);
            }
        }
    }
    return found;
}

bool add_samples(const casefile::Case& what, const std::vector<Refinement>& refinements) {
    return std::ranges::any_of(refinements, [&](const Refinement& one) {
        return std::ranges::any_of(what.studies, [&](Study study) {
            const std::size_t before = study.variants.size();
            if (study.name == one.study) {
                add_unknown(study, casefile::variants_at(what, one.study, one.values));
            }
            return study.variants.size() > before;
        });
    });
}

void keep_refinements(const std::filesystem::path& run, const std::vector<Refinement>& refinements) {
    json list = json::array();
    for (const Refinement& one : refinements) {
        json values = json::object();
        for (const auto& [key, value] : one.values) {
            values[key] = scalar_json(value);
        }
        list.push_back({{"study", one.study}, {"values", values}, {"reason", one.reason}});
    }
    write_json(run / refinement_file, list);
}

bool is_refined(const std::filesystem::path& run) {
    return !run.empty() && std::filesystem::exists(run / refinement_file);
}

casefile::Case with_refinements(casefile::Case what, const std::filesystem::path& run) {
    if (!is_refined(run)) {
        return what;
    }
    const std::filesystem::path file = run / refinement_file;
    const json list = read_json(file);
    return take_from(file, [&] { return with_listed(std::move(what), list); });
}

casefile::Case load_run(const std::filesystem::path& run) {
    try {
        return with_refinements(casefile::load_case((run / resolved_case_file).string()).value, run);
    } catch (CaseProblems& refused) { // an earlier version took it
        for (Diagnostic& problem : refused.problems) {
            if (!problem.is_warning) {
                problem.help += what_to_do(problem, run);
            }
        }
        throw CaseProblems(std::move(refused.problems));
    }
}

} // namespace suffuse::record
