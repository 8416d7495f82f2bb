#pragma once
// A laboratory test from the state given, along one of the paths of `Path`. World in, rows out.

#include "suffuse/dem/energy.hpp"
#include "suffuse/dem/lent_inertia.hpp"
#include "suffuse/dem/settle.hpp"
#include "suffuse/triaxial/pore_fluid.hpp"
#include "suffuse/triaxial/spec.hpp"

#include <optional>
#include <vector>

namespace suffuse::triaxial {

/// One row of the stress-strain curve.
struct PathRow {
    double axial_strain = 0;            ///< logarithmic, since the start of the test [-]
    double volumetric_strain = 0;       ///< compression positive [-]
    Mat3 stress;                        ///< [Pa]
    double mean_stress = 0;             ///< p [Pa]
    double deviator_stress = 0;         ///< q = axial minus mean lateral stress [Pa]
    double void_ratio = 0;              ///< [-]
    double coordination = 0;            ///< contacts per grain, twice the number over the grains [-]
    double mechanical_coordination = 0; ///< the same without rattlers [-]
    double unbalanced_force = 0;        ///< [-]
    double inertial_number = 0;         ///< [-]
    double hold_error = 0;              ///< of the stress held that is furthest off, over it [-]
    double second_order_work = 0;       ///< since the row before [J/m3]
    /// Undrained, constant deviator: of the water, where the total lateral stress is held [Pa]
    double excess_pore_pressure = 0;
    double shear_strain = 0; ///< of simple shear: displacement of the top over the height of the start [-]
    int leg = 0;             ///< from one turn of the load to the next: which one it ends or belongs to
    dem::EnergyParts energy; ///< since the start of the test, over the volume then [J/m3]
};

/// Where a test stands; part of what a checkpoint saves, with `rows`.
struct PathState {
    enum class Phase : std::int32_t { Shear, Settle, Done };

    Phase phase = Phase::Shear;
    int leg = 0;                ///< see PathRow
    double sense = 1;           ///< of this leg: 1 where the axial strain grows, -1 where it falls
    PathRow turn;               ///< where the leg began
    Mat3 start_h;               ///< cell at the start of the test [m]
    Mat3 start_stress;          ///< [Pa]
    double strain_rate = 0;     ///< axial, compression positive; constant deviator: twice the lateral extension's [1/s]
    double pace = 1;            ///< share of that rate: where stresses are held, and near a stress to stop at [-]
    double least_pace = 1e-3;   ///< near a stress to stop at; grows, for not every sample comes there [-]
    double median_diameter = 0; ///< by mass, of the inertial number [m]
    dem::Lent lent;             ///< inertia that grains have beyond their own
    double time_step = 0;       ///< [s]
    std::int64_t known_contacts = 0; ///< touching when it was chosen
    dem::BalanceState balance;
    dem::EnergyBalance energy; ///< of the shear, until the sample is left to rest
    std::int64_t steps = 0;
    double storage = 0;    ///< undrained: volumetric strain over the pore pressure that it needs; 0: none [1/Pa]
    double skempton_b = 1; ///< [-]
    double water_rate = 0; ///< of volumetric strain in this burst [1/s]
    std::vector<PathRow> rows;
};

/// Size of q at which a test stops, of a sample that bears this mean stress [Pa]; nothing where it goes to a strain.
std::optional<double> deviator_to_stop_at(const TriaxialSpec& spec, double mean_stress);

/// Legs between the turns of the test: of stresses to come to, or halves of cycles.
int count_legs(const TriaxialSpec& spec);

/// What a test lends: nothing with a given time step, nor at a constant deviator, where a sample that fails under the
/// loads that it bears flows as its own inertia lets it; frictionless grains do not turn.
dem::Lent lent_during(const TriaxialSpec& spec, const grains::Material& material);

/// Axial rate at which the test is quasi-static [1/s]: its inertial number allows for the turning that it slows down.
/// @param median by mass [m]; @param pressure at the start [Pa]
double strain_rate_of(const TriaxialSpec& spec, const grains::Material& material, double median, double pressure);

/// Of the plane that a path shears, positive along the shear [Pa].
double shear_stress(const TriaxialSpec& spec, const Mat3& stress);

/// Whether a test whose loads go to and fro has brought the sample to what counts as liquefied, or as failed.
bool has_liquefied(const TriaxialSpec& spec, const PathState& state, const PathRow& row);

/// Lends the grains what inertia the test may lend; its last burst of shear takes it back.
/// @param stress of the state that the test starts from [Pa]; @param fluid of an undrained test; nothing: the fluid is
/// incompressible
/// @throws StateError when the sample carries none, or no deviator stress to hold; CaseError when strain, inertial
/// number or rows are not above zero, or keys do not belong to the path.
PathState
begin_path(dem::World& world, const TriaxialSpec& spec, const Mat3& stress, const std::optional<PoreFluid>& fluid = {});

/// One burst of steps; appends a row when the strain has grown by the specified interval. @return whether the test is
/// over.
/// @throws StateError when the specified stress is not reached within the strain, or not held.
bool path_burst(
    dem::World& world, dem::StepCaches& caches, const TriaxialSpec& spec, const dem::BalanceSpec& balance,
    double damping, dem::Mode mode, PathState& state
);

/// Takes back what the test has lent: of a test that did not come to its end.
void give_back(dem::World& world, PathState& state);

/// Second-order work between two rows, d stress : d strain, for equal lateral strains [J/m3] [Hill 1958]
double second_order_work(const PathRow& before, const PathRow& after);

} // namespace suffuse::triaxial
