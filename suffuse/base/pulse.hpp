#pragma once
// How long work reports its progress, and learns that it should stop. The one callback of the library: the caller
// shows progress or saves the state, and throws Interrupted to end the work between two bursts of steps.

#include <functional>
#include <string_view>

namespace suffuse {

/// Called between bursts with the part of the work ("relax", "probe") and the steps done in it.
using Pulse = std::function<void(std::string_view part, long long steps)>;

inline void beat(const Pulse& pulse, std::string_view part, long long steps) {
    if (pulse) {
        pulse(part, steps);
    }
}

} // namespace suffuse
