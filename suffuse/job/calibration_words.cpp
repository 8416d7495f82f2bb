#include "suffuse/job/calibration_words.hpp"

#include "suffuse/base/amounts.hpp"
#include "suffuse/base/words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <utility>

namespace suffuse::job {
namespace {

using nlohmann::json;

constexpr std::size_t most_in_sentence = 4; // parameters
constexpr double large_misfit = 0.1;        // of the largest measured value
constexpr double many_failed = 0.25;        // of the samples

std::string unit_in_words(const json& parameter) {
    const std::string unit = parameter.at("unit");
    return unit.empty() ? "" : unit == "deg" ? "°" : " " + unit;
}

std::string digits_of(const json& parameter, double value) {
    return short_number(value / parameter.at("unit_size").get<double>(), 3);
}

/// "a, b and c"
std::string listed(const std::vector<std::string>& names, std::string_view before_last = "and") {
    return names.size() < 2
               ? fmt::format("{}", fmt::join(names, ""))
               : fmt::format("{} {} {}", fmt::join(names.begin(), names.end() - 1, ", "), before_last, names.back());
}

struct WorstFit {
    std::string target, quantity;
    double misfit = 0;
};

WorstFit worst_fit(const json& calibration) {
    WorstFit worst;
    for (const json& fit : calibration.at("fit")) {
        for (const json& curve : fit.at("curves")) {
            if (const double misfit = curve.at("relative_misfit"); misfit > worst.misfit) {
                worst = {fit.at("target"), curve.at("quantity"), misfit};
            }
        }
    }
    return worst;
}

} // namespace

std::string key_in_words(const std::string& key) {
    const std::string void_ratio = "void_ratio.", contact = "contact.";
    std::string text = key;
    if (key.starts_with(void_ratio)) {
        return fmt::format("void ratio of {}", key.substr(void_ratio.size()));
    }
    if (key.starts_with(contact)) {
        text = key.substr(contact.size());
    }
    std::ranges::replace(text, '_', ' ');
    return text;
}

std::string quantity_in_words(const std::string& quantity) {
    std::string text = quantity;
    std::ranges::replace(text, '_', ' ');
    return text;
}

std::string value_in_words(const json& parameter, double value) {
    return digits_of(parameter, value) + unit_in_words(parameter);
}

std::string interval_in_words(const json& parameter) {
    return fmt::format(
        "{} to {}{}", digits_of(parameter, parameter.at("low")), digits_of(parameter, parameter.at("high")),
        unit_in_words(parameter)
    );
}

std::string_view remedy_in_words(std::string_view key) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 4> words = {{
        {"volumetric_strain", "the volumetric strain of these tests"},
        {"other_pressure", "the same test at another pressure, four times as high or a quarter"},
        {"larger_samples", "grains to the samples (`particles`): they scatter more than all else is uncertain"},
        {"oedometer", "a test of another kind, such as an oedometer test (whether it would do is not tried)"},
    }};
    const auto found = std::ranges::find(words, key, &std::pair<std::string_view, std::string_view>::first);
    return found == words.end() ? "" : found->second;
}

std::vector<std::string> verdict_of(const json& calibration) {
    std::vector<std::string> known, open;
    for (const auto& [key, parameter] : calibration.at("parameters").items()) {
        if (parameter.at("identified")) {
            known.push_back(fmt::format(
                "{} {} ({})", key_in_words(key), value_in_words(parameter, parameter.at("best")),
                interval_in_words(parameter)
            ));
        } else {
            open.push_back(key_in_words(key));
        }
    }
    std::vector<std::string> verdict;
    if (known.empty()) {
        verdict.emplace_back("These tests identify none of the parameters.");
    } else {
        if (known.size() > most_in_sentence) {
            known.resize(most_in_sentence);
            known.emplace_back("others, in the table below");
        }
        verdict.push_back(fmt::format("The tests give {}.", listed(known)));
    }
    if (!open.empty() && !known.empty()) {
        verdict.push_back(fmt::format("They do not identify {}.", listed(open, "or")));
    }
    return verdict;
}

std::vector<std::string> doubts_on(const json& calibration) {
    std::vector<std::string> doubts;
    for (const auto& [key, parameter] : calibration.at("parameters").items()) {
        if (parameter.contains("bound")) {
            const bool is_low = parameter.at("bound") == "low";
            doubts.push_back(fmt::format(
                "{} is at the {} end of its range, {}: {} it, or distrust the model.", as_sentence(key_in_words(key)),
                is_low ? "lower" : "upper", value_in_words(parameter, parameter.at("range").at(is_low ? 0 : 1)),
                is_low ? "lower" : "raise"
            ));
        }
    }
    if (const WorstFit worst = worst_fit(calibration); worst.misfit > large_misfit) {
        doubts.push_back(fmt::format(
            "The likeliest parameters miss the {} of {} by {:.0f} % of its largest value; intervals assume that the "
            "model can behave like the soil.",
            quantity_in_words(worst.quantity), worst.target, 100 * worst.misfit
        ));
    }
    int samples = 0, failed = 0;
    for (const json& round : calibration.at("rounds")) {
        samples += round.at("samples").get<int>();
        failed += round.at("failed").get<int>();
    }
    if (failed > many_failed * samples) {
        doubts.push_back(fmt::format(
            "{} of {} failed: look at their messages, and narrow the ranges.", failed, plural(samples, "sample")
        ));
    }
    doubts.resize(std::min<std::size_t>(doubts.size(), 3));
    return doubts;
}

} // namespace suffuse::job
