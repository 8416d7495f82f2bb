#include "apps/event_log.hpp"

#include "suffuse/base/amounts.hpp"
#include "suffuse/base/spelling.hpp"
#include "suffuse/io/own_file.hpp"
#include "suffuse/record/documents.hpp"

#include <fmt/format.h>

#include "apps/wording.hpp"
#include <fstream>

namespace suffuse::apps {

std::vector<nlohmann::json> EventLog::read_new() {
    std::vector<nlohmann::json> events;
    io::require_regular(path_);
    std::ifstream file(path_, std::ios::binary);
    file.seekg(read_);
    for (std::string line; std::getline(file, line) && !file.eof();) { // at the end of the file the line has no end yet
        read_ += static_cast<std::streamoff>(line.size()) + 1;
        nlohmann::json event = record::parse_json(line);
        if (event.is_object()) {
            events.push_back(std::move(event));
        }
    }
    return events;
}

std::string event_line(const nlohmann::json& event) {
    const auto text = [&](const char* key) {
        return event.contains(key) && event.at(key).is_string() ? event.at(key).get<std::string>() : std::string();
    };
    const std::string at = text("at"); // 2026-11-21T10:27:00Z
    const std::string clock = at.size() == 20 ? at.substr(0, 10) + " " + at.substr(11, 8) : at;
    std::string rest;
    for (const char* key : {"stage", "sample", "outcome", "what", "message"}) {
        if (const std::string value = text(key); !value.empty()) {
            rest += (rest.empty() ? "" : " ") + shown(value);
        }
    }
    if (event.contains("wall_seconds") && event.at("wall_seconds").is_number()) {
        rest += (rest.empty() ? "" : ", ") + duration_text(event.at("wall_seconds"));
    }
    return rest.empty() ? fmt::format("{}  {}", clock, text("event"))
                        : fmt::format("{}  {:17} {}", clock, text("event"), rest);
}

} // namespace suffuse::apps
