#pragma once
// Parallel loops whose result does not depend on the number of threads: work is cut into blocks of a fixed size,
// partial sums are combined in block order. The pool spins briefly before it sleeps, so that a step of 100 microseconds
// pays no wake-up, and a machine shared with other programs is not blocked by idle spinning.

#include "suffuse/base/large_pages.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace suffuse {

/// Number of threads that the parallel loops of the calling thread use, at least 1. Set once at the start of a program,
/// or by a test; a task of `run_side_by_side` has its share of them. One loop at a time has them: where two threads of
/// the program loop at once, the second runs its loop alone.
int thread_count();
void set_thread_count(int threads);

/// Which of the threads of this moment has `block` in its share of a loop over `blocks`.
std::size_t home_of(std::size_t block, std::size_t blocks);

/// When a thread that has done its share of a loop takes blocks of another's.
enum class Help {
    AtOnce,
    Late, ///< when the other seems to have been put aside: what a block works on lies in the cache of its own thread,
          ///< and to bring it from there may take longer than the work
};

namespace detail {
/// Calls `body(first, last)` over [0, blocks) cut into one contiguous run of blocks per thread.
void run_blocks(std::size_t blocks, Help help, const std::function<void(std::size_t, std::size_t)>& body);
} // namespace detail

/// Calls `task(0)`, `task(1)`, ... each once, started in this order and at most `at_once` of them at a time, each on a
/// thread of its own; the parallel loops of a task run on its share of the threads, `thread_count() / at_once`, and on
/// more as soon as no task is left to begin and others have ended. One at a time they run on the calling thread with
/// all threads. Where a task throws, no further one begins; when those that run have ended, the exception of the first
/// of them (by number) is thrown.
void run_side_by_side(std::size_t tasks, int at_once, const std::function<void(std::size_t)>& task);

/// Calls `body(first, last)` on consecutive ranges of at most `block` rows that cover [0, rows).
template <class Body>
void parallel_for(std::size_t rows, std::size_t block, Help help, Body&& body) {
    const std::size_t blocks = (rows + block - 1) / block;
    auto loop = [&](std::size_t begin, std::size_t end) {
        for (std::size_t b = begin; b < end; ++b) {
            body(b * block, std::min(rows, (b + 1) * block));
        }
    };
    detail::run_blocks(blocks, help, std::ref(loop)); // a reference: nothing is allocated
}

template <class Body>
void parallel_for(std::size_t rows, std::size_t block, Body&& body) {
    parallel_for(rows, block, Help::AtOnce, std::forward<Body>(body));
}

/// Gives every column `rows` rows, each on one of the threads, in large pages: the first touch of fresh memory takes
/// longer than much of what is then written there.
template <class... Columns>
void resize_columns(std::size_t rows, Columns&... columns) {
    const std::array<std::function<void()>, sizeof...(columns)> resize = {[&columns, rows] {
        reserve_in_large_pages(columns, rows);
        columns.resize(rows);
    }...};
    parallel_for(resize.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            resize[k]();
        }
    });
}

/// Sum of `body(first, last)` over the blocks of [0, rows), added in block order: the same bits for any thread count.
template <class T, class Body, class Add = std::plus<>>
T parallel_sum(std::size_t rows, std::size_t block, T zero, Body&& body, Add add = {}) {
    const std::size_t blocks = (rows + block - 1) / block;
    std::vector<T> partial(blocks, zero);
    detail::run_blocks(blocks, Help::AtOnce, [&](std::size_t begin, std::size_t end) {
        for (std::size_t b = begin; b < end; ++b) {
            partial[b] = body(b * block, std::min(rows, (b + 1) * block));
        }
    });
    T total = zero;
    for (const T& value : partial) {
        total = add(total, value);
    }
    return total;
}

} // namespace suffuse
