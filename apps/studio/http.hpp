#pragma once
// cpp-httplib, and what all answers have in common.

#include <nlohmann/json.hpp>

#include <cstddef>
#include <httplib.h>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

namespace suffuse::studio {

/// A request that is refused, with its HTTP status and a sentence for the user.
struct Refusal : std::runtime_error {
    Refusal(int http_status, const std::string& sentence) : std::runtime_error(sentence), status(http_status) {}

    int status;
};

/// Content without the library's compression, which takes seconds for a report and saves nothing within one machine.
inline void set_plain_content(httplib::Response& response, std::string content, const char* type) {
    const auto kept = std::make_shared<const std::string>(std::move(content));
    if (kept->empty()) {
        response.set_content("", type);
        return;
    }
    response.set_content_provider(
        kept->size(), type,
        [kept](std::size_t offset, std::size_t length, httplib::DataSink& sink) {
            return sink.write(kept->data() + offset, length);
        }
    );
}

inline void answer(httplib::Response& response, int status, const nlohmann::json& document) {
    constexpr int first_error = 400;
    const char* const type = "application/json; charset=utf-8";
    std::string text = document.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    response.status = status;
    if (status < first_error) {
        set_plain_content(response, std::move(text), type);
    } else {
        response.set_content(text, type); // short, and seen by the handler of errors
    }
}

inline void refuse(httplib::Response& response, int status, const std::string& sentence) {
    answer(response, status, {{"error", {{"message", sentence}}}});
}

} // namespace suffuse::studio
