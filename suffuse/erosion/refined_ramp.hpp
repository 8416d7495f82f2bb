#pragma once
// Which gradient fines bear next, so that no step is wider than 0.05, and those that move 1 and 10 % of them are known
// to 0.01. A level that moves too much at once is undone, and a lower one comes before it: the levels that are kept are
// one ramp, each borne by what the one before has left, as in a ramp that was finer from the start.

#include <deque>
#include <optional>
#include <vector>

namespace suffuse::erosion {

inline constexpr double gradient_width = 0.01; ///< of the steps that move 1 and 10 % [-]
inline constexpr double widest_step = 0.05;    ///< up to heave, and where there is none up to 2 [-]

class RefinedRamp {
public:
    /// @param gradients rising, above 0; @param heave at which the whole soil floats: what is mobile is sought below
    /// @param specified a gradient that becomes a level, where the ramp comes to it
    RefinedRamp(std::vector<double> gradients, std::optional<double> heave, std::optional<double> specified);

    /// The gradient to bear now; nothing at the end of the ramp.
    [[nodiscard]] std::optional<double> next() const;

    /// The share of the mass with which next() is undone, however long it is held; nothing where it is kept in any
    /// case.
    [[nodiscard]] std::optional<double> undone_at() const;

    /// Takes the mobile share of the mass at next(). @return whether it is kept; else the fines go back to where the
    /// level before left them
    bool take(double share);

    [[nodiscard]] std::size_t given_count() const { return given_count_; } ///< of levels that do not come of refinement

    [[nodiscard]] std::size_t given_left() const; ///< of them, not yet kept

private:
    struct Level {
        double gradient = 0;
        bool is_given = true;
        double share = 0; ///< of a trial that was undone; 0: none
    };

    void refine();

    std::deque<Level> ahead_;
    std::optional<double> heave_;
    std::size_t given_count_ = 0;
    double gradient_ = 0, share_ = 0; ///< of the last level that was kept
};

} // namespace suffuse::erosion
