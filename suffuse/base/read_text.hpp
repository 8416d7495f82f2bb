#pragma once
// What is looked at before a text is parsed: can the file be read, is it text, and, for TOML, is everything outside
// strings and comments plain ASCII (the parser must not see anything else there) and nested to a sane depth.

#include "suffuse/base/diagnostics.hpp"

#include <cstdio>
#include <memory>
#include <string>
#include <string_view>

namespace suffuse {

/// A descriptor that reads a file, -1 with errno where there is none. A pipe that nobody writes into is an empty file:
/// it is not waited for.
int open_for_reading(const std::string& path);

/// The bytes of a file, without a byte order mark. Throws IoError, also for a file beyond 64 MiB.
std::string read_whole_file(const std::string& path);

/// The same of a stream that is open already, whose name is `path` in messages.
std::string read_whole_stream(std::FILE* stream, const std::string& path);

/// Bytes of the character at `at`, or 0 where it is not valid UTF-8.
std::size_t character_size(std::string_view text, std::size_t at);

/// The text with a question mark for each byte that is no UTF-8: for messages, which are text.
std::string as_utf8(std::string_view text);

/// Valid UTF-8 without zero bytes; reports the first place that is not.
bool check_encoding(const std::shared_ptr<const Source>& source, Problems& problems);

/// Reports what TOML 1.0 cannot have outside strings and comments.
bool check_toml_characters(const std::shared_ptr<const Source>& source, Problems& problems);

} // namespace suffuse
