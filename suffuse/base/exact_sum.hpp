#pragma once
// A sum of doubles that does not depend on the order of its terms, nor on zeros among them: each term is rounded to a
// multiple of a fixed quantum, and whole multiples are added as integers, which is exact [Demmel & Nguyen 2013, the
// idea]. Adding a large constant does the rounding, so it runs in vector lanes.

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace suffuse {

/// The quantum of a sum. Terms are exact to half of it.
class SumQuantum {
public:
    /// @param largest_term no term is larger; @param largest_sum nor the sum, at any time
    SumQuantum(double largest_term, double largest_sum)
        : exponent_(std::max(bits(largest_term) - 51, bits(largest_sum) - 62)),
          shift_(std::ldexp(1.5, exponent_ + 52)) {}

    /// `term` in quanta, to be added as integers.
    [[gnu::always_inline]] [[nodiscard]] std::uint64_t count(double term) const {
        return std::bit_cast<std::uint64_t>(term + shift_) - std::bit_cast<std::uint64_t>(shift_);
    }

    [[nodiscard]] double value(std::uint64_t quanta) const {
        return std::ldexp(static_cast<double>(static_cast<std::int64_t>(quanta)), exponent_);
    }

private:
    /// Of the whole part of `a` in quanta of one.
    static int bits(double a) { return std::ilogb(std::max(a, 1e-200)) + 1; }

    int exponent_;
    double shift_; ///< its last bit is the quantum
};

} // namespace suffuse
