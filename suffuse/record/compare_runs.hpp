#pragma once
// Two runs side by side: their cases, programs, states to the bit, numbers and figures, and what differs. Times and
// what follows from them are left out: no two runs share them.

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace suffuse::record {

/// What a difference is about; a reader cares for the first most.
enum class Relevance {
    Presence,    ///< a stage or a figure that one of the runs has not
    Result,      ///< of a stage
    Figure,      ///< numbers that are drawn
    Computation, ///< how it was reached: steps, what is left of an imbalance, rounding, the state's bits
};

struct Difference {
    std::string where;         ///< "erosion/initial: void_ratio", "figure fig11: eroded [%], row 2"
    std::string first, second; ///< in words or numbers
    double relative = 0;       ///< |a - b| / the larger of |a| and |b|; 1 for what is no number
    Relevance about = Relevance::Result;
    bool is_number = false;
};

struct Comparison {
    std::vector<std::string> circumstances; ///< what differs before any result does: case, program, seed, mode
    int same_states = 0, other_states = 0;  ///< stages that both have, to the bit
    int stages = 0;                         ///< that both have
    std::vector<std::string> only_first, only_second; ///< stages that the other has not
    int numbers = 0;                                  ///< that both have, of stages and figures
    std::vector<Difference> differences; ///< beyond the tolerance: the most relevant first, then the largest
};

/// @param tolerance relative, below which two numbers count as the same [-]; 0 also wants the states to the bit
/// @throws IoError where a folder holds no run
Comparison compare_runs(const std::filesystem::path& first, const std::filesystem::path& second, double tolerance);

void to_json(nlohmann::json& json, const Comparison& comparison);

} // namespace suffuse::record
