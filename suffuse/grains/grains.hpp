#pragma once
// The grain table: one row a grain, one column a field. Rows may be stored in any order; `id` is stable and never
// reused.

#include "suffuse/base/constants.hpp"
#include "suffuse/base/vec3.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace suffuse::grains {

enum class Motion : std::uint8_t {
    Free,
    Held, ///< keeps its velocity and spin, whatever the forces; the cell carries it along
};

struct Grains {
    std::vector<Vec3> position;     ///< not wrapped into the cell [m]
    std::vector<Vec3> velocity;     ///< absolute: with the cell's mean motion [m/s]
    std::vector<Vec3> spin;         ///< [rad/s]
    std::vector<Vec3> force;        ///< contact force of the last step [N]
    std::vector<Vec3> torque;       ///< contact torque of the last step [N m]
    std::vector<double> radius;     ///< [m]
    std::vector<double> mass;       ///< [kg]
    std::vector<double> inertia;    ///< [kg m2]
    std::vector<std::uint32_t> id;  ///< stable, never reused
    std::vector<Motion> motion;     ///< Free unless held
    std::vector<std::uint8_t> fine; ///< 1: belongs to the fine fraction of the soil

    [[nodiscard]] std::size_t size() const { return radius.size(); }
};

/// Adds a grain at rest; `id` is its row at that time unless given. @return its row.
inline std::uint32_t add_grain(Grains& grains, const Vec3& position, double radius, double density) {
    const auto g = static_cast<std::uint32_t>(grains.size());
    const double mass = density * sphere_volume(radius);
    grains.position.push_back(position);
    grains.velocity.emplace_back();
    grains.spin.emplace_back();
    grains.force.emplace_back();
    grains.torque.emplace_back();
    grains.radius.push_back(radius);
    grains.mass.push_back(mass);
    grains.inertia.push_back(sphere_inertia(mass, radius));
    grains.id.push_back(g);
    grains.motion.push_back(Motion::Free);
    grains.fine.push_back(0);
    return g;
}

/// Calls `visit(column)` on every column, in a fixed order: what selects, permutes, hashes and saves rows is written
/// once.
template <class Table, class Visit>
void for_each_column(Table& grains, Visit&& visit) {
    visit(grains.position);
    visit(grains.velocity);
    visit(grains.spin);
    visit(grains.force);
    visit(grains.torque);
    visit(grains.radius);
    visit(grains.mass);
    visit(grains.inertia);
    visit(grains.id);
    visit(grains.motion);
    visit(grains.fine);
}

/// Rows `rows` of every column, in that order: permutes, selects or removes grains.
inline void select_rows(Grains& grains, std::span<const std::uint32_t> rows) {
    for_each_column(grains, [&](auto& column) {
        std::remove_reference_t<decltype(column)> chosen;
        chosen.reserve(rows.size());
        for (const std::uint32_t g : rows) {
            chosen.push_back(column[g]);
        }
        column = std::move(chosen);
    });
}

/// Volume of the solid [m3].
inline double solid_volume(const Grains& grains) {
    double volume = 0;
    for (const double r : grains.radius) {
        volume += sphere_volume(r);
    }
    return volume;
}

} // namespace suffuse::grains
