#pragma once
// cpp-httplib, and what all answers have in common.

#include <nlohmann/json.hpp>

#include <httplib.h>
#include <stdexcept>
#include <string>

namespace suffuse::studio {

/// A request that is refused, with its HTTP status and a sentence for the user.
struct Refusal : std::runtime_error {
    Refusal(int http_status, const std::string& sentence) : std::runtime_error(sentence), status(http_status) {}

    int status;
};

inline void answer(httplib::Response& response, int status, const nlohmann::json& document) {
    response.status = status;
    response.set_content(
        document.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace), "application/json; charset=utf-8"
    );
}

inline void refuse(httplib::Response& response, int status, const std::string& sentence) {
    answer(response, status, {{"error", {{"message", sentence}}}});
}

} // namespace suffuse::studio
