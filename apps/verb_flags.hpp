#pragma once

// The table of verbs and flags: the parser, the help texts, the completions and the man page are made from it.

namespace CLI {
class App;
} // namespace CLI

namespace suffuse::apps {

struct CommandLine;

/// Adds every verb with its flags; parsing then fills `line`, which must outlive the app.
void add_verbs(CLI::App& app, CommandLine& line);

} // namespace suffuse::apps
