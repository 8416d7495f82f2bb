#pragma once
// Wall seconds, for what is reported of a computation; no result depends on them.

#include <chrono>
#include <utility>

namespace suffuse {

class Stopwatch {
public:
    /// Seconds since it was made or last lapped.
    [[nodiscard]] double seconds() const { return std::chrono::duration<double>(Clock::now() - since_).count(); }

    /// The same, and begins anew.
    double lap() {
        const Clock::time_point now = Clock::now();
        return std::chrono::duration<double>(now - std::exchange(since_, now)).count();
    }

private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point since_ = Clock::now();
};

} // namespace suffuse
