#pragma once
// From where on fines of weight count as moving, lifted or fallen: shares of a grain's own diameter, and of the number
// of fines.

#include <cstdint>

namespace suffuse::erosion {

// The rest: bursts until so few of the free fines still move. Measured against longer rests in docs/theory/weight.md.

/// Whether a grain that went so far [m] in a burst of the rest is still on its way.
constexpr bool moves_in_rest(double distance, double diameter) {
    return distance > 0.02 * diameter;
}

/// Whether so few of the free fines are on their way that all count as resting.
constexpr bool are_resting(std::int64_t moving, std::int64_t free) {
    return static_cast<double>(moving) <= 0.002 * static_cast<double>(free);
}

/// Whether a grain fell so far [m] that it lay in another place before.
constexpr bool has_fallen(double distance, double diameter) {
    return distance > 0.5 * diameter;
}

// A step of the ramp; distances along the flow, in diameters.

/// Whether a grain that was `before` at the furthest went on in a burst.
constexpr bool goes_on(double now, double before) {
    return now > before + 0.01;
}

/// Whether a grain left its seat: it may lie against the roof of its cage.
constexpr bool is_lifted(double advance) {
    return advance > 0.1;
}

/// Share of the longest hold that a gradient is given where so much of the fines' mass is mobile before it, and it is
/// higher by `step`. Where the gradients that move 1 and 10 % are known, what creeps is left to lower bounds: the ramp
/// then rises by a tenth in a fifth of that time, whatever its steps.
constexpr double share_of_hold(double mobile_mass_share, double step) {
    constexpr double share = 0.2, of_step = 0.1;
    return mobile_mass_share < 0.1 ? 1 : share * (step < of_step ? step / of_step : 1);
}

/// Whether so many of the fines have moved since the flow was solved that it is solved anew.
/// @param moved mean over the fines' mass, in diameters, each grain by one at most [-]
constexpr bool is_flow_old(double moved) {
    return moved > 3e-3;
}

} // namespace suffuse::erosion
