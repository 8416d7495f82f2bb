#pragma once
// [calibrate]: which parameters of a model are sought, and which tests of a laboratory they must reproduce.

#include "suffuse/base/place.hpp"
#include "suffuse/base/units.hpp"
#include "suffuse/casefile/case.hpp"

#include <optional>
#include <string>
#include <vector>

namespace suffuse::casefile {

enum class CalibrateTest { Drained, Undrained, Oedometer };

/// A test of a laboratory, and how it is simulated.
struct CalibrateTarget {
    std::string name; ///< of its samples and of its void ratio
    std::string file; ///< read by the reader of laboratory records
    CalibrateTest test = CalibrateTest::Drained;
    std::string sample;                          ///< which test of the file; empty: its only one
    std::optional<bool> contraction_is_positive; ///< of its volumetric strains; found out unless given
    double pressure = 0;                         ///< effective and isotropic, at the start [Pa]
    std::optional<double> void_ratio;            ///< of the model, where it is fixed [-]
    std::string void_ratio_of;                   ///< the target with whose samples these share theirs
    double void_ratio_tolerance = 5e-3;          ///< that the samples of the model may miss it by [-]
    double strain = 0.1;                         ///< axial, up to which curves are compared [-]
    double largest_stress = 0;                   ///< of an oedometer, found in its file [Pa]
    double scatter = 0.03;    ///< expected of the measurement, as a share of the curve's largest value [-]
    double weight = 1;        ///< of its log likelihood
    bool is_held_out = false; ///< predicted, not fitted
    Place place;
};

/// A key that is sought between two values.
struct CalibrateUnknown {
    std::string key;            ///< as a sweep has it, or "void_ratio", "void_ratio.TARGET"
    Scalar low, high;           ///< as written
    double least = 0, most = 1; ///< the same in SI
    Dimension dimension = {};
    bool is_log = false; ///< all of its decades are as likely
    Place place;
};

/// `factor` x the left unknown is at most the right side: a number, or another unknown times its factor.
struct CalibrateConstraint {
    std::string left, right; ///< unknowns; `right` may be empty
    double left_factor = 1, right_factor = 1;
    std::string text;
};

/// The void ratio of the samples of each target, unless it is fixed.
inline constexpr const char* void_ratio_key = "void_ratio";

/// "void_ratio", "void_ratio.TARGET"
bool is_void_ratio(const std::string& key);

struct CalibrateSpec {
    std::string soil;
    std::int64_t particles = 1000; ///< of each sample
    Place particles_place;         ///< where they are given, or the table
    int samples = 64;              ///< of each target, at most
    bool fix_void_ratio = false;
    std::vector<CalibrateTarget> targets;
    std::vector<CalibrateUnknown> unknowns;
    std::vector<CalibrateConstraint> constraints;
};

/// In SI, at `share` of the way from the least to the most: of the logarithms where all decades are as likely.
double value_at(const CalibrateUnknown& unknown, double share);

/// The unknown that is the void ratio of this target; -1 where it is fixed.
int void_ratio_of(const CalibrateSpec& spec, const CalibrateTarget& target);

/// Whether values, one an unknown and in SI, meet the constraint.
bool meets(const CalibrateConstraint& constraint, const CalibrateSpec& spec, const std::vector<double>& values);

} // namespace suffuse::casefile
