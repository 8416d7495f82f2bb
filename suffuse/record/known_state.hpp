#pragma once
// A state that a stage left in its folder, with what to do where it cannot be used.

#include "suffuse/io/checkpoint.hpp"

#include <filesystem>
#include <string>

namespace suffuse::record {

class KnownState {
public:
    /// @param to_remove so that what was lost is computed anew
    KnownState(std::filesystem::path file, std::filesystem::path to_remove)
        : file_(std::move(file)), to_remove_(std::move(to_remove)) {}

    /// One in the folder of the stage that has come to its end.
    explicit KnownState(const std::filesystem::path& file) : KnownState(file, file.parent_path()) {}

    [[nodiscard]] io::Checkpoint load() const;

    /// @param expected describe_state of what was saved; empty if an earlier version did not record it
    void check(const dem::World& world, const std::string& expected) const;

    /// Throws IoError: it is of another case, sample, stage or seed.
    [[noreturn]] void refuse_other() const;

    /// Throws IoError about this file.
    [[noreturn]] void complain(const std::string& what) const;

private:
    std::filesystem::path file_, to_remove_;
};

} // namespace suffuse::record
