#pragma once
// Preparation: a cloud of grains, and its compaction to a pressure and a density.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace suffuse::packing {

/// A soil of a stack (stack.hpp).
struct Layer {
    std::string soil;     ///< name of a soil of the case
    double thickness = 0; ///< along the axis, when settled [m]
};

/// Of a stack whose case does not say [-].
inline constexpr double stack_porosity = 0.5;

/// `do = "pack"`: a cloud without overlaps in a periodic cubic cell, or one of layers.
struct PackSpec {
    double porosity = 0.65;           ///< of the cloud [-]
    std::vector<Layer> layers = {};   ///< in the order of the flow; none: one soil, in a cube
    int axis = 2;                     ///< of the layers: x, y, z
    std::optional<double> width = {}; ///< of the cross-section of the layers, when settled [m]
};

/// How the contacts behave during compaction only.
struct Prepare {
    std::optional<double> friction;        ///< lowered contact friction: dense [rad]
    std::optional<double> adhesion_normal; ///< on contacts made during compaction: loose [Pa]
    std::optional<double> adhesion_shear;  ///< [Pa]
    /// Coarse grains are compacted alone, in this way; fines are then put into their voids (skeleton_first.hpp).
    bool skeleton_first = false;
};

/// A void ratio that no preparation gives.
enum class IfUnreachable {
    Error,
    Nearest ///< the preparation that comes nearest is taken, and the result says so
};

/// How a sample gets to its pressure: docs/theory/preparation.md says what each costs and how their fabrics differ.
enum class Protocol {
    Faithful, ///< the reference's rates under a servo that does not ring; the same fabric within the scatter of seeds
    Swift,    ///< pushed together by geometry, then pressed over-damped: the quickest; more contacts, fewer rattlers
    Slow,     ///< the reference's own rates, time step and servo: what Faithful is measured against
    Wide      ///< for coarse grains many times the size of the fine ones: a tenth of the steps of Faithful
};

/// The word of a case file and of results.
constexpr std::string_view name_of(Protocol protocol) {
    switch (protocol) {
    case Protocol::Faithful:
        return "faithful";
    case Protocol::Swift:
        return "swift";
    case Protocol::Slow:
        return "slow";
    case Protocol::Wide:
        break;
    }
    return "wide";
}

/// Inertial number of the largest strain rate of a compaction, with the specified pressure and the median diameter by
/// mass: the 250 1/s of the reference's sand (0.21 mm) at 100 kPa [reference, section 4].
inline constexpr double cloud_inertial_number = 8.466e-3;

/// `do = "compact"`: isotropic compaction to a pressure, then settling with the final parameters.
struct CompactSpec {
    double pressure = 0;         ///< [Pa]
    bool shear_released = false; ///< see cell::Loading; not in Slow
    Protocol protocol = Protocol::Faithful;
    std::optional<double> start_porosity; ///< Swift: to which the cloud is brought without forces [-]
    Prepare prepare;
    std::optional<double> void_ratio; ///< wanted void ratio, met by searching the preparation [-]
    /// Instead: wanted void ratio with the fines counted as voids; `void_ratio` follows with the fines content [-].
    std::optional<double> intergranular_void_ratio;
    double void_ratio_tolerance = 0.002;
    IfUnreachable if_unreachable = IfUnreachable::Error;
    /// Samples of more fines than this take the preparation that was found for the sample of so many [-].
    std::optional<double> prepared_as;
    /// Largest strain rate while the cloud carries no load, if not that of `cloud_inertial_number`; not in Swift [1/s].
    std::optional<double> max_rate;
    double time_step = 0; ///< [s]; 0 = computed from the contact network
};

} // namespace suffuse::packing
