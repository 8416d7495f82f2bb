#include "apps/json_text.hpp"

namespace suffuse::apps {

std::string json_text(const nlohmann::json& json) {
    return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace);
}

nlohmann::json problem_json(const Diagnostic& problem) {
    return {{"code", problem.code},     {"kind", problem.is_warning ? "warning" : "error"},
            {"file", problem.file},     {"line", problem.line},
            {"column", problem.column}, {"message", problem.message},
            {"help", problem.help}};
}

} // namespace suffuse::apps
