#pragma once
// Worlds that steps are measured on: the reference's packing and copies of it, lattices of touching spheres, and a
// coarse lattice with fines in its voids.

#include "suffuse/dem/order.hpp"
#include "suffuse/dem/settle.hpp"
#include "suffuse/dem/step.hpp"
#include "suffuse/packing/seed.hpp"

#include "tests/support/worlds.hpp"
#include <algorithm>
#include <cmath>
#include <vector>

namespace suffuse::bench {

inline constexpr double pressure = 100e3;      // [Pa]
inline constexpr double reference_dt = 4.1e-8; // 0.3 of the P-wave's crossing of the smallest grain [s]

struct Scene {
    dem::World world;
    dem::StepCaches caches;
    dem::StepPlan plan;

    void advance(std::int64_t steps) { dem::advance(world, caches, plan, steps); }

    [[nodiscard]] double grains() const { return static_cast<double>(world.grains.size()); }

    /// Touching now.
    [[nodiscard]] double contacts() const { return static_cast<double>(dem::measure_equilibrium(world).contacts); }
};

/// `copies`^3 times the grains, at rest and without contact memory.
inline dem::World replicated(const dem::World& one, int copies) {
    dem::World world;
    world.material = one.material;
    world.cell.h = world.reference_h = static_cast<double>(copies) * one.cell.h;
    for (int a = 0; a < copies; ++a) {
        for (int b = 0; b < copies; ++b) {
            for (int c = 0; c < copies; ++c) {
                const Vec3 shift = cell::shift(one.cell.h, {a, b, c});
                for (std::size_t g = 0; g < one.grains.size(); ++g) {
                    test::add(world, one.grains.position[g] + shift, one.grains.radius[g]);
                }
            }
        }
    }
    return world;
}

/// A reference packing under 100 kPa, after `steps`: contacts have their memory, the neighbor lists their margins.
inline Scene
compressed(const std::string& packing, int copies, std::int64_t steps, dem::Mode mode = dem::Mode::Reference) {
    Scene scene;
    scene.plan.mode = mode;
    scene.world = replicated(test::reference_packing(packing), copies);
    dem::sort_along_curve(scene.world);
    scene.plan.dt = reference_dt;
    scene.plan.loading = dem::isotropic_stress(pressure);
    scene.advance(steps);
    return scene;
}

/// `cells`^3 cubes of side `a` with spheres of radius `r` at `places` (in sides), in a cell that keeps its shape.
inline Scene
lattice(int cells, double a, const std::vector<std::pair<Vec3, double>>& places, double dt = reference_dt) {
    Scene scene;
    scene.world = test::empty_world(cells * a);
    for (int i = 0; i < cells; ++i) {
        for (int j = 0; j < cells; ++j) {
            for (int k = 0; k < cells; ++k) {
                for (const auto& [s, r] : places) {
                    test::add(scene.world, a * Vec3{i + s.x, j + s.y, k + s.z}, r);
                }
            }
        }
    }
    dem::sort_along_curve(scene.world);
    scene.plan.dt = dt;
    scene.plan.loading = dem::constant_volume();
    scene.advance(20);
    return scene;
}

inline constexpr double touch = 1 - 1e-4; // distance of touching spheres, over the sum of their radii [-]

/// Face-centered: twelve contacts a grain.
inline Scene dense_lattice(int cells) {
    const double r = 1e-4, side = touch * 4 * r / std::sqrt(2.0);
    return lattice(cells, side, {{{0, 0, 0}, r}, {{0.5, 0.5, 0}, r}, {{0.5, 0, 0.5}, r}, {{0, 0.5, 0.5}, r}});
}

/// Simple cubic: six contacts a grain.
inline Scene cubic_lattice(int cells) {
    const double r = 1e-4;
    return lattice(cells, touch * 2 * r, {{{0, 0, 0}, r}});
}

/// Size ratio 10: a simple cubic skeleton whose voids hold cubes of 4^3 touching fines. Nothing confines these, so the
/// time step is too short for them to part.
inline Scene bimodal(int cells) {
    const double coarse = 5e-4, fine = coarse / 10, side = touch * 2 * coarse, step = touch * 2 * fine / side;
    std::vector<std::pair<Vec3, double>> places{{{0, 0, 0}, coarse}};
    for (int k = 0; k < 64; ++k) {
        const Vec3 n{k / 16 - 1.5, k / 4 % 4 - 1.5, k % 4 - 1.5};
        places.push_back({Vec3{0.5, 0.5, 0.5} + step * n, fine});
    }
    return lattice(cells, side, places, 1e-4 * reference_dt);
}

/// Radii of `grains` grains between 1 and `ratio` times the smallest: as much volume in each octave.
inline std::vector<double> graded_radii(std::size_t grains, double ratio) {
    std::vector<double> radii;
    for (std::size_t g = 0; g < grains; ++g) { // the share of grains that are finer than d is (1 - d^-3)/(1 - ratio^-3)
        const double finer = (static_cast<double>(g) + 0.5) / static_cast<double>(grains);
        radii.push_back(1e-5 / std::cbrt(1 - finer * (1 - std::pow(ratio, -3))));
    }
    std::reverse(radii.begin(), radii.end());
    return radii;
}

/// A continuous grading, with 1.66 contacts a grain whatever the size ratio, as the settled packing has: a cloud whose
/// grains are blown up until so many touch. It is not in balance, so the time step is too short for it to move.
inline Scene graded(std::size_t grains, double ratio) {
    packing::PackSpec spec;
    spec.porosity = 0.5;
    grains::SampledGrains sample;
    sample.radius = graded_radii(grains, ratio);
    sample.fine.assign(grains, 0);
    const packing::Cloud cloud = packing::make_cloud(sample, spec, 2600, 7);
    constexpr double most = 1.3; // of the radii
    std::vector<double> radius = cloud.grains.radius;
    for (double& r : radius) {
        r *= most;
    }
    std::vector<double> touching_from; // the factor on the radii at which each near pair touches
    for (const auto& [i, j, image] : neighbors::find_pairs(cloud.cell.h, cloud.grains.position, radius, 0)) {
        const Vec3 branch = cloud.grains.position[j] + cell::shift(cloud.cell.h, image) - cloud.grains.position[i];
        touching_from.push_back(norm(branch) / (cloud.grains.radius[i] + cloud.grains.radius[j]));
    }
    const std::size_t wanted = std::min(touching_from.size() - 1, grains * 166 / 100);
    std::nth_element(
        touching_from.begin(), touching_from.begin() + static_cast<std::ptrdiff_t>(wanted), touching_from.end()
    );
    Scene scene;
    scene.world.cell = cloud.cell;
    scene.world.reference_h = cloud.cell.h;
    for (std::size_t g = 0; g < grains; ++g) {
        test::add(scene.world, cloud.grains.position[g], touching_from[wanted] * cloud.grains.radius[g]);
    }
    dem::sort_along_curve(scene.world);
    scene.plan.dt = 1e-4 * reference_dt;
    scene.plan.loading = dem::constant_volume();
    scene.advance(20);
    return scene;
}

} // namespace suffuse::bench
