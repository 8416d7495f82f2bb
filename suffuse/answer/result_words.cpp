// How each result of a sample is called and written.
#include "suffuse/answer/headlines.hpp"
#include "suffuse/answer/plain_numbers.hpp"
#include "suffuse/base/error.hpp"
#include "suffuse/base/factor_of_safety.hpp"
#include "suffuse/study/fines_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace suffuse::answer {
using study::Result;

std::string result_label(Result which) {
    return study::scale_of(which).label;
}

bool is_none(Result which, double value) {
    switch (which) {
    case Result::ErodedMass:
    case Result::RemovedMass:
    case Result::RemovalStrain:
        return !(std::abs(value) > 0);
    case Result::StressChange:
        return is_no_change(value);
    case Result::Permeability:
        return !(value > 0);
    default:
        return false;
    }
}

std::string result_text(Result which, double value, const flow::Fluid& fluid) {
    switch (which) {
    case Result::Safety:
        return factor_text(value);
    case Result::FirstMovement:
        return fixed(value, 2);
    case Result::ErodedMass:
    case Result::RemovedMass:
    case Result::RemovalStrain:
        return percent_text(value);
    case Result::PermeabilityChange:
        return "× " + fixed(value, std::min(2, decimals_for(value, 2)));
    case Result::StressChange:
        return change_text(value);
    case Result::Strength:
        return fixed(study::scale_of(which).factor * value, 0) + " kPa";
    case Result::Permeability:
        return conductivity_text(value, fluid);
    case Result::VoidRatio:
        return fixed(value, 3);
    }
    throw Bug("a result without a text");
}

std::string mean_text(const study::OutcomePoint& point, Result which, const flow::Fluid& fluid, const char* bound) {
    return (point.is_at_most(which) ? bound : "") + result_text(which, point.find(which)->mean, fluid);
}

std::string result_spread(Result which, const study::Scatter& value, const flow::Fluid& fluid) {
    const auto of_percent = [&] {
        constexpr double in_percent = 100;
        return spread_text(value, in_percent, std::min(1, decimals_for(in_percent * value.mean, 2)));
    };
    switch (which) {
    case Result::Safety:
        return spread_text(value, 1, decimals_of_factor(value.mean));
    case Result::FirstMovement:
        return spread_text(value, 1, 2);
    case Result::ErodedMass:
    case Result::RemovedMass:
    case Result::RemovalStrain:
    case Result::StressChange:
        return of_percent();
    case Result::PermeabilityChange:
        return spread_text(value, 1, std::min(2, decimals_for(value.mean, 2)));
    case Result::Strength:
        return spread_text(value, study::scale_of(which).factor, 0);
    case Result::Permeability: {
        const bool has_scatter = value.seeds > 1 && !is_none(which, value.standard_deviation);
        return has_scatter ? "± " + conductivity_text(value.standard_deviation, fluid) : "";
    }
    case Result::VoidRatio:
        return spread_text(value, 1, 3);
    }
    throw Bug("a result without a deviation");
}

std::string value_in_words(const study::SweepPoint& at, std::size_t key) {
    std::string written = at.written.at(key);
    if (const std::string degrees = " deg"; written.ends_with(degrees)) {
        written.replace(written.size() - degrees.size(), degrees.size(), "°");
    }
    return written;
}

} // namespace suffuse::answer
