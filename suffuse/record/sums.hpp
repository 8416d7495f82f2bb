#pragma once
// SHA-256 of files, as sha256sum writes and checks them: lines of a checksum and the name of a file.

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace suffuse::record {

inline constexpr const char* checksums_file = "SHA256SUMS";

using Sums = std::map<std::string, std::string>; ///< by the name of the file: 64 hexadecimal digits

/// A file that is not as it was, or that contradicts another.
struct Damage {
    std::string file; ///< below the run folder, or the stage's
    std::string what; ///< in words: "was changed"
};

/// How the checksum of a file is come by: read, or known from before.
using ChecksumOf = std::function<std::string(const std::filesystem::path&)>;

/// @throws IoError where the file cannot be read
std::string checksum_of(const std::filesystem::path& file);

std::string checksum_of_text(std::string_view text);

/// @throws IoError where the file cannot be read, or a line of it is no checksum
Sums read_sums(const std::filesystem::path& file);

std::string sums_text(const Sums& sums);

/// What became of a file that had this checksum, in words; empty: nothing.
std::string
describe_damage(const std::filesystem::path& file, const std::string& sum, const ChecksumOf& now = checksum_of);

} // namespace suffuse::record
