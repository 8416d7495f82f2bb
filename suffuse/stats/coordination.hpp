#pragma once
// Contacts per grain: the mean, the mechanical one that leaves rattlers out [Thornton 2000], and between the coarse and
// the fine fraction. A rattler, or inactive grain, has fewer than two contacts. A grain that touches its own image
// counts twice.

#include "suffuse/dem/world.hpp"

#include <cstdint>
#include <vector>

namespace suffuse::stats {

inline constexpr int active_contacts = 2; ///< least number of contacts of an active grain

struct Coordination {
    std::int64_t grains = 0, contacts = 0;
    double mean = 0;                     ///< Z = 2 Nc / N [-]
    double mechanical = 0;               ///< Zm = (2 Nc - N1) / (N - N0 - N1); 0 where every grain is a rattler [-]
    std::int64_t rattlers = 0;           ///< grains with 0 or 1 contact, N0 + N1
    std::int64_t without_contact = 0;    ///< N0
    double coarse_coarse = 0;            ///< contacts with coarse grains, per coarse grain; 0 without coarse grains [-]
    double coarse_fine = 0;              ///< contacts with fine grains, per coarse grain [-]
    double fine_coarse = 0;              ///< contacts with coarse grains, per fine grain; 0 without fine grains [-]
    double fine_fine = 0;                ///< contacts with fine grains, per fine grain [-]
    std::vector<std::int64_t> histogram; ///< number of grains with 0, 1, 2, ... contacts, up to the most
};

Coordination measure_coordination(const dem::World& world);

} // namespace suffuse::stats
