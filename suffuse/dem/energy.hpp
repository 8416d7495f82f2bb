#pragma once
// Where the work goes that is done on a sample: springs and motion hold some of it, slip, rolling and damping take the
// rest. Looked at between bursts of steps, from the state and the law alone: a step pays nothing for it.

#include "suffuse/dem/settle.hpp"
#include "suffuse/dem/world.hpp"

namespace suffuse::dem {

/// What takes energy in the step to come [W].
struct Dissipation {
    double slip = 0;    ///< of contacts at the Coulomb limit, and under Hertz's law at the edge of their area
    double rolling = 0; ///< of contacts at the limit of their bending or twisting moment
    double damping = 0; ///< local damping of the grains' motion, a help of the calculation and no property of a soil;
                        ///< and viscous damping of contacts
};

constexpr Dissipation operator+(const Dissipation& a, const Dissipation& b) {
    return {a.slip + b.slip, a.rolling + b.rolling, a.damping + b.damping};
}

/// Where the work of a path has gone so far [J].
struct EnergyParts {
    double work = 0;    ///< done on the sample by its cell, V stress : d strain
    double springs = 0; ///< held more than at the start: normal, shear, bending and twisting springs
    double motion = 0;  ///< held more than at the start: motion against the mean one, spin included
    double slip = 0, rolling = 0, damping = 0; ///< taken, see Dissipation

    [[nodiscard]] double unaccounted() const { return work - springs - motion - slip - rolling - damping; }
};

constexpr EnergyParts operator*(double s, const EnergyParts& a) {
    return {s * a.work, s * a.springs, s * a.motion, s * a.slip, s * a.rolling, s * a.damping};
}

constexpr EnergyParts operator+(const EnergyParts& a, const EnergyParts& b) {
    return {a.work + b.work, a.springs + b.springs, a.motion + b.motion,
            a.slip + b.slip, a.rolling + b.rolling, a.damping + b.damping};
}

/// Followed from look to look: the parts add up to the work within what dissipation scatters by between two looks.
struct EnergyBalance {
    EnergyParts parts;
    double springs_before = 0, motion_before = 0; ///< at the start [J]
    Dissipation rate;                             ///< at the last look
    Mat3 h, stress;                               ///< cell and its stress at the last look [m], [Pa]
    double time = 0;                              ///< of the last look [s]
};

/// Energy in the springs of all contacts [J].
double spring_energy(const World& world);

/// What the next step of this length takes, without load and drag. @param dt [s]; @param damping local [-]
Dissipation measure_dissipation(const World& world, double dt, double damping);

/// A balance that begins at the state `world`, at rest, whose stress and motion `seen` has.
EnergyBalance begin_balance(const World& world, const BalanceState& seen);

/// Goes on to the state `world` of a later look. @param dt of the steps that led there [s]; @param damping local [-]
void follow(EnergyBalance& balance, const World& world, const BalanceState& seen, double dt, double damping);

} // namespace suffuse::dem
