#include "suffuse/triaxial/path_loading.hpp"

#include "suffuse/dem/inspect.hpp"

#include <algorithm>
#include <cmath>

namespace suffuse::triaxial {
namespace {

constexpr double servo_response = 25; // steps; a sample at constant deviator needs the usual ones

/// All stresses held, the lateral ones alike.
cell::Loading held_stresses(const TriaxialSpec& spec, double p, double q) {
    cell::Loading loading;
    loading.axis.fill({cell::Control::Stress, p - q / 3});
    loading.axis[static_cast<std::size_t>(spec.axis)].value = p + 2 * q / 3;
    return loading;
}

/// Of the lateral axis after the one driven, where it bears the share b of the difference of the two others. Extension
/// makes the axial stress the least of the three.
cell::AxisControl intermediate_stress(const TriaxialSpec& spec, double held) {
    const double share = spec.direction == Direction::Extension ? 1 - *spec.b : *spec.b;
    return {cell::Control::Share, (1 - share) * held, share, spec.axis};
}

/// Of a lateral axis that bore this stress at the start, where paths treat lateral axes each for themselves.
cell::AxisControl lateral_control(const TriaxialSpec& spec, int a, const Mat3& start) {
    const bool is_intermediate = a == (spec.axis + 1) % 3;
    if (spec.path == Path::Isotropic) {
        return {cell::Control::Share, 0, 1, spec.axis};
    }
    if (is_intermediate && spec.path == Path::PlaneStrain) {
        return {};
    }
    if (is_intermediate && spec.b) {
        const int other = (spec.axis + 2) % 3;
        return intermediate_stress(spec, start(other, other));
    }
    return {cell::Control::Stress, start(a, a)}; // what each held at the start, which need not be the same
}

cell::Loading simple_shear(const TriaxialSpec& spec, const PathState& state) {
    const auto [normal, along] = spec.shear_axes;
    cell::Loading loading;
    loading.simple_shear(along, normal) = state.pace * state.strain_rate;
    if (spec.path == Path::ShearAtStress) {
        const double held = state.start_stress(normal, normal);
        loading.axis[static_cast<std::size_t>(normal)] = {cell::Control::Stress, held};
    }
    return loading;
}

} // namespace

double lateral_mean(const Mat3& stress, int axis) {
    return 0.5 * (trace(stress) - stress(axis, axis));
}

double deviator(const Mat3& stress, int axis) {
    return stress(axis, axis) - lateral_mean(stress, axis);
}

std::optional<double> imposed_strain_ratio(const TriaxialSpec& spec) {
    return spec.path == Path::Undrained ? std::optional(0.0) : spec.strain_ratio;
}

cell::Loading loading_of(const TriaxialSpec& spec, const PathState& state) {
    using cell::Control;
    const Mat3 &start = state.start_stress, &now = state.balance.stress;
    const double rate = state.sense * state.pace * state.strain_rate;
    cell::AxisControl axial{Control::StrainRate, rate}, lateral;
    bool each_for_itself = false;
    if (const std::optional<double> ratio = imposed_strain_ratio(spec)) {
        lateral = {Control::StrainRate, -0.5 * (1 - *ratio) * rate + 0.5 * state.water_rate};
    } else if (spec.path == Path::ConstantMean) {
        lateral = {Control::MeanStress, dem::mean_stress(start)};
    } else if (spec.path == Path::ConstantDeviator) {
        // A sample that fails flows at constant volume, with the axial rate of the other paths.
        lateral = {Control::StrainRate, -0.5 * rate};
        axial = {Control::Stress, lateral_mean(now, spec.axis) + deviator(start, spec.axis)};
    } else {
        each_for_itself = true;
    }
    cell::Loading loading = shears(spec.path) ? simple_shear(spec, state) : cell::Loading{};
    // A sample widens at half of its axial rate and its dilatancy together: the servo must be able to follow, but no
    // axis may be faster than quasi-static.
    loading.servo.max_rate = fastest_held * state.strain_rate;
    for (int a = 0; a < 3 && !shears(spec.path); ++a) {
        loading.axis[static_cast<std::size_t>(a)] = a == spec.axis    ? axial
                                                    : each_for_itself ? lateral_control(spec, a, start)
                                                                      : lateral;
    }
    if (spec.path != Path::ConstantDeviator && cell::holds_stress(loading)) {
        loading.servo.response = servo_response;
    }
    return loading;
}

cell::Loading final_loading(const TriaxialSpec& spec, const PathState& state) {
    const auto axis = static_cast<std::size_t>(spec.axis);
    if (!spec.stresses.empty()) {
        cell::Loading loading;
        if (spec.path == Path::Isotropic) {
            loading = dem::isotropic_stress(spec.stresses.back());
        }
        loading.axis[axis] = {cell::Control::Stress, spec.stresses.back()};
        return loading;
    }
    if (imposed_strain_ratio(spec)) {
        return dem::constant_volume();
    }
    const double start_mean = dem::mean_stress(state.start_stress), start_q = deviator(state.start_stress, spec.axis);
    if (spec.path == Path::ConstantDeviator) {
        return held_stresses(spec, start_q / *spec.stress_ratio, start_q);
    }
    if (spec.path == Path::ConstantMean) {
        return held_stresses(spec, start_mean, state.sense * *deviator_to_stop_at(spec, start_mean));
    }
    const double lateral = lateral_mean(state.start_stress, spec.axis);
    double q = 0;
    if (spec.deviator_stress) {
        q = state.sense * *spec.deviator_stress;
    } else { // q = eta p, with p = lateral + q/3
        const double eta = state.sense * *spec.stress_ratio;
        q = eta * lateral / (1 - eta / 3);
    }
    cell::Loading loading = loading_of(spec, state);
    loading.axis[axis] = {cell::Control::Stress, lateral + q};
    return loading;
}

double hold_error(const TriaxialSpec& spec, const PathState& state) {
    const Mat3& stress = state.balance.stress;
    if (spec.b) { // the stress between the largest and the least follows the largest, which is no measure of the least
        const cell::Loading loading = loading_of(spec, state);
        double largest = 0;
        for (int a = 0; a < 3; ++a) {
            const double wanted = cell::wanted_stress(loading, a, {stress(0, 0), stress(1, 1), stress(2, 2)});
            if (loading.axis[static_cast<std::size_t>(a)].control != cell::Control::StrainRate && wanted != 0) {
                largest = std::max(largest, std::abs((stress(a, a) - wanted) / wanted));
            }
        }
        return largest;
    }
    if (spec.path != Path::ConstantDeviator) {
        return dem::stress_error(loading_of(spec, state), stress);
    }
    const double q = deviator(state.start_stress, spec.axis);
    return std::abs(deviator(stress, spec.axis) - q) / q;
}

std::optional<Target>
target_of(const TriaxialSpec& spec, const PathState& state, const Mat3& stress, double axial_strain) {
    const double q = deviator(stress, spec.axis);
    if (spec.cycles && spec.cycles->strain) {
        return Target{false, *spec.cycles->strain - state.sense * axial_strain, *spec.cycles->strain};
    }
    if (spec.cycles) {
        const double amplitude = 2 * *spec.cycles->csr * dem::mean_stress(state.start_stress);
        return Target{true, amplitude - state.sense * (q - deviator(state.start_stress, spec.axis)), amplitude};
    }
    if (!spec.stresses.empty()) {
        const double wanted = spec.stresses[static_cast<std::size_t>(state.leg)];
        return Target{true, state.sense * (wanted - stress(spec.axis, spec.axis)), wanted};
    }
    if (const std::optional<double> wanted = deviator_to_stop_at(spec, dem::mean_stress(stress))) {
        return Target{true, *wanted - state.sense * q, *wanted};
    }
    return std::nullopt;
}

int count_legs(const TriaxialSpec& spec) {
    return spec.cycles ? 2 * spec.cycles->number : std::max(1, static_cast<int>(spec.stresses.size()));
}

double sense_of_leg(const TriaxialSpec& spec, int leg, const Mat3& stress) {
    if (spec.cycles) {
        return leg % 2 == 0 ? 1 : -1;
    }
    if (!spec.stresses.empty()) {
        return spec.stresses[static_cast<std::size_t>(leg)] >= stress(spec.axis, spec.axis) ? 1 : -1;
    }
    return spec.sense();
}

} // namespace suffuse::triaxial
