#pragma once
// What --help says: short, with an example, made from the flags themselves.

#include <string>
#include <string_view>

namespace CLI {
class App;
}

namespace suffuse::apps {

/// All verbs, and how to begin.
std::string overview(const CLI::App& app);

/// One verb: use, arguments, flags, an example.
std::string help_on(const CLI::App& verb);

/// "bench step": a verb with those above it.
std::string path_of(const CLI::App& verb);

std::string version_text();

std::string_view exit_codes_text();

} // namespace suffuse::apps
