#include "suffuse/study/study_curves.hpp"

#include "suffuse/base/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace suffuse::study {

Scatter scatter_of(std::vector<double> of_seed) {
    Scatter scatter;
    double sum = 0;
    for (const double value : of_seed) {
        if (std::isfinite(value)) {
            sum += value;
            ++scatter.seeds;
        }
    }
    scatter.mean = scatter.seeds > 0 ? sum / scatter.seeds : std::nan("");
    double squares = 0;
    for (const double value : of_seed) {
        squares += std::isfinite(value) ? (value - scatter.mean) * (value - scatter.mean) : 0;
    }
    scatter.standard_deviation = scatter.seeds > 1 ? std::sqrt(squares / (scatter.seeds - 1)) : 0;
    scatter.of_seed = std::move(of_seed);
    return scatter;
}

bool agree(const Scatter& scatter) {
    double least = INFINITY, most = -INFINITY;
    for (const double value : scatter.of_seed) {
        if (std::isfinite(value)) {
            least = std::min(least, value), most = std::max(most, value);
        }
    }
    return scatter.seeds > 1 && least == most;
}

std::string with_scatter(const Scatter& value, double factor, int digits) {
    if (value.seeds == 0) {
        return "–";
    }
    const double mean = factor * value.mean, deviation = factor * value.standard_deviation;
    if (value.seeds < 2 || deviation <= 1e-3 * std::abs(mean)) {
        return short_number(mean, digits);
    }
    const double known_to = std::pow(10, std::floor(std::log10(deviation)) - 1);
    return short_number(known_to * std::round(mean / known_to), digits) + " ± " + short_number(deviation, 2);
}

std::string seeds_that_have(const Scatter& scatter) {
    const auto all_seeds = std::ssize(scatter.of_seed);
    return scatter.seeds == all_seeds ? "" : fmt::format(", in {} of {} seeds", scatter.seeds, all_seeds);
}

std::string key_in_words(const std::string& key, const std::vector<std::string>& keys) {
    const auto last_of = [](const std::string& path) { return path.substr(path.rfind('.') + 1); };
    const bool is_alone = std::ranges::none_of(keys, [&](const std::string& other) {
        return other != key && last_of(other) == last_of(key);
    });
    std::string word = is_alone ? last_of(key) : key;
    std::ranges::replace(word, '_', ' ');
    return word;
}

const StageCurve* StudyCurves::find(const std::string& stage) const {
    const auto found =
        std::find_if(stages.begin(), stages.end(), [&](const StageCurve& c) { return c.stage == stage; });
    return found == stages.end() ? nullptr : &*found;
}

} // namespace suffuse::study
