#pragma once
// Files that are no text and are not read, recognized by their first bytes: what they are, and how to convert them.

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace suffuse::io {

struct NamedFile {
    std::string_view begin;  ///< its first bytes
    std::string_view name;   ///< "a GSD file of HOOMD-blue"
    std::string_view advice; ///< how to get a text; {} stands for the name of the file, as a shell takes it
};

std::span<const NamedFile> named_files();

/// Throws CaseError where a file that begins so is one of these.
void refuse_named_file(const std::filesystem::path& path, std::string_view begin);

} // namespace suffuse::io
