#pragma once
// What killed programs left half-written: NAME.partial-PID-N of a NAME that the program writes, a regular file of this
// user that nobody holds. Whatever else has such an ending is somebody's own, and stays.

#include <filesystem>
#include <functional>
#include <string_view>

namespace suffuse::io {

inline constexpr std::string_view partial_suffix = ".partial";

/// NAME of "NAME.partial-PID-N"; empty for a name of any other form.
std::string_view name_of_leftover(std::string_view name);

/// A name under which this program may write `path` before it is whole; another one each time.
std::filesystem::path next_partial(const std::filesystem::path& path);

/// Whether a file has the form of a leftover of `name`, is a regular one, and this user's.
bool is_leftover_of(const std::filesystem::path& file, std::string_view name);

/// Removes leftovers of names that are the program's; those that others are writing stay.
void remove_leftovers(
    const std::filesystem::path& folder, const std::function<bool(std::string_view name)>& is_of_program
);

} // namespace suffuse::io
