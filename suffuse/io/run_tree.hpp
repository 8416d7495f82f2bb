#pragma once
// What lies in a run folder, looked at before any of it is opened: it may be from someone else.

#include <filesystem>
#include <string>

namespace suffuse::io {

/// To read is to take regular files and folders, links to them too; to work is to write as well, where no link may be.
enum class Purpose { Read, Work };

/// @return a remark where files belong to another user; empty otherwise
/// @throws IoError that names a pipe, a socket or a device; where the purpose is to work, a link, too
std::string look_into_run(const std::filesystem::path& run, Purpose purpose);

} // namespace suffuse::io
