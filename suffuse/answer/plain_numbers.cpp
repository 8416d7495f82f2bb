#include "suffuse/answer/plain_numbers.hpp"

#include "suffuse/base/words.hpp"
#include "suffuse/flow/reynolds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace suffuse::answer {
namespace {

constexpr double in_percent = 100;
constexpr double least_percent = 0.1; // reported: one grain of a thousand
constexpr double least_change = 1e-3; // reported: of a change, less is rounding and the balance's noise
constexpr int digits_of_percent = 2;

} // namespace

std::string fixed(double value, int decimals) {
    if (!std::isfinite(value)) {
        return "–";
    }
    std::string text = fmt::format("{:.{}f}", std::abs(value), decimals);
    const bool is_zero = text.find_first_not_of("0.") == std::string::npos;
    return (value < 0 && !is_zero ? "−" : "") + text;
}

int decimals_for(double value, int digits) {
    if (!(std::abs(value) > 0) || !std::isfinite(value)) {
        return 0;
    }
    return std::clamp(digits - 1 - static_cast<int>(std::floor(std::log10(std::abs(value)))), 0, 6);
}

std::string percent_text(double share) {
    const double value = in_percent * share;
    if (!(std::abs(value) > 0)) {
        return "none";
    }
    if (std::abs(value) < least_percent / 2) {
        return fmt::format("< {} %", least_percent);
    }
    return fixed(value, std::min(1, decimals_for(value, digits_of_percent))) + " %";
}

bool is_no_change(double change) {
    return std::abs(change) < least_change / 2;
}

std::string change_text(double change) {
    if (is_no_change(change)) {
        return "none";
    }
    return (change > 0 ? "+" : "") + fixed(in_percent * change, std::min(1, decimals_for(in_percent * change, 2))) +
           " %";
}

std::string spread_text(const study::Scatter& value, double factor, int decimals) {
    const std::string deviation = fixed(factor * value.standard_deviation, decimals);
    const bool has_scatter = value.seeds > 1 && deviation.find_first_not_of("0.") != std::string::npos;
    return has_scatter ? "± " + deviation : "";
}

std::string conductivity_text(double permeability, const flow::Fluid& fluid) {
    constexpr double milli = 1e-3, micro = 1e-6;
    const double speed = flow::conductivity(permeability, fluid);
    if (!(speed > 0)) {
        return "none";
    }
    const auto in = [&](double unit, const char* name) {
        return fixed(speed / unit, decimals_for(speed / unit, 2)) + " " + name;
    };
    return speed >= 1 ? in(1, "m/s") : speed >= milli / 100 ? in(milli, "mm/s") : in(micro, "µm/s");
}

std::string permeability_text(double permeability) {
    std::string text = number_with_power(permeability, 2);
    const std::string dot = "·", times = " × ";
    if (const std::size_t at = text.find(dot); at != std::string::npos) {
        text.replace(at, dot.size(), times);
    }
    return text + " m²";
}

std::string count_in_words(std::size_t count) {
    constexpr std::array<const char*, 10> words = {"no",   "one", "two",   "three", "four",
                                                   "five", "six", "seven", "eight", "nine"};
    return count < words.size() ? words[count] : std::to_string(count);
}

} // namespace suffuse::answer
