#include "suffuse/plan/priced_sample.hpp"

#include "suffuse/contact/springs.hpp"
#include "suffuse/dem/stable_dt.hpp"
#include "suffuse/grains/gradation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace suffuse::plan {
namespace {

// The stable time step over that of the stiffest pair, and how steeply it falls with that pair's stiffness: power
// iterations on the networks of examples/silty-sand-2016, whose fines touch grains 3.5 times their size.
constexpr double loose_share = 0.535, dense_share = 0.474;
constexpr double dense_coordination = 6.2, loose_coordination = 3.4;
constexpr double stiffness_exponent = 0.57;

// Work of a step: a grain's own, and that of its contacts, in grains of the lattice of measure_speed [-].
constexpr double work_of_grain = 0.3, work_of_contact = 0.25;
constexpr double work_of_pushing = 0.14; // of a contact without friction: 6.8 ns for 11.9 (docs/performance.md)

constexpr double critical_coordination = 3.5, critical_rattlers = 0.33;
constexpr double collapsed_solid_fraction = 0.53; // of equal grains whose skeleton fell in under load

PricedFraction describe_fraction(const grains::Grains& grains, bool fine) {
    PricedFraction fraction;
    for (std::size_t g = 0; g < grains.size(); ++g) {
        if ((grains.fine[g] != 0) == fine) {
            fraction.grains += 1;
            fraction.mass += grains.mass[g];
            fraction.smallest = std::min(fraction.smallest, 2 * grains.radius[g]);
            fraction.largest = std::max(fraction.largest, 2 * grains.radius[g]);
        }
    }
    fraction.median = grains::size_at(grains::measure_gradation_of(grains, fine), 0.5);
    return fraction;
}

void describe_classes(const grains::Grains& grains, PricedSample& sample) {
    std::map<std::pair<int, std::uint8_t>, packing::SizeClass> classes;
    double solid = 0;
    for (std::size_t g = 0; g < grains.size(); ++g) {
        const double d = 2 * grains.radius[g], volume = d * d * d;
        packing::SizeClass& own = classes[{static_cast<int>(std::lround(4 * std::log2(d))), grains.fine[g]}];
        own.diameter += volume * d;
        own.volume += volume;
        solid += volume;
    }
    for (auto& [key, own] : classes) {
        own.diameter /= own.volume;
        own.volume /= solid;
        sample.classes.push_back(own);
        sample.is_fine.push_back(key.second);
    }
}

/// The solid fraction at which the fraction of that kind would jam first [-].
double first_to_jam(const PricedSample& sample, double alone, bool fine) {
    const std::vector<double> fractions = packing::jamming_fractions(sample.classes, alone);
    double least = std::numeric_limits<double>::max();
    for (std::size_t k = 0; k < fractions.size(); ++k) {
        least = (sample.is_fine[k] != 0) == fine ? std::min(least, fractions[k]) : least;
    }
    return least;
}

double largest_diameter(const PricedSample& sample) {
    return std::max(sample.coarse.largest, sample.fines.largest);
}

/// Of two touching grains of the sample [rad/s].
double pair_frequency(
    const PricedSample& sample, double first, double second, const dem::Lent& lent, const grains::Material& material
) {
    const auto grain = [&](double radius) {
        const dem::InertiaFactors more =
            dem::lent_factors(lent, radius, 0.5 * sample.median, 0.5 * largest_diameter(sample));
        const double mass = more.mass * material.density * sphere_volume(radius);
        return dem::Inertia{radius, mass, more.turning * sphere_inertia(mass, radius)};
    };
    const grains::Material linear = as_pressed(sample, material);
    return dem::pair_frequency(linear, linear.shear_ratio, grain(first), grain(second));
}

/// Of grains that touch their like, or the largest [rad/s].
struct PairFrequencies {
    double alike = 0, unlike = 0;
};

/// The smallest are the quickest, unless they are lent inertia.
PairFrequencies stiffest_pairs(const PricedSample& sample, const grains::Material& material, const dem::Lent& lent) {
    const double large = 0.5 * largest_diameter(sample);
    PairFrequencies stiffest;
    for (const double r : {0.5 * smallest_diameter(sample), 0.5 * sample.median, large}) {
        stiffest.alike = std::max(stiffest.alike, pair_frequency(sample, r, r, lent, material));
        stiffest.unlike = std::max(stiffest.unlike, pair_frequency(sample, r, large, lent, material));
    }
    return stiffest;
}

/// Of 2 over the highest frequency, that a time step is.
double usual_share(const PricedSample& sample, const grains::Material& material) {
    return dem::default_step_safety * dem::share_when_damped(sample.damping, material.viscous_damping);
}

} // namespace

grains::Material as_pressed(const PricedSample& sample, const grains::Material& material) {
    return contact::linearized(material, contact::mean_overlap_at(material, sample.pressure));
}

PricedSample describe(const grains::Grains& grains, double damping) {
    PricedSample sample;
    sample.damping = damping;
    sample.coarse = describe_fraction(grains, false);
    sample.fines = describe_fraction(grains, true);
    sample.median = grains::median_diameter(grains);
    describe_classes(grains, sample);
    return sample;
}

double mixed_solid_fraction(const PricedSample& sample, double alone) {
    return std::min(first_to_jam(sample, alone, false), first_to_jam(sample, alone, true));
}

packing::EqualGrains state_at(const PricedSample& sample, double solid_fraction) {
    double least = 0.3, most = 0.74;
    while (most - least > 1e-4) {
        const double alone = 0.5 * (least + most);
        (mixed_solid_fraction(sample, alone) < solid_fraction ? least : most) = alone;
    }
    return packing::equal_grains_at(least);
}

void take_state(PricedSample& sample, const packing::EqualGrains& state) {
    sample.coordination = state.coordination;
    sample.solid_fraction = mixed_solid_fraction(sample, state.solid_fraction);
    sample.coarse.carrying = 1 - state.rattlers;
    const bool is_mixed = sample.coarse.grains > 0 && sample.fines.grains > 0;
    sample.fines.carrying = 1 - state.rattlers;
    if (is_mixed) {
        const double alone = state.solid_fraction;
        sample.fines.carrying =
            packing::carrying_share(state, first_to_jam(sample, alone, false) / first_to_jam(sample, alone, true));
    }
}

void take_critical_state(PricedSample& sample) {
    const double before = sample.coordination;
    sample.coordination = critical_coordination;
    const double carrying = 1 - critical_rattlers;
    sample.coarse.carrying = carrying;
    if (before > critical_coordination) { // loosely packed fines carry no less than before
        sample.fines.carrying = std::min(sample.fines.carrying, carrying);
    }
}

void take_fines(PricedSample& sample) {
    const double skeleton = sample.solid_fraction * (1 - fines_content(sample));
    sample.fines = {};
    sample.median = sample.coarse.median;
    sample.fines_left = {1, 1};
    for (std::size_t k = sample.classes.size(); k-- > 0;) {
        if (sample.is_fine[k] != 0) {
            sample.classes.erase(sample.classes.begin() + static_cast<std::ptrdiff_t>(k));
            sample.is_fine.erase(sample.is_fine.begin() + static_cast<std::ptrdiff_t>(k));
        }
    }
    double solid = 0;
    for (const packing::SizeClass& own : sample.classes) {
        solid += own.volume;
    }
    for (packing::SizeClass& own : sample.classes) {
        own.volume /= solid;
    }
    const double collapsed = mixed_solid_fraction(sample, collapsed_solid_fraction);
    take_state(sample, state_at(sample, std::max(skeleton, collapsed)));
    sample.solid_fraction = std::max(skeleton, collapsed);
}

double fines_content(const PricedSample& sample) {
    return sample.fines.mass / (sample.fines.mass + sample.coarse.mass);
}

double smallest_diameter(const PricedSample& sample) {
    return std::min(sample.coarse.smallest, sample.fines.smallest);
}

bool fines_sift(const PricedSample& sample) {
    constexpr double through_three_that_touch = 6.464; // size ratio
    return sample.coarse.median > through_three_that_touch * sample.fines.median;
}

double count(const PricedSample& sample) {
    return sample.coarse.grains + sample.fines.grains;
}

double loose_time_step(const PricedSample& sample, const grains::Material& material) {
    const PairFrequencies of = stiffest_pairs(sample, material, {});
    return usual_share(sample, material) * 2 / (dem::quicker_than_pair * std::max(of.alike, of.unlike));
}

double settled_time_step(const PricedSample& sample, const grains::Material& material, const dem::Lent& lent) {
    const PairFrequencies of = stiffest_pairs(sample, material, lent);
    const double stiffer = std::max(1.0, of.unlike / of.alike);
    const double dense = (sample.coordination - loose_coordination) / (dense_coordination - loose_coordination);
    const double share = loose_share + std::clamp(dense, 0.0, 1.0) * (dense_share - loose_share);
    return usual_share(sample, material) * 2 * share * std::pow(stiffer, -stiffness_exponent) / of.alike;
}

Range work_of_step(const PricedSample& sample, bool only_pushes) {
    const double of_contact = only_pushes ? work_of_pushing : work_of_contact;
    const auto work = [&](double left) {
        const double fines = sample.fines.grains, carrying = std::min(left, sample.fines.carrying) * fines;
        return work_of_grain * (sample.coarse.grains + left * fines) +
               of_contact * sample.coordination * (sample.coarse.carrying * sample.coarse.grains + carrying);
    };
    return {work(sample.fines_left.least), work(sample.fines_left.most)};
}

} // namespace suffuse::plan
