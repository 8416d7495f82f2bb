#pragma once
// Worlds that steps are measured on: the reference's packing and copies of it, lattices of touching spheres, and a
// coarse lattice with fines in its voids.

#include "suffuse/dem/order.hpp"
#include "suffuse/dem/settle.hpp"
#include "suffuse/dem/step.hpp"

#include "tests/support/worlds.hpp"

namespace suffuse::bench {

inline constexpr double pressure = 100e3;      // [Pa]
inline constexpr double reference_dt = 4.1e-8; // 0.3 of the P-wave's crossing of the smallest grain [s]

struct Scene {
    dem::World world;
    dem::StepCaches caches;
    dem::StepPlan plan;

    void advance(std::int64_t steps) { test::advance(world, caches, plan, steps); }

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
inline Scene compressed(const std::string& packing, int copies, std::int64_t steps) {
    Scene scene;
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

} // namespace suffuse::bench
