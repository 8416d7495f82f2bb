#pragma once
// A detachment rule that the caller of the erosion loop brings along, in place of those that a case can name.

#include "suffuse/dem/world.hpp"
#include "suffuse/erosion/result.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace suffuse::erosion {

struct OwnRule {
    std::string name;   ///< as its author calls it
    std::string source; ///< its text; empty where it could not be read
    /// A pure function from what the probe measured, and the equilibrium that it started from, to 1 for each fine grain
    /// of the probe that is detachable, else 0.
    std::function<std::vector<std::uint8_t>(const dem::World& equilibrium, const ProbeResult& probe)> judge;
};

} // namespace suffuse::erosion
