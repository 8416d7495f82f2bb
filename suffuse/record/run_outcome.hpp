#pragma once
// How a run ended, and which of its samples could not be run to their end.

#include <nlohmann/json.hpp>

#include <string>
#include <string_view>

namespace suffuse::record {

enum class Outcome {
    Done,
    DoneWithFlaws, ///< ran, but a quality bar was missed; the results say which
    SomeFailed,    ///< the samples in `failures` failed; the others ran
    Stopped,       ///< by `stop`
    TimeLimit,
};

/// "done", "stopped": as events and documents say it.
constexpr std::string_view word_of(Outcome outcome) {
    switch (outcome) {
    case Outcome::Done:
        return "done";
    case Outcome::DoneWithFlaws:
        return "done with flaws";
    case Outcome::SomeFailed:
        return "failed in part";
    case Outcome::Stopped:
        return "stopped";
    case Outcome::TimeLimit:
        break;
    }
    return "time limit reached";
}

/// Whether the run would go on where it was left.
constexpr bool is_resumable(Outcome outcome) {
    return outcome == Outcome::Stopped || outcome == Outcome::TimeLimit;
}

/// A sample that could not be run to its end.
struct FailedSample {
    std::string sample;  ///< its folder below studies/
    std::string stage;   ///< where it failed
    std::string kind;    ///< "run", "case", "io" or "memory"
    std::string message; ///< what went wrong and what to do
};

/// As summary.json and the program's documents list it.
void to_json(nlohmann::json& json, const FailedSample& failure);

} // namespace suffuse::record
