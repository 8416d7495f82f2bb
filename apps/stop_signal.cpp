#include "apps/stop_signal.hpp"

#include "apps/exit_code.hpp"
#include <csignal>
#include <string_view>
#include <unistd.h>

namespace suffuse::apps {
namespace {

std::atomic<bool> stop{false};
std::atomic<int> first_signal{0};
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free);

int code_of(int signal) {
    return signal == SIGTERM ? Terminated : Interrupted;
}

extern "C" void on_signal(int signal) {
    if (stop.exchange(true)) {
        _exit(code_of(signal));
    }
    first_signal = signal;
    constexpr std::string_view text =
        "\nstopping; what is needed to go on is saved first (once more quits at once, without saving)\n";
    if (write(STDERR_FILENO, text.data(), text.size()) < 0) {
        return;
    } // a closed terminal is no reason not to stop
}

} // namespace

void heed_signals() {
    struct sigaction action {};

    action.sa_handler = on_signal;
    sigemptyset(&action.sa_mask);
    action.sa_flags = SA_RESTART;
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

const std::atomic<bool>& stop_flag() {
    return stop;
}

int signal_exit_code() {
    return code_of(first_signal);
}

} // namespace suffuse::apps
