#pragma once
// Folders that outlive a power cut: a new name is on the disk only once the folder that holds it has been synced.

#include <filesystem>

namespace suffuse::io {

/// Makes a folder, with those above it that are missing, and brings their names to the disk. Throws IoError.
void make_folders(const std::filesystem::path& folder);

/// Makes a folder in one that is there. @return false where something has its name already. Throws IoError.
bool make_folder(const std::filesystem::path& folder);

/// Removes a file, if it is there, so that a power cut does not bring it back next to what is written next.
/// Throws std::filesystem::filesystem_error.
void remove_file(const std::filesystem::path& file);

/// Brings to the disk what names came and went in the folder of `file`. Some file systems refuse; what is in the file
/// is safe all the same.
void sync_folder_of(const std::filesystem::path& file);

} // namespace suffuse::io
