#pragma once
// How work would scale, seen on one thread: the time within parallel loops, block by block, next to the time outside
// them. What lies outside stays with one thread however many there are (Amdahl 1967), and a loop takes no less than its
// longest block. Times are of the thread's processor, so other programs disturb them little.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace suffuse {

/// While one lives, the loops of its thread run there block after block and are measured. `thread_count()` says there
/// for how many threads it measures, so that work is cut as for so many.
class LoopMeter {
public:
    /// @param threads that the work is cut for, at least 1
    /// @param clock what times are read from [s]; by default the processor time of this thread
    explicit LoopMeter(int threads, double (*clock)() = nullptr);
    ~LoopMeter();
    LoopMeter(const LoopMeter&) = delete;
    LoopMeter& operator=(const LoopMeter&) = delete;

    struct Phase {
        const char* name;
        double serial = 0, parallel = 0; ///< outside loops, and within them [s]
        double shared = 0; ///< what the loops would take the threads, free ones taking the blocks in order, nothing
                           ///< lost to waiting or memory [s]
        std::int64_t loops = 0;
    };

    /// In the order in which they began; what no phase names is "rest".
    [[nodiscard]] std::vector<Phase> phases();

    [[nodiscard]] int threads() const { return threads_; }

    /// Of this thread; null where none lives.
    static LoopMeter* of_this_thread();

    /// Runs the blocks [0, blocks) of a loop in order.
    void measure(std::size_t blocks, const std::function<void(std::size_t, std::size_t)>& body);

    /// What follows belongs to this phase. @return the one before
    std::size_t begin(const char* name);
    void resume(std::size_t phase);

private:
    void charge();

    int threads_;
    double (*clock_)();
    std::vector<Phase> phases_;
    std::size_t now_ = 0;
    double since_ = 0; ///< what is not charged yet begins here [s]
};

/// Names what a thread does until the scope ends, where somebody measures; costs nothing where nobody does.
class MeteredPhase {
public:
    /// @param name a literal
    explicit MeteredPhase(const char* name);
    ~MeteredPhase();
    MeteredPhase(const MeteredPhase&) = delete;
    MeteredPhase& operator=(const MeteredPhase&) = delete;

    void next(const char* name);

private:
    LoopMeter* meter_;
    std::size_t before_ = 0;
};

/// How long blocks of these durations take `threads` threads of which each takes the next block when it is free.
double shared_time(std::span<const double> blocks, int threads);

} // namespace suffuse
