#pragma once
// A small finished run of which files are replaced, with checksums to match: a run folder from someone else, as a
// reader of runs sees it.

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace suffuse::fuzz {

class FinishedRun {
public:
    /// The one run of this process; computed by the first call, gone when the process ends.
    static FinishedRun& the();

    ~FinishedRun();
    FinishedRun(const FinishedRun&) = delete;
    FinishedRun& operator=(const FinishedRun&) = delete;

    /// What may be replaced, as it was when the run ended, by its name below the folder. Pictures and pages are left
    /// out.
    [[nodiscard]] const std::map<std::string, std::string>& files() const { return files_; }

    /// Puts these files in the place of those of the run, lets `verify`, `resume` and `report` look at the folder, and
    /// puts all back. Whatever they throw that is no message to the user comes through.
    void look_with(const std::map<std::string, std::string>& replaced);

private:
    FinishedRun();
    void seal(const std::map<std::string, std::string>& replaced) const;
    void put_back(const std::map<std::string, std::string>& replaced) const;

    std::filesystem::path root_, folder_;
    std::map<std::string, std::string> files_, others_;
};

} // namespace suffuse::fuzz
