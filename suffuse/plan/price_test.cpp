#include "suffuse/plan/price_test.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace suffuse::plan {
namespace {

constexpr Range balance_at_stress{0, 500}; // steps, without the patience

// Axial strain until a stress: of samples that carry it elastically, deviator stress over strain, over the contact
// modulus; of loose ones, that yield, strain = this x eta/(limit - eta) with eta = q/p [-].
constexpr double stiffest = 0.25, softest = 0.07, yielding_coordination = 4;
constexpr double loose_limit = 0.85, least_distance = 0.05;
constexpr Range loose_strain{0.002, 0.02};

// How far off the time step is, as a factor on the steps; a loose sample at constant volume loses its contacts and
// steps faster.
constexpr Range time_step_error{0.85, 1.2}, liquefied{0.5, 1.1};

class LaboratoryTest {
public:
    LaboratoryTest(
        const casefile::Case& what, const casefile::Variant& variant, const triaxial::TriaxialSpec& spec,
        PricedSample& sample
    )
        : case_(what), variant_(variant), spec_(spec), sample_(sample) {}

    StagePrice price() {
        const double rate = triaxial::strain_rate_of(spec_, variant_.material, sample_.median, sample_.pressure);
        const bool is_loose = sample_.coordination < yielding_coordination;
        take_critical_state(sample_); // within the first percents of strain
        const double dt = time_step();
        const double a_strain = 1 / (rate * dt); // steps
        if (triaxial::count_legs(spec_) > 1 || !spec_.stresses.empty()) {
            return price_legs(a_strain);
        }
        const std::string pace = fmt::format("at {:.3g} 1/s (inertial number {:.1e})", rate, spec_.inertial_number);
        if (spec_.stops_at_stress()) {
            const Range strain = strain_until(is_loose);
            sample_.pressure /= 1 - std::min(specified_stress_ratio(), 2.0) / 3; // the lateral stress is held
            return {
                .steps = a_strain * strain + waited(case_, balance_at_stress),
                .memory_a_grain = grain_memory,
                .basis = fmt::format("until a stress, at most {:.3g} % {}, then settling", 100 * spec_.strain, pace)};
        }
        const bool liquefies = spec_.path == triaxial::Path::Undrained && is_loose;
        const Range error = spec_.time_step > 0 ? Range{1, 1} : liquefies ? liquefied : time_step_error;
        return {
            .steps = a_strain * spec_.strain * error,
            .memory_a_grain = grain_memory,
            .basis = fmt::format("{:.3g} % {}", 100 * spec_.strain, pace)};
    }

private:
    /// Of a test that turns: its strains, and the bursts in which it eases to each turn and comes back to its pace.
    [[nodiscard]] StagePrice price_legs(double a_strain) {
        constexpr Range turning{1'500, 4'000}; // steps
        const double modulus = as_pressed(sample_, variant_.material).modulus;
        const int legs = triaxial::count_legs(spec_);
        double stress = 0, strain = 0; // that the legs go through, at least
        if (spec_.cycles) {
            stress = 4.0 * legs * spec_.cycles->csr.value_or(0) * sample_.pressure;
            strain = 2.0 * legs * spec_.cycles->strain.value_or(0);
        }
        for (const double to : spec_.stresses) {
            stress += std::abs(to - sample_.pressure);
            sample_.pressure = to;
        }
        const Range strained{strain + stress / modulus / stiffest, strain + stress / modulus / softest};
        return {
            .steps = a_strain * strained + static_cast<double>(legs) * turning +
                     (spec_.cycles ? Range{} : waited(case_, balance_at_stress)),
            .memory_a_grain = grain_memory,
            .basis = fmt::format("{} turns at most (inertial number {:.1e})", legs, spec_.inertial_number)};
    }

    [[nodiscard]] double time_step() const {
        const dem::Lent lent = triaxial::lent_during(spec_, variant_.material);
        return spec_.time_step > 0 ? spec_.time_step : settled_time_step(sample_, variant_.material, lent);
    }

    /// On the drained path; undrained and constant-mean ones end below [-].
    [[nodiscard]] double specified_stress_ratio() const {
        if (spec_.stress_ratio) {
            return *spec_.stress_ratio;
        }
        const double q = *spec_.deviator_stress;
        return q / (sample_.pressure + q / 3);
    }

    /// Axial strain until a deviator stress is reached [-].
    [[nodiscard]] Range strain_until(bool is_loose) const {
        const double ratio = specified_stress_ratio();
        const auto at_most = [&](double strain) { return std::min(strain, spec_.strain); };
        if (is_loose) {
            const Range strain = ratio / std::max(loose_limit - ratio, least_distance) * loose_strain;
            return {at_most(strain.least), at_most(strain.most)};
        }
        const double q = ratio * sample_.pressure / std::max(1 - ratio / 3, 0.1);
        const double strain = q / as_pressed(sample_, variant_.material).modulus;
        return {at_most(strain / stiffest), at_most(strain / softest)};
    }

    const casefile::Case& case_;
    const casefile::Variant& variant_;
    const triaxial::TriaxialSpec& spec_;
    PricedSample& sample_;
};

} // namespace

StagePrice price_test(
    const casefile::Case& what, const casefile::Variant& variant, const triaxial::TriaxialSpec& spec,
    PricedSample& sample
) {
    return LaboratoryTest(what, variant, spec, sample).price();
}

} // namespace suffuse::plan
