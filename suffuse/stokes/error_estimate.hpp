#pragma once
// How far conjugate gradients are from the solution, in the norm of the equations (the power of the forces that are
// wrong). An iteration lessens the square of that by a gain that is known, so that all gains to come are what is left
// (Hestenes and Stiefel). Those of the residual show less: velocities that are nearly still may come from forces that
// are far off.

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace suffuse::stokes {

class ErrorEstimate {
public:
    /// @param iterations that are added without asking for memory
    explicit ErrorEstimate(int iterations) { gains_.reserve(static_cast<std::size_t>(iterations)); }

    void add(double gain) { gains_.push_back(gain); }

    /// Square of the error, infinite as long as too little is known: what the last fifth of the iterations gained, and
    /// more where gains fell so slowly, over that fifth or within it, that as much is still to come.
    [[nodiscard]] double square() const {
        const std::size_t count = gains_.size(), window = std::max<std::size_t>(6, count / 5);
        if (count < 2 * window) {
            return std::numeric_limits<double>::infinity();
        }
        const double whole = sum(count - window, count), half = sum(count - window / 2, count);
        return std::max(
            {whole, left_after(whole, sum(count - 2 * window, count - window)),
             left_after(half, sum(count - window / 2 * 2, count - window / 2))}
        );
    }

private:
    /// Of gains that go on falling as from `before` to `last`.
    static double left_after(double last, double before) {
        const double ratio = before > 0 ? std::min(last / before, 0.9) : 0;
        return last * ratio / (1 - ratio);
    }

    [[nodiscard]] double sum(std::size_t first, std::size_t end) const {
        double total = 0;
        for (std::size_t i = first; i < end; ++i) {
            total += gains_[i];
        }
        return total;
    }

    std::vector<double> gains_;
};

} // namespace suffuse::stokes
