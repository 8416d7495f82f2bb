#pragma once
// Ctrl-C and the batch system's SIGTERM: the first asks the run to save and stop, a second one ends the program at
// once.

#include <atomic>

namespace suffuse::apps {

/// From now on signals set the flag instead of ending the program.
void heed_signals();

/// Set by the first signal.
const std::atomic<bool>& stop_flag();

/// 130 after SIGINT, 143 after SIGTERM.
int signal_exit_code();

} // namespace suffuse::apps
