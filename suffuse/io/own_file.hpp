#pragma once
// The one place where a file that a run goes on with is opened: a run folder from someone else may hold links, pipes
// and devices under the names of its files. Whole files are written to a new file, then renamed: io/atomic_file.hpp.

#include <filesystem>
#include <string_view>

namespace suffuse::io {

/// Appends at once, so that several programs may add to one file, which is made where it is missing. @throws IoError
/// where it is a link, no regular file, another user's, or has another name elsewhere (a hard link)
void append_to(const std::filesystem::path& path, std::string_view text);

/// @throws IoError where the path leads to a pipe, a socket or a device: reading one might never end.
void require_regular(const std::filesystem::path& path);

} // namespace suffuse::io
