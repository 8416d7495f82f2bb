#pragma once
// What happened in a run, read from events.jsonl as it grows.

#include <nlohmann/json.hpp>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace suffuse::apps {

class EventLog {
public:
    explicit EventLog(const std::filesystem::path& run) : path_(run / "events.jsonl") {}

    /// Events that came since the last call; a line that is not complete yet waits for the next one.
    std::vector<nlohmann::json> read_new();

private:
    std::filesystem::path path_;
    std::streamoff read_ = 0; ///< bytes
};

/// "10:27:00  stage done  replay/settled, 0.3 s": an event as a line for people.
std::string event_line(const nlohmann::json& event);

} // namespace suffuse::apps
