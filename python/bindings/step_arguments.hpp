#pragma once
// Arguments of every function of a World that makes steps: mode, damping, time step.

#include "suffuse/base/error.hpp"
#include "suffuse/dem/settle.hpp"

#include <fmt/format.h>

#include "python/bindings/convert.hpp"
#include "python/bindings/key_value.hpp"
#include "python/bindings/world_handle.hpp"
#include <optional>
#include <string>

namespace suffuse::python {

inline constexpr const char* usual_mode = "reference";

inline dem::Mode mode_of(const std::string& word) {
    for (const dem::Mode mode : {dem::Mode::Reference, dem::Mode::Fast}) {
        if (word == dem::name_of(mode)) {
            return mode;
        }
    }
    throw CaseError(fmt::format("mode: found \"{}\", expected reference or fast", word));
}

inline double damping_of(const py::object& value) {
    return value_of(key_of("contact", "damping"), value, "damping");
}

/// Nothing where it is to be computed. @throws CaseError where it is beyond what the sample can take
inline std::optional<double> time_step_of(const py::object& value, double damping, Stepping& call) {
    if (py::isinstance<py::str>(value) && value.cast<std::string>() == "computed") {
        return std::nullopt;
    }
    const auto given = optional_value_of(key_of("stage.advance", "time_step"), value, "time_step");
    if (given) {
        call.check_time_step(*given, damping);
    }
    return given;
}

} // namespace suffuse::python
