#pragma once
// How work that reports no progress (see pulse.hpp) learns that it should stop: while an Interruption lives, parallel
// loops of its thread and readers of long files look whether it wants them to. What is looked at may throw, which ends
// the work; so it is for work whose results are dropped then, not for steps of a world.

#include <functional>

namespace suffuse {

class Interruption {
public:
    /// @param look called on this thread alone, between parts of the work, which may be microseconds apart
    explicit Interruption(std::function<void()> look);
    ~Interruption();

    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;

    /// Whether work of this thread can be interrupted.
    static bool is_possible() { return innermost != nullptr; }

    /// Throws what `look` throws; nothing where no Interruption lives on this thread.
    static void look_up() {
        if (innermost != nullptr) {
            innermost->look_();
        }
    }

private:
    static thread_local Interruption* innermost;

    std::function<void()> look_;
    Interruption* outer_;
};

} // namespace suffuse
