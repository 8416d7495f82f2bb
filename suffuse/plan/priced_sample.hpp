#pragma once
// What a plan knows of a sample at the end of a stage before it is run: its grains, how dense they will lie, how many
// of them will carry load, and so how long a stable time step is and how much work a step.

#include "suffuse/base/range.hpp"
#include "suffuse/dem/lent_inertia.hpp"
#include "suffuse/dem/spec.hpp"
#include "suffuse/grains/grains.hpp"
#include "suffuse/grains/material.hpp"
#include "suffuse/packing/expected_state.hpp"

#include <cstdint>
#include <limits>
#include <vector>

namespace suffuse::plan {

/// Grains of a fraction.
struct PricedFraction {
    double grains = 0;
    double mass = 0;                                      ///< [kg]
    double smallest = std::numeric_limits<double>::max(); ///< diameter [m]
    double largest = 0, median = 0;                       ///< diameters, the median by mass [m]
    double carrying = 1;                                  ///< share of the grains that carries load [-]
};

struct PricedSample {
    PricedFraction coarse, fines;
    std::vector<packing::SizeClass> classes; ///< of both, in steps of a fourth root of two
    std::vector<std::uint8_t> is_fine;       ///< of each class
    Range fines_left{1, 1};                  ///< share of the fines that earlier stages leave [-]
    double pressure = 100e3;                 ///< mean stress [Pa]
    double damping = dem::usual_damping;     ///< local [-]
    double solid_fraction = 0.35;            ///< [-]
    double coordination = 0;                 ///< of grains that carry load [-]
    double median = 0;                       ///< diameter by mass [m]
};

PricedSample describe(const grains::Grains& grains, double damping = dem::usual_damping);

/// The sample after a preparation that makes of equal grains these.
void take_state(PricedSample& sample, const packing::EqualGrains& state);

/// Solid fraction of this sample where equal grains have that one [-].
double mixed_solid_fraction(const PricedSample& sample, double alone);

/// Equal grains that make this sample as dense as that [-].
packing::EqualGrains state_at(const PricedSample& sample, double solid_fraction);

/// Without any of its fines, and with the skeleton collapsed where it then is looser than its loosest.
void take_fines(PricedSample& sample);

/// Sheared on: as many contacts as slide past each other steadily, whatever the preparation.
void take_critical_state(PricedSample& sample);

double fines_content(const PricedSample& sample);     ///< of the mass [-]
double smallest_diameter(const PricedSample& sample); ///< [m]
bool fines_sift(const PricedSample& sample);          ///< half of them fit through the tightest holes
double count(const PricedSample& sample);             ///< grains before any erosion

/// The linear law that is as stiff as the material at the sample's pressure.
grains::Material as_pressed(const PricedSample& sample, const grains::Material& material);

/// The stable time step of the settled sample [s].
double settled_time_step(const PricedSample& sample, const grains::Material& material, const dem::Lent& lent = {});

/// The same of a cloud whose grains just touch [s].
double loose_time_step(const PricedSample& sample, const grains::Material& material);

/// Work of a step, in grains of the packing that measure_speed steps. @param only_pushes contacts have no friction
Range work_of_step(const PricedSample& sample, bool only_pushes = false);

} // namespace suffuse::plan
