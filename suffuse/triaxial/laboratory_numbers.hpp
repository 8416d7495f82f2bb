#pragma once
// What laboratories read off the curves of their other tests: indices of compression, the strength of a shear plane,
// the cycles that a sample bears. Rows in, numbers out.

#include "suffuse/triaxial/run_path.hpp"

#include <optional>
#include <vector>

namespace suffuse::triaxial {

/// Of an oedometer or of isotropic compression. Indices are the slopes of e against log10 of the axial stress by least
/// squares: of first loading over its last half decade, of swelling one slope of all branches in which the stress
/// falls. A change of stress within what a test may be off is none.
struct CompressionNumbers {
    std::optional<double> k0; ///< at the highest axial stress; nothing where it never loads, or isotropic
    std::optional<double> compression_index; ///< C_c [-]; nothing where the test never loads
    std::optional<double> swelling_index;    ///< C_s [-]; nothing where it never unloads
};

CompressionNumbers compression_numbers(const TriaxialSpec& spec, const std::vector<PathRow>& rows);

/// At the highest ratio of shear to normal stress, which a sample does not carry once it has liquefied.
struct ShearNumbers {
    double shear_stress = 0;       ///< [Pa]
    double normal_stress = 0;      ///< [Pa]
    double peak_stress_ratio = 0;  ///< [-]
    double peak_shear_strain = 0;  ///< [-]
    double final_stress_ratio = 0; ///< of the last row [-]
    double rotation = 0;           ///< of the major principal stress, from the normal towards the shear [rad]
};

ShearNumbers shear_numbers(const TriaxialSpec& spec, const std::vector<PathRow>& rows);

struct CyclicNumbers {
    double cycles = 0;                            ///< completed, in halves
    std::optional<double> cycles_to_liquefaction; ///< nothing where all requested cycles were borne
    double pore_pressure_ratio = 0;               ///< the highest; over the lateral stress of the start [-]
    double double_amplitude = 0;                  ///< largest axial strain from one turn to the next row of its leg [-]
};

CyclicNumbers cyclic_numbers(const TriaxialSpec& spec, const std::vector<PathRow>& rows);

} // namespace suffuse::triaxial
