#include "apps/stop_signal.hpp"

#include "apps/console.hpp"
#include "apps/exit_code.hpp"
#include <cerrno>
#include <csignal>
#include <string_view>
#include <unistd.h>

namespace suffuse::apps {
namespace {

std::atomic<bool> stop{false}, was_interrupted{false};
std::atomic<int> first_signal{0};
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free);

extern "C" void on_signal(int signal) {
    if (signal == SIGINT && was_interrupted.exchange(true)) {
        _exit(BySignal + SIGINT);
    }
    int none = 0;
    if (!first_signal.compare_exchange_strong(none, signal)) {
        return;
    }
    stop = true; // after the signal: who sees the flag knows which it was
    constexpr std::string_view text =
        "\nstopping; the state is saved first (a second Ctrl-C quits at once, without saving)\n";
    const int error = errno; // of what the signal came between
    if (takes_words(STDERR_FILENO)) {
        [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, text.data(), text.size());
    } // a terminal that is closed or held up is no reason not to stop
    errno = error;
}

} // namespace

void handle_signals() {
    struct sigaction action {};

    action.sa_handler = on_signal;
    sigemptyset(&action.sa_mask);
    action.sa_flags = SA_RESTART;
    // The last two are how batch systems announce the end of a job.
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGXCPU, SIGUSR1, SIGUSR2}) {
        struct sigaction before {};

        sigaction(signal, nullptr, &before);
        const bool is_under_nohup = signal == SIGHUP && before.sa_handler == SIG_IGN;
        if (!is_under_nohup) {
            sigaction(signal, &action, nullptr);
        }
    }
}

const std::atomic<bool>& stop_flag() {
    return stop;
}

int signal_exit_code() {
    return BySignal + first_signal;
}

void ignore_write_signals() {
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
}

} // namespace suffuse::apps
