#pragma once
// The tests of a laboratory, from the state that the stage starts from: `do = "triaxial"`, "oedometer", "isotropic",
// "plane-strain", "shear" and "cyclic". They are one test in one apparatus, a cell whose sides each move at a rate or
// bear a stress; a verb sets what is driven, what is held and where the test turns. `do = "stress-probe"`: answers of a
// state to small loads of all directions. `do = "stiffness"`: to small strains of all directions.

#include <cstdint>
#include <optional>
#include <vector>

namespace suffuse::triaxial {

enum class Path {
    Drained,          ///< lateral stresses held
    ConstantMean,     ///< mean stress held
    ConstantDeviator, ///< deviator stress of the start held while the cell widens: pore pressure rises
    Undrained,        ///< volume held
    Proportional,     ///< ratio of volumetric to axial strain held
    // Of other verbs than `triaxial`:
    Isotropic,     ///< all stresses alike
    PlaneStrain,   ///< no strain along one lateral axis, the stress along the other held
    ShearAtVolume, ///< simple shear of a cell whose sides keep their lengths
    ShearAtStress, ///< the same, but for the side along which the stress is held
};

constexpr bool shears(Path path) {
    return path == Path::ShearAtVolume || path == Path::ShearAtStress;
}

enum class Direction { Compression, Extension };

/// Simple shear: layers across `normal` slide along `along`; 0, 1, 2.
struct ShearAxes {
    int normal = 2, along = 0;

    friend bool operator==(const ShearAxes&, const ShearAxes&) = default;
};

/// Loads to and fro.
struct Cycles {
    std::optional<double> csr;         ///< amplitude of the deviator stress over twice the mean stress of the start [-]
    std::optional<double> strain;      ///< or that of the axial strain [-]
    int number = 20;                   ///< the test ends after so many, or before:
    double pore_pressure_ratio = 0.95; ///< of the lateral stress of the start, that water has taken over [-]
    double double_amplitude = 0.05;    ///< axial strain from one turn to the next [-]
};

enum class GrainInertia {
    Lent, ///< as compactions lend it, so that steps are longer: a quasi-static test does not depend on it
    Own,
};

struct TriaxialSpec {
    Path path = Path::Drained;
    GrainInertia inertia = GrainInertia::Lent; ///< a given time step, and a constant deviator, leave grains their own
    int axis = 2;                              ///< 0, 1, 2: the axis compressed
    double strain = 0.2;                ///< axial strain to stop at; constant deviator: or axial minus volumetric [-]
    std::optional<double> strain_ratio; ///< proportional: volumetric over axial strain; 1 is an oedometer [-]
    std::optional<double> deviator_stress; ///< q to stop at, then settle there; the strain is then a limit [Pa]
    std::optional<double> stress_ratio;    ///< q/p to stop at, instead [-]
    double inertial_number = 1e-3;         ///< sets the axial strain rate [-]
    double time_step = 0;                  ///< [s]; 0 = computed
    int rows = 400;                        ///< stress-strain rows recorded over the specified strain
    Direction direction = Direction::Compression;
    std::optional<double> b;      ///< drained: (s2 - s3)/(s1 - s3) of the lateral axis after `axis` [-]
    std::vector<double> stresses; ///< along the axis, to come to one after the other; the strain is then a limit [Pa]
    ShearAxes shear_axes;         ///< of a path that shears
    std::optional<Cycles> cycles;

    /// There it settles; else it ends at a strain.
    [[nodiscard]] bool stops_at_stress() const { return deviator_stress || stress_ratio || !stresses.empty(); }

    /// Axial, or that of the shear: 1 where it grows first, -1 where it falls.
    [[nodiscard]] double sense() const { return direction == Direction::Extension ? -1 : 1; }
};

/// No strain but along the axis.
struct OedometerSpec : TriaxialSpec {
    OedometerSpec() { path = Path::Proportional, strain_ratio = 1; }
};

struct IsotropicSpec : TriaxialSpec {
    IsotropicSpec() { path = Path::Isotropic; }
};

struct PlaneStrainSpec : TriaxialSpec {
    PlaneStrainSpec() { path = Path::PlaneStrain; }
};

struct ShearSpec : TriaxialSpec {
    ShearSpec() { path = Path::ShearAtVolume; }
};

struct CyclicSpec : TriaxialSpec {
    CyclicSpec() { path = Path::Undrained, cycles.emplace(); }
};

/// Loads of one size, in directions spaced equally over the plane of axisymmetric stress.
struct StressProbeSpec {
    int axis = 2; ///< 0, 1, 2: the axis of symmetry
    int directions = 24;
    double increment = 0.05;         ///< norm of the stress increment / mean stress [-]
    std::int64_t ramp = 1000;        ///< steps from none of it to all
    double unbalanced_force = 1e-5;  ///< of the state probed, and of each answer [-]
    double max_strain = 0.01;        ///< norm of a strain beyond which the sample counts as failing [-]
    std::int64_t max_steps = 30'000; ///< of a probe; a sample not at rest by then creeps
    double time_step = 0;            ///< [s]; 0 = computed
};

/// Strains of one size: three axial ones, three shears.
struct StiffnessSpec {
    double increment = 1e-6;         ///< axial, or engineering shear strain [-]
    double unbalanced_force = 1e-6;  ///< of the state probed [-]
    std::int64_t max_steps = 30'000; ///< until the state rests, and again until each strain has its stress
    double time_step = 0;            ///< [s]; 0 = computed
};

} // namespace suffuse::triaxial
