#pragma once
// Invented results of an erosion run, and figures of them, for tests of pages only: shapes as a real run has them,
// numbers from a formula.

#include "suffuse/base/constants.hpp"
#include "suffuse/base/random.hpp"
#include "suffuse/erosion/result.hpp"
#include "suffuse/figures/figures.hpp"
#include "suffuse/figures/figures_flux.hpp"
#include "suffuse/grains/grading.hpp"

#include "tests/support/sample_study.hpp"
#include <algorithm>
#include <cmath>

namespace suffuse::test {

inline Mat3 isotropic(double pressure) {
    return diagonal({pressure, pressure, pressure});
}

inline grains::Grading sample_grading() {
    return {{1.0e-4, 1.5e-4, 1.8e-4, 2.1e-4, 2.5e-4, 3.0e-4, 4.0e-4}, {0, 0.08, 0.25, 0.50, 0.75, 0.92, 1}, "invented"};
}

/// Fluxes that grow about as the cube of the size, in throats that get wider from state to state.
inline std::vector<figures::FluxState> sample_fluxes() {
    std::vector<figures::FluxState> states;
    for (const char* name : {"before erosion", "after pass 1", "after pass 2"}) {
        RandomStream random(7, name);
        pores::PoreNetwork network;
        std::vector<double> flux;
        for (int t = 0; t < 5000; ++t) {
            const double radius = 2e-5 * std::exp(random.uniform() + 0.2 * static_cast<double>(states.size()));
            network.throats.side.push_back({});
            network.throats.length.push_back(1e-4);
            network.throats.void_area.push_back(pi * radius * radius);
            network.throats.hydraulic_radius.push_back(radius / 2);
            network.throats.inscribed_radius.push_back(radius);
            flux.push_back(1e3 * std::pow(radius, 3) * std::exp(4 * random.uniform()));
        }
        states.push_back({name, flow::describe_fluxes(network, flux, 0.05)});
    }
    return states;
}

/// `count` fines of which about `share_free` are pushed without resistance; the others rattle at a speed of their own.
inline erosion::ProbeResult sample_probe(double gradient, std::size_t count, double share_free, std::uint64_t seed) {
    erosion::ProbeResult probe;
    probe.gradient = gradient;
    probe.unbalanced_force = 8e-9;
    probe.relax_steps = 12000;
    probe.ramp = probe.watch = 1000;
    probe.time_step = 4.1e-8;
    probe.fluid_over_contact = 1.2e-5 * gradient;
    probe.signal_over_twin = 40 * gradient;
    RandomStream random(seed, "sample report");
    for (std::size_t g = 0; g < count; ++g) {
        const double d = grains::size_at(sample_grading(), 0.79 * random.uniform());
        const double force = 6e-8 * gradient * (d / 2e-4) * (d / 2e-4), mass = 2600 * sphere_volume(d / 2);
        const bool free = random.uniform() < share_free && gradient > 0;
        const double rattle = std::pow(10.0, -7 + 1.2 * random.normal()) * (0.2 + gradient);
        std::array<double, erosion::probe_samples + 1> speed{};
        for (int k = 0; k <= erosion::probe_samples; ++k) {
            const double pushed = force / mass * (0.5 * 1000 + 100.0 * k) * probe.time_step * 0.8;
            speed[static_cast<std::size_t>(k)] =
                free ? pushed : rattle * (1 + 0.8 * std::sin(1.7 * k + static_cast<double>(g)));
        }
        probe.id.push_back(static_cast<std::uint32_t>(g));
        probe.diameter.push_back(d);
        probe.fluid_force.push_back(force);
        probe.coordination.push_back(
            free ? static_cast<int>(random.uniform() * 1.02) : 2 + static_cast<int>(5 * random.uniform())
        );
        probe.speed.push_back(speed);
        probe.twin_speed.push_back(rattle);
        probe.displacement.push_back(free ? 1e-9 : 1e-12);
        probe.free_speed.push_back(speed.back());
        probe.free_displacement.push_back(1.1e-9);
        const bool travels = free && random.uniform() < 0.97;
        probe.by_velocity.push_back(free ? 1 : 0);
        probe.by_displacement.push_back(travels ? 1 : 0);
        ++probe.agreement[free ? 1 : 0][travels ? 1 : 0];
    }
    return probe;
}

inline erosion::Constrictions sample_constrictions(std::uint64_t seed) {
    erosion::Constrictions constrictions;
    RandomStream random(seed, "sample constrictions");
    for (int k = 0; k < 1500; ++k) {
        constrictions.diameter.push_back(4.4e-4 * std::exp(0.4 * random.normal()));
        constrictions.center.push_back({random.uniform(), random.uniform(), random.uniform()});
    }
    constrictions.mean = 4.48e-4;
    constrictions.median = 4.4e-4;
    constrictions.d35 = 3.8e-4;
    return constrictions;
}

/// Rows of one pass: the removal, a relaxation at constant volume down to `stress_left`, the servo back.
inline void add_path(
    erosion::ErosionResult& erosion, int pass, double stress_left, double strain, double removal, double resettling
) {
    const double strain_before = erosion.path.empty() ? 0 : erosion.path.back().volumetric_strain;
    const double porosity_before = erosion.path.empty() ? 0.402 : erosion.path.back().porosity;
    const double mass_before = erosion.path.empty() ? 0 : erosion.path.back().eroded_mass;
    const std::int64_t begin = erosion.path.empty() ? 0 : erosion.path.back().step + 2000;
    const double mass = mass_before + removal / 0.6;
    const auto add = [&](erosion::Phase phase, std::int64_t step, double stress, double e, double n, double m) {
        erosion.path.push_back({pass, phase, step, isotropic(stress), e, n, 1e-4, m});
        erosion.path.back().stress[2][2] *= 1.02;
    };
    add(erosion::Phase::Removal, begin, 1e5, strain_before, porosity_before + removal, mass);
    for (int k = 1; k <= 60; ++k) {
        const double share = 1 - std::exp(-k / 12.0);
        add(erosion::Phase::ConstantVolume, begin + 50 * k, 1e5 + share * (stress_left - 1e5), strain_before,
            porosity_before + removal, mass);
    }
    for (int k = 1; k <= 60; ++k) {
        const double share = 1 - std::exp(-k / 12.0);
        add(erosion::Phase::Servo, begin + 3000 + 60 * k, stress_left + share * (1e5 - stress_left),
            strain_before + share * strain, porosity_before + removal - share * resettling, mass);
    }
}

inline erosion::PassResult
sample_pass(int number, double stress_left, double strain, double removal, double resettling) {
    erosion::PassResult pass;
    pass.pass = number;
    pass.probe =
        sample_probe(0.05, number == 1 ? 950 : 690, number == 1 ? 0.28 : 0.05, 40 + static_cast<std::uint64_t>(number));
    pass.constrictions = sample_constrictions(static_cast<std::uint64_t>(number));
    pass.constrictions_by_merge = {
        {{1500, 4.48e-4, 4.4e-4, 3.8e-4}, {600, 3.2e-4, 3.1e-4, 2.8e-4}, {120, 2.1e-4, 2e-4, 1.9e-4}}};
    for (std::size_t g = 0; g < pass.probe.id.size(); ++g) {
        if (pass.probe.by_velocity[g] == 0) {
            continue;
        }
        ++pass.removed;
        ++pass.coordination_histogram[pass.probe.coordination[g] + (number == 2 ? 2 : 0)];
    }
    pass.detachable = pass.removed;
    pass.porosity_before = number == 1 ? 0.402 : 0.4782;
    pass.porosity_after_removal = pass.porosity_before + removal;
    pass.porosity_after = pass.porosity_after_removal - resettling;
    pass.eroded_mass_percent = pass.eroded_mass_percent_of_initial = 100 * removal / 0.6;
    pass.stress_before = isotropic(1e5);
    pass.stress_after_removal = isotropic(0.999e5);
    pass.stress_constant_volume = isotropic(stress_left);
    pass.stress_after = isotropic(1e5);
    pass.volumetric_strain = strain;
    pass.permeability_before = number == 1 ? 5.4e-11 : 1.6e-10;
    pass.permeability_after = number == 1 ? 1.6e-10 : 1.9e-10;
    return pass;
}

inline erosion::ErosionResult sample_erosion() {
    erosion::ErosionResult erosion;
    erosion.passes = {sample_pass(1, 0.998e5, 2e-6, 0.0764, 2e-4), sample_pass(2, 0.72e5, 4e-3, 0.012, 3e-3)};
    add_path(erosion, 1, 0.998e5, 2e-6, 0.0764, 2e-4);
    add_path(erosion, 2, 0.72e5, 4e-3, 0.012, 3e-3);
    double mass_of_fines = 0;
    for (const erosion::PassResult& pass : erosion.passes) {
        for (std::size_t g = 0; g < pass.probe.id.size(); ++g) {
            const double d = pass.probe.diameter[g], mass = 2600 * sphere_volume(d / 2);
            if (pass.pass == 1) {
                mass_of_fines += mass;
            }
            if (pass.probe.by_velocity[g] == 0) {
                continue;
            }
            erosion.ledger.push_back(
                {pass.probe.id[g], pass.pass, d, mass, pass.probe.coordination[g], erosion::Reason::Velocity}
            );
        }
    }
    erosion.initial_mass = mass_of_fines / 0.79;
    return erosion;
}

inline std::vector<erosion::ProbeResult> sample_probes() {
    return {
        sample_probe(0, 950, 0.28, 1), sample_probe(0.01, 950, 0.28, 2), sample_probe(0.05, 950, 0.28, 3),
        sample_probe(0.1, 950, 0.28, 4)};
}

inline study::ResponseCurve sample_response(const char* name, double strength, double dilation) {
    study::ResponseCurve curve{name, {}};
    for (int k = 0; k <= 200; ++k) {
        const double e = 1e-3 * k,
                     q = strength * (1 - std::exp(-e / 0.01)) + 0.3 * strength * (e / 0.03) * std::exp(-e / 0.03);
        curve.rows.push_back({e, 0.003 * (1 - std::exp(-e / 0.004)) - dilation * e, q, 1e5 + q / 3, 0.67 + dilation * e}
        );
    }
    return curve;
}

inline std::vector<figures::Figure> sample_figures() {
    using namespace figures;
    const auto probes = sample_probes();
    const auto erosion = sample_erosion();
    grains::Grading sampled = sample_grading();
    for (double& passing : sampled.passing) {
        passing = std::clamp(passing + 0.004 * std::sin(40 * passing), 0.0, 1.0);
    }
    std::vector<Figure> drawn;
    const auto study = sample_fines_study();
    for (std::optional<Figure> figure :
         {mixture_gradings(sample_mixtures()),
          loose_compression(sample_loose_tests()),
          void_ratios(study),
          active_fines(study),
          contact_classes(study),
          strong_contacts(study),
          test_paths(sample_loose_tests()),
          grading_curves(sample_grading(), sampled, 2.6e-4),
          erosion_loop(erosion),
          speed_by_gradient(probes),
          speed_by_pass(erosion),
          eroded_mass(erosion),
          eroded_coordination(erosion),
          stress_path(erosion),
          porosity_path(erosion),
          rules_compared(probes, {{"", &erosion}}),
          compared_with_twin(erosion),
          constriction_sizes(erosion),
          eroded_grading(sampled, erosion),
          permeability_by_pass(erosion),
          flux_by_size(sample_fluxes()),
          flux_shares(sample_fluxes()),
          triaxial_response(
              {sample_response("before erosion", 3.2e5, 0.06), sample_response("after pass 2", 2.5e5, 0.02)}
          )}) {
        drawn.push_back(std::move(figure).value());
    }
    return drawn;
}

} // namespace suffuse::test
