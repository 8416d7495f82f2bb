#pragma once
// The files that tasks are written to: tasks.txt, and the scripts of an engine.

#include "apps/sweep_engines.hpp"
#include "apps/sweep_tasks.hpp"
#include <filesystem>
#include <string>
#include <vector>

namespace suffuse::apps {

/// What the scripts say about a task.
struct TaskRequest {
    const Engine* engine = nullptr;
    std::filesystem::path folder;   ///< of the run, absolute: tasks run from anywhere
    std::string program;            ///< this one
    std::vector<std::string> words; ///< of each call, after the sample
    int threads = 1;
    double memory = 0;  ///< [B]
    double seconds = 0; ///< wall time of a task, at most [s]
    int most_tasks = 0; ///< of an array; 0: any number
    std::string partition, account;
};

/// What the user types to run the tasks in the folder of a run.
std::string command_of(const Engine& engine, const std::filesystem::path& folder);

/// Writes them, in place of those of an earlier call.
void write_scripts(const std::vector<Task>& tasks, std::size_t samples, const TaskRequest& request);

} // namespace suffuse::apps
