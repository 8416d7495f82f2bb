// The program: the command line in, an exit code out. Every error that nothing below can answer for ends here, once,
// with its words and its code.

#include "apps/command_line.hpp"
#include "apps/complaint.hpp"
#include "apps/console.hpp"
#include "apps/exit_code.hpp"
#include "apps/process_limits.hpp"
#include "apps/standard_streams.hpp"
#include "apps/stop_signal.hpp"
#include "apps/verb.hpp"
#include <algorithm>
#include <malloc.h>
#include <string_view>

namespace suffuse::apps {
namespace {

int run_program(int argc, const char* const* argv) {
    CommandLine early; // what an error about the command line itself needs to know
    early.json = std::any_of(argv, argv + argc, [](const char* word) { return std::string_view(word) == "--json"; });
    Console console(early);
    try {
        raise_stack_limit();
        const ParsedCommand command = read_command_line(argc, argv);
        console = Console(command.line);
        if (!command.text.empty()) {
            Console().result(command.text);
            Console().finish();
            return Done;
        }
        raise_file_limit();
        const int code = command.verb->act(command.line, console);
        console.finish();
        return code;
    } catch (...) {
        return complain_about_current(console);
    }
}

} // namespace
} // namespace suffuse::apps

int main(int argc, char** argv) {
    // Large tables go back to the system when they are freed; left to itself, the allocator would keep them after the
    // first, and a sample would hold half as much again.
    mallopt(M_MMAP_THRESHOLD, 1 << 20);
    suffuse::apps::fill_closed_streams();
    suffuse::apps::ignore_write_signals();
    return suffuse::apps::run_program(argc, argv);
}
