#pragma once
// The verbs and flags as one table, read off the command line's own description: what completions and the man page are
// made from.

#include <string>
#include <vector>

namespace CLI { // NOLINT(readability-identifier-naming): the library's
class App;
class Option;
} // namespace CLI

namespace suffuse::apps {

/// What may follow, where the shell can help.
enum class Values { None, Any, Words, CaseFile, Folder, File };

struct FlagRow {
    std::vector<std::string> names; ///< "-o", "--output"
    std::string placeholder;        ///< "DIR"; empty where it takes no value
    std::string text;
    Values values = Values::None;
    std::vector<std::string> words; ///< for Values::Words
};

struct VerbRow {
    std::string path; ///< "run", "bench step"; empty: the program itself
    std::string text, example;
    std::vector<FlagRow> arguments; ///< without a flag, in their order
    std::vector<FlagRow> flags;
    std::vector<std::string> verbs; ///< below this one
};

/// The program first, then every verb and those below it; flags that stand everywhere are in the first row.
std::vector<VerbRow> command_table(const CLI::App& app);

} // namespace suffuse::apps
