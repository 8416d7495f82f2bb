#pragma once
// Other programs that do a part of the work: found on the PATH, run to their end, their complaints kept.

#include <optional>
#include <string>
#include <vector>

namespace suffuse::job {

struct ProgramEnd {
    int code = 0;          ///< exit status; 128 + signal where one ended it
    std::string complaint; ///< what it wrote to standard error, its end
};

/// Whether a program of this name can be run.
bool is_installed(const std::string& name);

/// Runs `words[0]` with the others as its arguments, without input; its standard output is dropped. It does not outlive
/// the thread that called this.
/// @throws IoError where it cannot be started.
ProgramEnd run_program(const std::vector<std::string>& words);

/// What a program writes to standard output, without input and complaints; nothing where it is not installed or fails.
std::optional<std::string> output_of(const std::vector<std::string>& words);

} // namespace suffuse::job
