#pragma once
// A file that is either complete or not there: it is written under another name, brought to the disk and then renamed.
// A full disk, a killed program or a power cut leaves what was there before. Of several writers, the last one's stays.
// A path that exists and is no regular file (/dev/full, a pipe) is written to directly.

#include <filesystem>
#include <string>
#include <string_view>

namespace suffuse::io {

class AtomicFile {
public:
    /// Starts writing next to `path`, and removes what a killed program began of it. Every member throws IoError where
    /// the system refuses.
    explicit AtomicFile(std::filesystem::path path);
    ~AtomicFile(); ///< without `commit`, nothing remains
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    void write(std::string_view bytes);

    /// Brings everything to the disk and gives the file its name.
    void commit() { finish(true); }

    /// Gives the file its name; a power cut may lose it.
    void show() { finish(false); }

private:
    void finish(bool to_disk);
    void flush();
    void write_out(std::string_view bytes);
    [[noreturn]] void fail(int error) const;

    std::filesystem::path path_, partial_; ///< the latter is empty where `path_` is no file
    std::string buffer_;
    int descriptor_ = -1;
};

/// Whether a file of this name may be one that is being written, or was when its program was killed: no result. What
/// may be removed is narrower: io/leftovers.hpp.
bool is_partial(std::string_view name);

/// Brings a file that was written by other means to the disk. Throws IoError.
void sync_file(const std::filesystem::path& path);

/// Writes a whole file at once.
void write_file(const std::filesystem::path& path, std::string_view bytes);

/// The same for what is made anew every other second and need not outlive a power cut. @return whether it was written
bool show_file(const std::filesystem::path& path, std::string_view bytes);

} // namespace suffuse::io
