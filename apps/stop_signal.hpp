#pragma once
// What ends a run early: Ctrl-C, a terminal that closes, a batch system or a limit of CPU time. All of them ask the run
// to save and stop. Only a second Ctrl-C ends the program at once: the other signals come twice without anybody meaning
// that, as from a shell and the kernel when a terminal closes, or from Slurm at the end of its warning.

#include <atomic>

namespace suffuse::apps {

/// From now on those signals set the flag instead of ending the program. Under `nohup` SIGHUP stays ignored.
void handle_signals();

/// Set by the first signal.
const std::atomic<bool>& stop_flag();

/// 128 and the number of the first signal: 130 after SIGINT, 143 after SIGTERM.
int signal_exit_code();

/// From now on what cannot be written is an error of that write and does not end the program: no reader (SIGPIPE), or a
/// file beyond the limit (SIGXFSZ).
void ignore_write_signals();

} // namespace suffuse::apps
