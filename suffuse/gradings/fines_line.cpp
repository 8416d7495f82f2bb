#include "suffuse/gradings/fines_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace suffuse::gradings {

namespace {

enum class FinesMeaning { Open, Washed, Result };

/// What all sieves hold, and the pan alone, by sieves whose amounts may be cumulative.
struct Held {
    double on_sieves = 0, in_pan = 0; ///< [kg]
};

Held find_held(const SievedSoil& soil) {
    const bool is_cumulative = soil.meaning == ShareMeaning::CumulativeRetained;
    Held held{0, *soil.pan};
    for (const SieveRow& sieve : soil.sieves) {
        held.on_sieves = is_cumulative ? std::max(held.on_sieves, sieve.amount) : held.on_sieves + sieve.amount;
    }
    held.in_pan -= is_cumulative && *soil.pan >= held.on_sieves ? held.on_sieves : 0;
    return held;
}

FinesMeaning find_meaning(const FinesLine& fines, const SievedSoil& soil) {
    constexpr double lost = 0.01, rounding = 0.006, printed = 1e-3;
    const Held held = find_held(soil);
    const double mass = fines.number * fines.unit, without = held.on_sieves + held.in_pan, with = without + mass;
    if (const auto whole = soil.total ? soil.total : soil.dry) {
        const auto off = [&](double sum) {
            return std::min(std::abs(*whole - sum), std::abs(*whole - sum - soil.lost)) / *whole;
        };
        if (std::min(off(with), off(without)) <= lost) {
            return off(with) < off(without) ? FinesMeaning::Washed : FinesMeaning::Result;
        }
    }
    const bool is_pan = std::abs(mass - held.in_pan) <= printed * held.in_pan;
    const bool is_share = !fines.is_mass && std::abs(fines.number / 100 - held.in_pan / without) <= rounding;
    return is_pan || is_share ? FinesMeaning::Result : FinesMeaning::Open;
}

} // namespace

bool settle_fines(SievedSoil& soil, Problems& problems) {
    if (!soil.fines) {
        return true;
    }
    const FinesLine& fines = *soil.fines;
    const double mass = fines.number * fines.unit;
    const FinesMeaning meaning = find_meaning(fines, soil);
    if (meaning == FinesMeaning::Open) {
        problems.error(
            "E504", fines.place,
            fmt::format(
                "`{}` has {:.6g}, and a pan is given, too: {:.6g} g that were washed out, or a result?", fines.name,
                fines.number, 1e3 * mass
            ),
            "name the line `washed fines` if its mass comes on top of the pan's, or `fines [%]` if it is a result"
        );
        return false;
    }
    if (meaning == FinesMeaning::Washed) {
        *soil.pan += mass;
    }
    problems.warning(
        sheet_remark, fines.place,
        meaning == FinesMeaning::Washed
            ? fmt::format(
                  "`{}` is added to the pan: with its {:.6g} g the stated total is complete", fines.name, 1e3 * mass
              )
            : fmt::format("`{}` is skipped as a result: its grains are in the pan", fines.name)
    );
    return true;
}

} // namespace suffuse::gradings
