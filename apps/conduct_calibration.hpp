#pragma once
// A calibration as the command line runs it: its rounds with their prices and progress, then the answer.

#include "suffuse/job/calibration_files.hpp"
#include "suffuse/record/stage_cache.hpp"

#include "apps/console.hpp"
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

namespace suffuse::apps {

struct CalibrationJob {
    std::string case_file;
    std::vector<std::string> overrides;
    std::filesystem::path folder;
    std::filesystem::path cache; ///< empty: none
    record::Owners cache_owners = record::Owners::Self;
    double time_limit = std::numeric_limits<double>::infinity(); ///< [s]
    double memory = std::numeric_limits<double>::infinity();     ///< [B]
    std::string command;                                         ///< as typed
};

/// Finds what is wrong with the case and with the files of its targets. @return the exit code; @throws what is wrong
int check_calibration(const CalibrationJob& job, const Console& console);

/// Shows what the samples cost, and runs nothing. @return the exit code
int price_calibration(const CalibrationJob& job, const Console& console);

/// Runs it in its folder, which is there, from where it was stopped. @return the exit code
int conduct_calibration(const CalibrationJob& job, const Console& console);

} // namespace suffuse::apps
