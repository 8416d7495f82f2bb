#include "suffuse/base/parallel.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/interruption.hpp"
#include "suffuse/base/loop_meter.hpp"

#include <atomic>
#include <cstdint>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace suffuse {
namespace {

thread_local bool inside_a_loop = false; // a loop within a loop runs on the thread that meets it

struct Within {
    Within() { inside_a_loop = true; }

    ~Within() { inside_a_loop = false; }

    Within(const Within&) = delete;
    Within& operator=(const Within&) = delete;
};

// 40 to 200 microseconds: longer than what a thread waits for within a step of 10,000 grains, shorter than a time
// slice.
constexpr std::size_t spins_before_sleep = 4000, spins_before_late_help = 1500;
constexpr int loops_in_haste_after_late_help = 2000; // some time slices of loops within a step

std::size_t first_block(std::size_t thread, std::size_t blocks, std::size_t threads) {
    return blocks * thread / threads;
}

/// Tells the processor that a thread only looks whether something has changed.
void look_again_later() {
#if defined(__x86_64__)
    __builtin_ia32_pause();
#endif
}

/// The blocks that are left of one thread's share of a loop, as one word: claiming a block is one exchange of it, which
/// fails when the loop is over, however late the thread that claims it has woken up.
class Share {
public:
    void open(std::uint32_t loop, std::size_t first, std::size_t last) {
        word_.store(static_cast<std::uint64_t>(loop) << 48 | static_cast<std::uint64_t>(first) << 24 | last);
    }

    /// A block to do, or nothing.
    std::optional<std::size_t> claim() {
        for (std::uint64_t word = word_.load();;) {
            const std::uint64_t next = word >> 24 & block_mask, last = word & block_mask;
            if (next >= last) {
                return std::nullopt;
            }
            if (word_.compare_exchange_weak(word, word + (std::uint64_t{1} << 24))) {
                return next;
            }
        }
    }

    static constexpr std::uint64_t block_mask = 0xffffff; // of one share

private:
    alignas(64) std::atomic<std::uint64_t> word_{0};
};

/// Threads that wait for loops. Each has a contiguous share of the blocks, for its cache's sake, and helps the others
/// when it is done, or a while later: a thread that the machine has put aside delays nobody for long.
class Pool {
public:
    explicit Pool(int threads) : shares_(static_cast<std::size_t>(threads)) {
        for (int t = 1; t < threads; ++t) {
            workers_.emplace_back([this, t] { serve(static_cast<std::size_t>(t)); });
        }
    }

    ~Pool() {
        stop_ = true;
        generation_.fetch_add(1);
        generation_.notify_all();
        for (std::thread& worker : workers_) {
            worker.join();
        }
    }

    Pool(const Pool&) = delete;
    Pool& operator=(const Pool&) = delete;

    void run(std::size_t blocks, Help help, const std::function<void(std::size_t, std::size_t)>& body) {
        expects(blocks <= Share::block_mask, "a parallel loop has more blocks than a share can count");
        body_ = &body;
        at_once_ = help == Help::AtOnce || loops_in_haste_ > 0;
        loops_in_haste_ = std::max(0, loops_in_haste_ - 1);
        left_.store(blocks);
        const std::uint32_t loop = generation_.load() + 1;
        for (std::size_t t = 0; t < shares_.size(); ++t) {
            shares_[t].open(loop, first_block(t, blocks, shares_.size()), first_block(t + 1, blocks, shares_.size()));
        }
        generation_.fetch_add(1);
        generation_.notify_all();
        work(0);
        for (std::size_t left = left_.load(), spin = 0; left != 0; left = left_.load()) {
            if (++spin == spins_before_late_help) {
                help_late(0);
            } else if (spin > spins_before_sleep) {
                left_.wait(left);
            }
            look_again_later();
        }
        if (failed_.exchange(false)) {
            std::rethrow_exception(std::exchange(error_, nullptr));
        }
    }

private:
    void work(std::size_t thread) {
        do_blocks_of(shares_[thread]);
        if (at_once_) {
            help_others(thread);
        }
    }

    /// A machine that has put one thread aside soon does so again.
    void help_late(std::size_t thread) {
        if (help_others(thread)) {
            loops_in_haste_ = loops_in_haste_after_late_help;
        }
    }

    /// @return whether there was something to help with
    bool help_others(std::size_t thread) {
        bool helped = false;
        for (std::size_t k = 1; k < shares_.size(); ++k) {
            helped |= do_blocks_of(shares_[(thread + k) % shares_.size()]);
        }
        return helped;
    }

    /// @return whether there were any
    bool do_blocks_of(Share& share) {
        bool some = false;
        inside_a_loop = true;
        while (const std::optional<std::size_t> block = share.claim()) {
            do_block(*block);
            some = true;
        }
        inside_a_loop = false;
        return some;
    }

    void do_block(std::size_t block) {
        try {
            if (!failed_.load(std::memory_order_relaxed)) {
                Interruption::look_up();
                (*body_)(block, block + 1);
            }
        } catch (...) {
            if (!failed_.exchange(true)) {
                error_ = std::current_exception();
            }
        }
        if (left_.fetch_sub(1) == 1) {
            left_.notify_one();
        }
    }

    void serve(std::size_t thread) {
        std::uint32_t seen = 0;
        for (;;) {
            std::uint32_t now = generation_.load();
            for (std::size_t spin = 0; now == seen; now = generation_.load()) {
                if (++spin == spins_before_late_help) {
                    help_late(thread);
                } else if (spin > spins_before_sleep) {
                    generation_.wait(seen);
                }
                look_again_later();
            }
            seen = now;
            if (stop_) {
                return;
            }
            work(thread);
        }
    }

    std::vector<std::thread> workers_;
    std::vector<Share> shares_;
    const std::function<void(std::size_t, std::size_t)>* body_ = nullptr;
    std::exception_ptr error_;
    std::atomic<std::uint32_t> generation_{0};
    std::atomic<std::size_t> left_{0};
    std::atomic<bool> failed_{false}, stop_{false};
    std::atomic<bool> at_once_{true};
    std::atomic<int> loops_in_haste_{0};
};

std::atomic<int> requested_threads = 1;
std::unique_ptr<Pool> pool;             // of all threads that have no crew of their own
std::atomic<Pool*> idle_pool = nullptr; // the same while no thread loops with it; null also where there is none

/// The pool for one loop, unless another thread loops with it.
class PoolForOneLoop {
public:
    PoolForOneLoop() : taken_(idle_pool.load() == nullptr ? nullptr : idle_pool.exchange(nullptr)) {}

    ~PoolForOneLoop() {
        if (taken_ != nullptr) {
            idle_pool.store(taken_);
        }
    }

    PoolForOneLoop(const PoolForOneLoop&) = delete;
    PoolForOneLoop& operator=(const PoolForOneLoop&) = delete;

    [[nodiscard]] Pool* get() const { return taken_; }

private:
    Pool* taken_;
};

/// The threads of one worker of `run_side_by_side`: its part of them all, and more when other workers have run out of
/// tasks. Results do not depend on how many they are, so they may change between two loops.
class Crew {
public:
    Crew(int threads, std::atomic<int>& workers) : all_(threads), workers_(workers) { own_crew = this; }

    ~Crew() {
        own_crew = nullptr;
        workers_.fetch_sub(1);
    }

    Crew(const Crew&) = delete;
    Crew& operator=(const Crew&) = delete;

    [[nodiscard]] int threads() const { return std::max(1, all_ / std::max(1, workers_.load())); }

    Pool* pool() {
        const int now = threads();
        if (now != threads_) {
            pool_.reset();
            pool_ = now > 1 ? std::make_unique<Pool>(now) : nullptr;
            threads_ = now;
        }
        return pool_.get();
    }

    static thread_local Crew* own_crew; ///< of this thread; null: it is no such worker

private:
    int all_, threads_ = 1;
    std::atomic<int>& workers_; ///< that have tasks
    std::unique_ptr<Pool> pool_;
};

thread_local Crew* Crew::own_crew = nullptr;

/// On the calling thread. All blocks at once, unless somebody may want them to end.
void run_alone(std::size_t blocks, const std::function<void(std::size_t, std::size_t)>& body) {
    if (!Interruption::is_possible()) {
        return body(0, blocks);
    }
    for (std::size_t b = 0; b < blocks; ++b) {
        Interruption::look_up();
        body(b, b + 1);
    }
}

/// On the calling thread where there is no pool, or where another thread has it: no result depends on that.
void run_in(Pool* threads, std::size_t blocks, Help help, const std::function<void(std::size_t, std::size_t)>& body) {
    if (threads == nullptr) {
        return run_alone(blocks, body);
    }
    threads->run(blocks, help, body);
}

/// The tasks of one `run_side_by_side`: a free thread takes the next.
class TaskQueue {
public:
    TaskQueue(std::size_t tasks, const std::function<void(std::size_t)>& task) : tasks_(tasks), task_(task) {}

    void work() {
        while (const std::optional<std::size_t> number = take()) {
            try {
                task_(*number);
            } catch (...) {
                const std::lock_guard lock(mutex_);
                if (!error_ || *number < failed_) {
                    error_ = std::current_exception();
                    failed_ = *number;
                }
            }
        }
    }

    void rethrow() const {
        if (error_) {
            std::rethrow_exception(error_);
        }
    }

private:
    std::optional<std::size_t> take() {
        const std::lock_guard lock(mutex_);
        return next_ < tasks_ && !error_ ? std::optional(next_++) : std::nullopt;
    }

    std::size_t tasks_, next_ = 0, failed_ = 0;
    const std::function<void(std::size_t)>& task_;
    std::mutex mutex_;
    std::exception_ptr error_;
};

} // namespace

int thread_count() {
    if (const LoopMeter* const meter = LoopMeter::of_this_thread(); meter != nullptr) {
        return meter->threads();
    }
    return Crew::own_crew != nullptr ? Crew::own_crew->threads() : requested_threads.load();
}

void set_thread_count(int threads) {
    static std::mutex changing;
    const std::lock_guard alone(changing);
    while (pool != nullptr && idle_pool.exchange(nullptr) == nullptr) { // another thread is within a loop
        std::this_thread::yield();
    }
    requested_threads = std::max(1, threads);
    pool = requested_threads > 1 ? std::make_unique<Pool>(requested_threads) : nullptr;
    idle_pool = pool.get();
}

std::size_t home_of(std::size_t block, std::size_t blocks) {
    const auto threads = static_cast<std::size_t>(thread_count());
    std::size_t thread = block * threads / blocks;
    while (first_block(thread + 1, blocks, threads) <= block) {
        ++thread;
    }
    return thread;
}

void detail::run_blocks(std::size_t blocks, Help help, const std::function<void(std::size_t, std::size_t)>& body) {
    if (blocks == 0) {
        return;
    }
    if (blocks == 1 || inside_a_loop) {
        return run_alone(blocks, body);
    }
    if (LoopMeter* const meter = LoopMeter::of_this_thread(); meter != nullptr) {
        const Within loop;
        return meter->measure(blocks, body);
    }
    if (Crew::own_crew != nullptr) {
        return run_in(Crew::own_crew->pool(), blocks, help, body);
    }
    const PoolForOneLoop threads;
    run_in(threads.get(), blocks, help, body);
}

void run_side_by_side(std::size_t tasks, int at_once, const std::function<void(std::size_t)>& task) {
    const auto workers = static_cast<int>(std::min<std::size_t>(tasks, static_cast<std::size_t>(std::max(at_once, 1))));
    TaskQueue queue(tasks, task);
    if (workers <= 1 || inside_a_loop) {
        queue.work();
        return queue.rethrow();
    }
    const int all = thread_count();
    std::atomic<int> working = workers;
    std::vector<std::jthread> threads;
    for (int w = 0; w < workers; ++w) {
        threads.emplace_back([&] {
            const Crew own(all, working);
            queue.work();
        });
    }
    threads.clear(); // waits for all
    queue.rethrow();
}

} // namespace suffuse
