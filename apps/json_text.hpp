#pragma once
// What programs read: the one JSON document of a verb.

#include "suffuse/base/diagnostics.hpp"

#include <nlohmann/json.hpp>

#include <string>

namespace suffuse::apps {

/// JSON as text; what is not UTF-8 is replaced.
std::string json_text(const nlohmann::json& json);

/// One problem of a case.
nlohmann::json problem_json(const Diagnostic& problem);

} // namespace suffuse::apps
