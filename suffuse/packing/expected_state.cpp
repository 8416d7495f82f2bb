#include "suffuse/packing/expected_state.hpp"

#include "suffuse/base/error.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace suffuse::packing {
namespace {

// Samples of examples/silty-sand-2016 (frictionless, adhesive: fines contents 0 and 100 %) and fontainebleau-2016 (10
// deg), at 100 kPa with a contact friction of 37 deg. The fourth lies between by friction.
struct Prepared {
    double friction; ///< its tangent [-]
    EqualGrains state;
};

const std::array<Prepared, 3> by_friction = {{
    {0, {0.641, 6.2, 0.02, 0.905, 40}},
    {0.176, {0.575, 4.65, 0.20, 0.97, 25}},
    {0.754, {0.545, 4.0, 0.30, 1.05, 15}},
}};
constexpr EqualGrains sticking{0.515, 3.4, 0.37, 1.13, 10};
constexpr double never_idle = 0.06; // of the fines touch two grains however much room they have

double between(double a, double b, double share) {
    return a + share * (b - a);
}

EqualGrains between(const EqualGrains& a, const EqualGrains& b, double share) {
    return {
        between(a.solid_fraction, b.solid_fraction, share), between(a.coordination, b.coordination, share),
        between(a.rattlers, b.rattlers, share), between(a.filling, b.filling, share),
        between(a.filling_sharpness, b.filling_sharpness, share)};
}

// What a class loses in density by loosening, where finer grains push it apart, and what it gains at the wall of a
// coarser one [deLarrard1999, 1.21 and 1.22].
double loosening(double fine, double coarse) {
    return std::sqrt(1 - std::pow(1 - fine / coarse, 1.02));
}

double wall_effect(double fine, double coarse) {
    return 1 - std::pow(1 - fine / coarse, 1.5);
}

} // namespace

EqualGrains equal_grains(double friction, bool adheres) {
    if (adheres) {
        return sticking;
    }
    const double tangent = std::clamp(std::tan(friction), by_friction.front().friction, by_friction.back().friction);
    std::size_t k = 1;
    while (k + 1 < by_friction.size() && tangent > by_friction[k].friction) {
        ++k;
    }
    const Prepared &a = by_friction[k - 1], &b = by_friction[k];
    return between(a.state, b.state, (tangent - a.friction) / (b.friction - a.friction));
}

EqualGrains equal_grains_at(double solid_fraction) {
    std::vector<EqualGrains> states{sticking};
    for (auto prepared = by_friction.rbegin(); prepared != by_friction.rend(); ++prepared) {
        states.push_back(prepared->state);
    }
    const double wanted = std::clamp(solid_fraction, states.front().solid_fraction, states.back().solid_fraction);
    std::size_t k = 1;
    while (k + 1 < states.size() && wanted > states[k].solid_fraction) {
        ++k;
    }
    const double from = states[k - 1].solid_fraction, to = states[k].solid_fraction;
    return between(states[k - 1], states[k], (wanted - from) / (to - from));
}

std::vector<double> jamming_fractions(std::span<const SizeClass> classes, double alone) {
    expects(alone > 0 && alone < 1, "a solid fraction lies between 0 and 1");
    std::vector<double> fractions;
    for (const SizeClass& own : classes) {
        double gain = 0;
        for (const SizeClass& other : classes) {
            if (other.diameter > own.diameter) { // solid that stands in for what this class would fill with voids
                gain += (1 - alone) * (1 - wall_effect(own.diameter, other.diameter)) * other.volume;
            } else if (other.diameter < own.diameter) { // finds room in this class's voids
                gain += (1 - loosening(other.diameter, own.diameter)) * other.volume;
            }
        }
        fractions.push_back(alone / (1 - gain));
    }
    return fractions;
}

double carrying_share(const EqualGrains& state, double filling) {
    const double logit = state.filling_sharpness * std::log(filling / state.filling);
    return (1 - state.rattlers) * std::max(never_idle, 1 / (1 + std::exp(-logit)));
}

} // namespace suffuse::packing
