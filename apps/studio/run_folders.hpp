#pragma once
// The runs below the studio's folder: found by their names, stopped, and removed. What is known of them is what their
// folders hold, so that a studio that ends forgets nothing.

#include <filesystem>
#include <optional>
#include <string>
#include <sys/types.h>
#include <vector>

namespace suffuse::studio {

/// A file or folder below `root`, after all links. @throws Refusal 404 where there is none, or it is elsewhere.
std::filesystem::path find_below(const std::filesystem::path& root, const std::string& name);

/// The folder of a run, or of a calibration. @throws Refusal 404 where there is no such run.
std::filesystem::path find_run(const std::filesystem::path& root, const std::string& name);

/// Names of all runs, the one last changed first: without a look at what they found, which takes seconds for thousands.
std::vector<std::string> run_names(const std::filesystem::path& root);

/// Where what is at work leaves its plan and its progress: the folder of a run, or of the last round of a calibration.
std::filesystem::path work_folder(const std::filesystem::path& run);

/// The finished stages of a run, as folders below studies/: "sand/friction=20deg/rep=1/initial". Those of a sweep's
/// tasks, too, which leave no events in the run's folder. Links are not followed.
std::vector<std::string> finished_stages(const std::filesystem::path& run);

/// A picture of grains that a stage has saved: docs/formats.md.
struct GrainPicture {
    std::string file; ///< below the run's folder
    std::filesystem::file_time_type written;
};

/// The pictures of a run that a page can show, the newest first, at most some hundred. Links are not followed.
std::vector<GrainPicture> grain_pictures(const std::filesystem::path& run);

/// The folders of the runs that a program works on now.
std::vector<std::filesystem::path> runs_at_work(const std::filesystem::path& root);

/// The process that works in a run's folder, of this user: the one that holds its lock.
std::optional<pid_t> process_of(const std::filesystem::path& run);

/// Asks it to save its state and end. @throws Refusal 409 where nobody works on the run.
void stop_run(const std::filesystem::path& run);

/// Removes a run that has provenance.json. @throws Refusal 403 for another folder, 409 while it is worked on.
void remove_run(const std::filesystem::path& run);

/// The end of what a run has said. Links are not followed.
std::string last_words(const std::filesystem::path& log);

/// A new folder NAME-0001, or the next number that is free here and among the cases.
std::filesystem::path make_numbered_folder(const std::filesystem::path& root, const std::string& name);

/// "Dam, north" -> "dam-north": letters, digits and hyphens.
std::string folder_name(const std::string& title);

} // namespace suffuse::studio
