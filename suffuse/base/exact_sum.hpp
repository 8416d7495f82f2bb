#pragma once
// A sum of doubles that does not depend on the order of its terms, nor on zeros among them: each term is first rounded
// to a multiple of a fixed quantum, and the remainder to one of a much finer quantum; sums of multiples are exact
// [Demmel and Nguyen 2013, the idea]. Adding and subtracting a large constant does the rounding, so it runs in vector
// lanes.

#include <cmath>

namespace suffuse {

/// The quanta of a sum whose value stays below `bound`: relative to it 2^-52 and 2^-82, for up to 2^24 terms.
struct SumQuanta {
    double coarse = 0, fine = 0; ///< constants whose last bit is the quantum

    explicit SumQuanta(double bound) {
        const int exponent = std::ilogb(bound) + 1;
        coarse = std::ldexp(1.5, exponent);
        fine = std::ldexp(1.5, exponent - 30);
    }
};

/// Adds `term` to the two parts of a sum.
[[gnu::always_inline]] inline void add_exactly(const SumQuanta& quanta, double term, double& coarse, double& fine) {
    const double high = (term + quanta.coarse) - quanta.coarse;
    coarse += high;
    fine += ((term - high) + quanta.fine) - quanta.fine;
}

} // namespace suffuse
