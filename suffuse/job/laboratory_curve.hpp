#pragma once
// A test of a laboratory and a simulated one as numbers that can be compared: stresses over the pressure of the start,
// and strains, at the same strains or stresses.

#include "suffuse/casefile/calibrate_spec.hpp"
#include "suffuse/laboratory/test_record.hpp"
#include "suffuse/triaxial/run_path.hpp"

#include <string_view>
#include <vector>

namespace suffuse::job {

enum class CurveQuantity {
    StressRatio,      ///< deviator stress / pressure of the start
    VolumetricStrain, ///< compression positive
    MeanStressRatio,  ///< effective mean stress / pressure of the start
    AxialStrain,      ///< since the first stress of the grid
};

/// "stress_ratio", "volumetric_strain", ...: in JSON.
std::string_view key_of(CurveQuantity quantity);

/// What is compared, and where.
struct CurveForm {
    std::vector<double> grid;         ///< axial strains [-], of an oedometer axial stresses [Pa], rising
    std::vector<CurveQuantity> parts; ///< of a simulation; a curve has `grid` values of each, one part after the other
    std::vector<CurveQuantity> measured; ///< those of them that the laboratory has
};

struct LaboratoryCurve {
    CurveForm form;
    std::vector<double> values;                ///< of the measured parts
    std::vector<double> deviations;            ///< that are expected of them: the target's scatter
    std::vector<int> rows;                     ///< where they are in a simulated curve
    std::vector<int> begins;                   ///< first row of each measured part but the first
    std::vector<laboratory::Finding> findings; ///< how its record was read
    std::vector<std::string> unread;           ///< columns of the record that were not
};

/// Expected of the values of one part: the share `scatter` of the largest, but no less than an apparatus resolves.
double deviation_of(CurveQuantity quantity, const std::vector<double>& values, double scatter);

/// @throws CaseError where the record lacks what the test needs
LaboratoryCurve laboratory_curve(const laboratory::TestRecord& record, const casefile::CalibrateTarget& target);

/// Reads the file of the target, too. @throws IoError, CaseError
LaboratoryCurve read_laboratory_curve(const casefile::CalibrateTarget& target);

/// All parts of a simulated test. Its strains are logarithmic, those of laboratories are over the length of the start.
std::vector<double> simulated_curve(
    const std::vector<triaxial::PathRow>& rows, const CurveForm& form, const casefile::CalibrateTarget& target
);

} // namespace suffuse::job
