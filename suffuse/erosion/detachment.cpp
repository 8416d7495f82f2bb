#include "suffuse/erosion/detachment.hpp"

#include "suffuse/base/quantile.hpp"

#include <utility>

namespace suffuse::erosion {
namespace {

constexpr double most_hidden = 0.05;  // share of the fines: hidden ones beyond it make the verdict one on noise
constexpr double most_refused = 0.05; // share of the grains taken: the two rules differ by a bounce here and there

/// The paper's first group: the speed rises over every tenth of the watch.
bool rises_throughout(const std::array<double, probe_samples + 1>& speed) {
    for (std::size_t k = 1; k < speed.size(); ++k) {
        if (!(speed[k] > speed[k - 1])) {
            return false;
        }
    }
    return true;
}

/// @param without speed of the same grain without fluid [m/s]
bool detaches_by_velocity(const DetachSpec& spec, const ProbeResult& probe, std::size_t k, double without) {
    const double final_speed = probe.speed[k].back();
    switch (spec.rule) {
    case VelocityRule::Rising:
        return rises_throughout(probe.speed[k]);
    case VelocityRule::Above:
        return final_speed > spec.over_speed.value_or(0);
    case VelocityRule::StillAccelerating:
        break;
    }
    return rises_throughout(probe.speed[k]) && final_speed - without > spec.over * probe.free_speed[k];
}

bool detaches_by_displacement(const DetachSpec& spec, const ProbeResult& probe, std::size_t k) {
    const double wanted =
        spec.over_diameters ? *spec.over_diameters * probe.diameter[k] : spec.over * probe.free_displacement[k];
    return probe.displacement[k] > wanted;
}

} // namespace

void judge_detachment(const DetachSpec& spec, ProbeResult& result) {
    const std::size_t fines = result.id.size();
    result.twin_noise = result.twin_speed.empty() ? 0 : upper_quantile(result.twin_speed, spec.noise_quantile);
    result.by_velocity.assign(fines, 0);
    result.by_displacement.assign(fines, 0);
    result.agreement = {};
    result.hidden_by_noise = 0;
    for (std::size_t k = 0; k < fines; ++k) {
        if (result.fluid_force[k] > 0) {
            const bool moves = detaches_by_velocity(spec, result, k, 0);
            result.by_velocity[k] = detaches_by_velocity(spec, result, k, result.twin_speed[k]) ? 1 : 0;
            result.hidden_by_noise += moves && result.by_velocity[k] == 0 ? 1 : 0;
            result.by_displacement[k] = detaches_by_displacement(spec, result, k) ? 1 : 0;
        }
        ++result.agreement[result.by_velocity[k]][result.by_displacement[k]];
    }
}

bool noise_decides(const DetachSpec& spec, const ProbeResult& result) {
    return spec.by == DetachBy::Velocity &&
           static_cast<double>(result.hidden_by_noise) > most_hidden * static_cast<double>(result.id.size());
}

bool takes_unaccepted(const ProbeResult& result) {
    const auto [refused, accepted] = result.agreement[1];
    return static_cast<double>(refused) > most_refused * static_cast<double>(refused + accepted);
}

double free_travel(const ProbeResult& result) {
    constexpr double most = 0.95; // of the fines
    std::vector<double> travel;
    for (std::size_t k = 0; k < result.free_displacement.size(); ++k) {
        travel.push_back(result.free_displacement[k] / result.diameter[k]);
    }
    return travel.empty() ? 0 : quantile(std::move(travel), most);
}

bool threshold_takes_noise(const DetachSpec& spec, const ProbeResult& result) {
    return spec.by == DetachBy::Velocity && spec.rule == VelocityRule::Above && takes_unaccepted(result);
}

const std::vector<std::uint8_t>& verdicts(const DetachSpec& spec, const ProbeResult& result) {
    return spec.by == DetachBy::Velocity ? result.by_velocity : result.by_displacement;
}

} // namespace suffuse::erosion
