#include "suffuse/stats/fabric.hpp"

#include "suffuse/base/quantile.hpp"
#include "suffuse/dem/inspect.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace suffuse::stats {
namespace {

Mat3 deviatoric(const Mat3& tensor) {
    const double third = trace(tensor) / 3;
    return tensor - diagonal({third, third, third});
}

/// Compression carried along the normal [N].
double compression(const dem::ContactView& c) {
    return -dot(c.normal_force, c.normal);
}

} // namespace

double deviator_of(const Mat3& tensor) {
    return dem::deviator_stress(tensor);
}

Fabric measure_fabric(const dem::World& world) {
    Fabric fabric;
    const std::vector<dem::ContactView> contacts = dem::inspect_contacts(world);
    if (contacts.empty()) {
        return fabric;
    }
    const double weight = 1 / static_cast<double>(contacts.size());
    for (const dem::ContactView& c : contacts) {
        fabric.tensor += weight * outer(c.normal, c.normal);
    }
    fabric.deviator = deviator_of(fabric.tensor);
    fabric.contact_anisotropy = 7.5 * deviatoric(fabric.tensor);
    // Means over directions: each contact counts inversely to how often its direction occurs.
    constexpr double least_density = 0.1; // second order no longer describes where contacts point
    Mat3 normal{}, shear{};
    for (const dem::ContactView& c : contacts) {
        const double density = 1 + dot(c.normal, fabric.contact_anisotropy * c.normal);
        if (density < least_density) {
            return fabric;
        }
        normal += weight * compression(c) / density * outer(c.normal, c.normal);
        shear += weight / density * outer(-c.shear_force, c.normal);
    }
    const double mean = trace(normal);
    if (mean != 0) {
        fabric.force_anisotropy = ForceAnisotropy{(7.5 / mean) * deviatoric(normal), (5 / mean) * deviatoric(shear)};
    }
    return fabric;
}

ForceDistribution measure_forces(const dem::World& world) {
    ForceDistribution result;
    const std::vector<dem::ContactView> contacts = dem::inspect_contacts(world);
    if (contacts.empty()) {
        return result;
    }
    const double weight = 1 / static_cast<double>(contacts.size()), slope = std::tan(world.material.friction);
    std::vector<double> force;
    double square = 0;
    for (const dem::ContactView& c : contacts) {
        force.push_back(compression(c));
        square += weight * force.back() * force.back();
        result.mean_normal_force += weight * force.back();
        result.mean_force += weight * norm(c.normal_force + c.shear_force);
        const double limit = slope * force.back();
        result.sliding_share += !c.is_bonded && limit > 0 && norm(c.shear_force) >= (1 - 1e-3) * limit ? weight : 0;
    }
    const double mean = result.mean_normal_force;
    if (mean <= 0) {
        return result;
    }
    double strong_pressure = 0, pressure = 0;
    for (std::size_t c = 0; c < contacts.size(); ++c) {
        const double length =
            world.grains.radius[contacts[c].i] + world.grains.radius[contacts[c].j] - contacts[c].overlap;
        const bool strong = force[c] > mean;
        pressure += force[c] * length;
        strong_pressure += strong ? force[c] * length : 0;
        result.strong_share += strong ? weight : 0;
    }
    result.strong_pressure_share = strong_pressure / pressure;
    result.variation = std::sqrt(std::max(0.0, square - mean * mean)) / mean;
    std::sort(force.begin(), force.end());
    result.median_ratio = quantile_of_sorted(force, 0.5) / mean;
    result.p90_ratio = quantile_of_sorted(force, 0.9) / mean;
    result.max_ratio = force.back() / mean;
    return result;
}

} // namespace suffuse::stats
