#pragma once
// Preparation: a cloud of grains, and its compaction to a pressure and a density.

#include <optional>

namespace suffuse::packing {

/// `do = "pack"`: a cloud without overlaps in a periodic cubic cell.
struct PackSpec {
    double porosity = 0.65; ///< of the cloud [-]
};

/// How the contacts behave during compaction only.
struct Prepare {
    std::optional<double> friction;        ///< lowered contact friction: dense [rad]
    std::optional<double> adhesion_normal; ///< on contacts made during compaction: loose [Pa]
    std::optional<double> adhesion_shear;  ///< [Pa]
};

/// `do = "compact"`: isotropic compaction to a pressure, then settling with the final parameters.
struct CompactSpec {
    double pressure = 0; ///< [Pa]
    Prepare prepare;
    std::optional<double> void_ratio; ///< wanted void ratio, met by searching the friction during compaction [-]
    double void_ratio_tolerance = 0.002;
    double max_rate = 250; ///< largest strain rate while the cloud carries no load [1/s]
    double time_step = 0;  ///< [s]; 0 = computed from the contact network
};

} // namespace suffuse::packing
