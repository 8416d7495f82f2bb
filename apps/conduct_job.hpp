#pragma once
// What run and resume have in common: a case is planned, run to its end with its progress shown, and its end reported.

#include "suffuse/casefile/load_case.hpp"
#include "suffuse/plan/plan.hpp"

#include "apps/console.hpp"
#include <filesystem>
#include <limits>
#include <optional>
#include <string>

namespace suffuse::apps {

/// A run that is about to begin or to go on.
struct Job {
    std::string until;                                           ///< stage; empty: to the end
    double time_limit = std::numeric_limits<double>::infinity(); ///< [s]
    double memory = std::numeric_limits<double>::infinity();     ///< that it may take [B]
    std::string sample;                                          ///< this one alone; empty: all
    std::string command;                                         ///< as typed
    casefile::Case what;
    std::filesystem::path folder;
    std::string case_text;
    std::filesystem::path live;  ///< folder of the live page while a part of something larger runs; empty: none
    std::filesystem::path cache; ///< empty: none
    record::Owners cache_owners = record::Owners::Self;
    plan::RunPlan plan;
};

/// The plan without what the folder or the cache holds, what comes after the requested last stage, and other
/// samples than the only one requested; for as many samples side by side as its memory holds. @throws IoError where
/// it holds none.
plan::RunPlan plan_rest(const Job& job);

/// The code of a run that needs nothing. Damage is reported before anything is written.
std::optional<int> look_before(const Job& job, const Console& console);

/// @param preposition before the folder: "into" a new one, or "in" the one that is there
void print_plan(const Job& job, const std::string& preposition, const Console& console);

/// Runs it. @return the exit code
int conduct(const Job& job, const Console& console);

/// Runs its samples, without a report. @return false where it was stopped, or its time is over
bool conduct_samples(const Job& job, const Console& console);

} // namespace suffuse::apps
