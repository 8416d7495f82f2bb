#include "suffuse/dem/move_grains.hpp"

#include "suffuse/base/clones.hpp"
#include "suffuse/base/parallel.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace suffuse::dem {
namespace {

constexpr std::size_t tile_rows = 64;

using Row = std::array<double, tile_rows>;

struct Rows3 {
    Row x, y, z;

    [[nodiscard]] Vec3 at(std::size_t k) const { return {x[k], y[k], z[k]}; }

    void set(std::size_t k, const Vec3& v) { x[k] = v.x, y[k] = v.y, z[k] = v.z; }
};

/// Grains of a tile by component, so that the loop that moves them runs in vector instructions.
struct alignas(64) Tile {
    Rows3 position, velocity, spin, force, torque, reference;
    Row mass, inertia, free, moved2;
};

/// Contact force and torque on grain `g`: first the contacts in which it is the first grain, then the others.
void gather(
    const contact::Incidence& incidence, const std::vector<contact::ContactForce>& forces, std::size_t g, Vec3& force,
    Vec3& torque
) {
    for (std::uint32_t c = incidence.first_start[g]; c < incidence.first_start[g + 1]; ++c) {
        force -= forces[c].force;
        torque += forces[c].torque_1;
    }
    for (std::uint32_t k = incidence.second_start[g]; k < incidence.second_start[g + 1]; ++k) {
        const contact::ContactForce& f = forces[incidence.second_contact[k]];
        force += f.force;
        torque += f.torque_2;
    }
}

void load(
    const StepCaches& caches, const grains::GrainLoad* load, double load_share, std::size_t begin, std::size_t rows,
    grains::Grains& grains, Tile& tile
) {
    const bool loaded = load != nullptr && !load->force.empty();
    for (std::size_t k = 0; k < rows; ++k) {
        const std::size_t g = begin + k;
        Vec3 force, torque;
        gather(caches.neighborhood.incidence(), caches.forces, g, force, torque);
        grains.force[g] = force;
        grains.torque[g] = torque;
        if (loaded) {
            force += load_share * load->force[g];
        }
        tile.force.set(k, force);
        tile.torque.set(k, torque);
        tile.position.set(k, grains.position[g]);
        tile.velocity.set(k, grains.velocity[g]);
        tile.spin.set(k, grains.spin[g]);
        tile.reference.set(k, caches.neighborhood.reference()[g]);
        tile.mass[k] = grains.mass[g];
        tile.inertia[k] = grains.inertia[g];
        tile.free[k] = grains.motion[g] == grains::Motion::Free ? 1.0 : 0.0;
    }
}

SUFFUSE_CLONES void move(const motion::StepMotion& step, const Mat3& mean_motion, std::size_t rows, Tile& t) {
#pragma GCC ivdep
    for (std::size_t k = 0; k < rows; ++k) {
        Vec3 position = t.position.at(k), velocity = t.velocity.at(k), spin = t.spin.at(k);
        motion::move(step, t.force.at(k), t.torque.at(k), t.mass[k], t.inertia[k], t.free[k], position, velocity, spin);
        t.position.set(k, position);
        t.velocity.set(k, velocity);
        t.spin.set(k, spin);
        t.moved2[k] = norm2(position - mean_motion * t.reference.at(k));
    }
}

double store(const Tile& tile, std::size_t begin, std::size_t rows, grains::Grains& grains) {
    double most = 0;
    for (std::size_t k = 0; k < rows; ++k) {
        const std::size_t g = begin + k;
        grains.position[g] = tile.position.at(k);
        grains.velocity[g] = tile.velocity.at(k);
        grains.spin[g] = tile.spin.at(k);
        most = std::max(most, tile.moved2[k]);
    }
    return most;
}

} // namespace

double move_grains(
    const motion::StepMotion& step, const StepCaches& caches, const grains::GrainLoad* grain_load, double load_share,
    const Mat3& h, grains::Grains& grains
) {
    // The cell moves on with the new gradient in the next step, when this motion is looked at.
    const Mat3 next_h = h + step.dt * ((step.old_gradient + step.change) * h);
    const Mat3 mean_motion = next_h * inverse(caches.neighborhood.reference_h());
    const double square = parallel_sum(
        grains.size(), 8 * tile_rows, 0.0,
        [&](std::size_t begin, std::size_t end) {
            Tile tile;
            double most = 0;
            for (std::size_t g = begin; g < end; g += tile_rows) {
                const std::size_t rows = std::min(tile_rows, end - g);
                load(caches, grain_load, load_share, g, rows, grains, tile);
                move(step, mean_motion, rows, tile);
                most = std::max(most, store(tile, g, rows, grains));
            }
            return most;
        },
        [](double a, double b) { return std::max(a, b); }
    );
    return std::sqrt(square);
}

} // namespace suffuse::dem
