#pragma once
// Parallel loops whose result does not depend on the number of threads: work is cut into blocks of a fixed size,
// partial sums are combined in block order. The pool spins briefly before it sleeps, so that a step of 100 microseconds
// pays no wake-up, and a machine shared with other programs is not blocked by idle spinning.

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

namespace suffuse {

/// Number of threads that parallel loops use, at least 1. Set once at the start of a program, or by a test.
int thread_count();
void set_thread_count(int threads);

namespace detail {
/// Calls `body(first, last)` over [0, blocks) cut into one contiguous run of blocks per thread.
void run_blocks(std::size_t blocks, const std::function<void(std::size_t, std::size_t)>& body);
} // namespace detail

/// Calls `body(first, last)` on consecutive ranges of at most `block` rows that cover [0, rows).
template <class Body>
void parallel_for(std::size_t rows, std::size_t block, Body&& body) {
    const std::size_t blocks = (rows + block - 1) / block;
    detail::run_blocks(blocks, [&](std::size_t begin, std::size_t end) {
        for (std::size_t b = begin; b < end; ++b) {
            body(b * block, std::min(rows, (b + 1) * block));
        }
    });
}

/// Sum of `body(first, last)` over the blocks of [0, rows), added in block order: the same bits for any thread count.
template <class T, class Body, class Add = std::plus<>>
T parallel_sum(std::size_t rows, std::size_t block, T zero, Body&& body, Add add = {}) {
    const std::size_t blocks = (rows + block - 1) / block;
    std::vector<T> partial(blocks, zero);
    detail::run_blocks(blocks, [&](std::size_t begin, std::size_t end) {
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
