#pragma once
// A folder for what another program is to work on, gone at the end: where temporary files belong (TMPDIR, /tmp), or,
// where that is missing, full or not to be written to, in a folder that the caller writes to anyway.

#include <filesystem>

namespace suffuse::job {

class ScratchFolder {
public:
    /// @throws IoError where neither takes a folder
    explicit ScratchFolder(const std::filesystem::path& otherwise);
    ~ScratchFolder();

    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

} // namespace suffuse::job
