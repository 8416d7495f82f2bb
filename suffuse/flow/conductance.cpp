#include "suffuse/flow/conductance.hpp"

#include "suffuse/base/parallel.hpp"

namespace suffuse::flow {

std::vector<double> conductances(const pores::PoreNetwork& network, double viscosity) {
    const pores::Throats& throats = network.throats;
    std::vector<double> conductance(throats.size());
    parallel_for(throats.size(), 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) {
            if (pores::is_internal(throats, t) || throats.void_area[t] == 0 || throats.hydraulic_radius[t] == 0) {
                continue;
            }
            conductance[t] =
                throat_conductance(throats.void_area[t], throats.hydraulic_radius[t], throats.length[t], viscosity);
        }
    });
    return conductance;
}

} // namespace suffuse::flow
