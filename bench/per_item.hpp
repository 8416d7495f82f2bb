#pragma once
// Benchmarks report nanoseconds a grain, a contact, a throat: never bare seconds.

#include <benchmark/benchmark.h>

namespace suffuse::bench {

/// Nanoseconds of an iteration over `items`.
inline benchmark::Counter ns_per(double items) {
    return {items * 1e-9, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert};
}

} // namespace suffuse::bench
