#include "suffuse/job/compare_calibrations.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/job/calibration_files.hpp"
#include "suffuse/job/calibration_words.hpp"
#include "suffuse/record/folder.hpp"
#include "suffuse/record/stored.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace suffuse::job {
namespace {

using nlohmann::json;

json answer_in(const std::filesystem::path& folder) {
    const std::filesystem::path file = folder / calibration_file;
    if (!std::filesystem::exists(file)) {
        throw IoError(fmt::format("{}: holds no answer yet; continue it with suffuse resume", folder.string()));
    }
    return record::read_json(file);
}

using Numbers = std::map<std::string, double>;

/// What is compared, by its words. @param units of another calibration: its own where that lacks a parameter
Numbers numbers_in(const json& answer, const json& units) {
    Numbers numbers;
    for (const auto& [key, parameter] : answer.at("parameters").items()) {
        const json& like = units.at("parameters").contains(key) ? units.at("parameters").at(key) : parameter;
        const std::string unit = like.at("unit");
        for (const auto& [name, words] :
             {std::pair("best", "likeliest"), {"low", "interval from"}, {"high", "interval to"}}) {
            numbers[fmt::format("{}, {}{}", key, words, unit.empty() ? "" : " [" + unit + "]")] =
                parameter.at(name).get<double>() / like.at("unit_size").get<double>();
        }
    }
    for (const char* kind : {"fit", "held_out"}) {
        for (const json& fit : answer.at(kind)) {
            for (const json& curve : fit.at("curves")) {
                numbers[fmt::format(
                    "{} {}: misfit of the {}", kind == std::string("fit") ? "fit" : "held out",
                    fit.at("target").get<std::string>(), quantity_in_words(curve.at("quantity"))
                )] = curve.at("relative_misfit");
            }
        }
    }
    return numbers;
}

std::vector<std::string> circumstances_of(const json& first, const json& second) {
    std::vector<std::string> all;
    for (const char* key : {"title", "soil", "seed", "particles", "complete"}) {
        if (first.at(key) != second.at(key)) {
            all.push_back(fmt::format("{}: {} and {}", key, first.at(key).dump(), second.at(key).dump()));
        }
    }
    for (const auto& [key, parameter] : first.at("parameters").items()) {
        if (const auto other = second.at("parameters").find(key); other != second.at("parameters").end()) {
            const bool is_apart = parameter.at("high").get<double>() < other->at("low").get<double>() ||
                                  other->at("high").get<double>() < parameter.at("low").get<double>();
            if (is_apart) {
                all.push_back(fmt::format("{}: the intervals do not overlap", key));
            }
        }
    }
    return all;
}

record::Difference only_in_one(const std::string& where, bool is_first) {
    return {where, is_first ? "there" : "missing", is_first ? "missing" : "there", 1, record::Relevance::Presence};
}

} // namespace

record::Comparison
compare_calibrations(const std::filesystem::path& first, const std::filesystem::path& second, double tolerance) {
    const json one = answer_in(first), other = answer_in(second);
    record::Comparison found;
    record::take_from(first / calibration_file, [&] {
        found.circumstances = circumstances_of(one, other);
        const Numbers mine = numbers_in(one, one), others = numbers_in(other, one);
        for (const auto& [where, value] : mine) {
            const auto twin = others.find(where);
            if (twin == others.end()) {
                found.differences.push_back(only_in_one(where, true));
                continue;
            }
            ++found.numbers;
            const double larger = std::max(std::abs(value), std::abs(twin->second));
            const double relative = larger > 0 ? std::abs(value - twin->second) / larger : 0;
            if (relative > tolerance) {
                found.differences.push_back(
                    {where, fmt::format("{}", value), fmt::format("{}", twin->second), relative,
                     record::Relevance::Result, true}
                );
            }
        }
        for (const auto& [where, value] : others) {
            if (!mine.contains(where)) {
                found.differences.push_back(only_in_one(where, false));
            }
        }
    });
    std::ranges::stable_sort(found.differences, [](const auto& a, const auto& b) {
        return a.about != b.about ? a.about < b.about : a.relative > b.relative;
    });
    return found;
}

} // namespace suffuse::job
