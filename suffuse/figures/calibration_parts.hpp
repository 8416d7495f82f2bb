#pragma once
// What the figures of a calibration share.

#include "suffuse/figures/figures_calibration.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>

namespace suffuse::figures {

inline std::string with_unit(const CalibratedParameter& parameter) {
    return parameter.unit.empty() ? parameter.name : fmt::format("{} [{}]", parameter.name, parameter.unit);
}

inline Figure calibration_figure(const char* id, const char* section, const char* title, std::string claim) {
    Figure figure;
    figure.id = id;
    figure.section = section;
    figure.title = title;
    figure.claim = std::move(claim);
    return figure;
}

inline nlohmann::json number_channel(const std::string& field, const nlohmann::json& title) {
    return {{"field", field}, {"type", "quantitative"}, {"title", title}};
}

} // namespace suffuse::figures
