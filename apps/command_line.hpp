#pragma once
// The command line -> what is requested: a verb with its options, or a text. Wrong use is reported with the nearest
// word that would have been right.

#include <memory>
#include <string>

namespace suffuse::apps {

enum class Color { Auto, Always, Never };

class Verb;

/// What every verb has.
struct CommandLine {
    std::string typed; ///< the whole command, quoted as for a shell
    bool quiet = false, verbose = false, json = false;
    Color color = Color::Auto;
};

struct ParsedCommand {
    CommandLine line;
    std::string text;                 ///< help, version, completions, man page: all there is to say; empty: `verb` acts
    std::shared_ptr<const Verb> verb; ///< with its options
};

/// @throws UsageError.
ParsedCommand read_command_line(int argc, const char* const* argv);

} // namespace suffuse::apps
