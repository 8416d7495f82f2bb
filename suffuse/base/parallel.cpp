#include "suffuse/base/parallel.hpp"

#include <atomic>
#include <exception>
#include <memory>
#include <thread>
#include <utility>

namespace suffuse {
namespace {

thread_local bool inside_a_loop = false; // a loop within a loop runs on the thread that meets it

constexpr int spins_before_sleep =
    4000; // about 20 microseconds: longer than a barrier inside a step, shorter than a time slice

class Pool {
public:
    explicit Pool(int threads) : errors_(static_cast<std::size_t>(threads)) {
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

    void run(std::size_t blocks, const std::function<void(std::size_t, std::size_t)>& body) {
        body_ = &body;
        blocks_ = blocks;
        pending_.store(static_cast<int>(workers_.size()));
        generation_.fetch_add(1);
        generation_.notify_all();
        work(0);
        for (int spin = 0, left = pending_.load(); left != 0; left = pending_.load()) {
            if (++spin > spins_before_sleep) {
                pending_.wait(left);
            }
        }
        for (std::exception_ptr& error : errors_) {
            if (error) {
                std::rethrow_exception(std::exchange(error, nullptr));
            }
        }
    }

private:
    void work(std::size_t thread) {
        const std::size_t threads = workers_.size() + 1;
        inside_a_loop = true;
        try {
            const std::size_t first = blocks_ * thread / threads;
            const std::size_t last = blocks_ * (thread + 1) / threads;
            if (first < last) {
                (*body_)(first, last);
            }
        } catch (...) {
            errors_[thread] = std::current_exception();
        }
        inside_a_loop = false;
    }

    void serve(std::size_t thread) {
        unsigned seen = 0;
        for (;;) {
            unsigned now = generation_.load();
            for (int spin = 0; now == seen; now = generation_.load()) {
                if (++spin > spins_before_sleep) {
                    generation_.wait(seen);
                }
            }
            seen = now;
            if (stop_) {
                return;
            }
            work(thread);
            if (pending_.fetch_sub(1) == 1) {
                pending_.notify_one();
            }
        }
    }

    std::vector<std::thread> workers_;
    std::vector<std::exception_ptr> errors_;
    const std::function<void(std::size_t, std::size_t)>* body_ = nullptr;
    std::size_t blocks_ = 0;
    std::atomic<unsigned> generation_{0};
    std::atomic<int> pending_{0};
    std::atomic<bool> stop_{false};
};

int requested_threads = 1;
std::unique_ptr<Pool> pool;

} // namespace

int thread_count() {
    return requested_threads;
}

void set_thread_count(int threads) {
    requested_threads = std::max(1, threads);
    pool = requested_threads > 1 ? std::make_unique<Pool>(requested_threads) : nullptr;
}

void detail::run_blocks(std::size_t blocks, const std::function<void(std::size_t, std::size_t)>& body) {
    if (blocks == 0) {
        return;
    }
    if (!pool || blocks == 1 || inside_a_loop) {
        return body(0, blocks);
    }
    pool->run(blocks, body);
}

} // namespace suffuse
