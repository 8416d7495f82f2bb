#pragma once
// The runs of a folder, each in a row: what it is, how far it came, what it found.

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace suffuse::job {

struct ListedRun {
    std::string name;                 ///< of its folder
    std::string title;                ///< of its case
    std::string state;                ///< "done", "flaws", "failed in part", "not complete", "tasks emitted", "at work"
    int samples = 0, done = 0;        ///< of its case; that reached their end
    double seconds = 0;               ///< wall time of all calls
    std::string finished;             ///< of the last call, in UTC; empty where none has ended
    std::string commit;               ///< of the program that wrote it
    std::vector<std::string> verdict; ///< as its report opens
    std::string until;                ///< the stage that its samples were to end with; empty: their last
    bool is_calibration = false;      ///< its samples are those of all rounds
};

enum class RunOrder { Finished, Name, Time, Samples, Title };

/// In this order, the newest, longest or largest first, names from A on. Folders that hold no run are passed over.
/// @throws IoError where `folder` is none
std::vector<ListedRun> list_runs(const std::filesystem::path& folder, RunOrder order);

/// A line for each, columns under each other, cut to so many columns.
std::string text_of(const std::vector<ListedRun>& runs, std::size_t width);

nlohmann::json json_of(const std::vector<ListedRun>& runs);

} // namespace suffuse::job
