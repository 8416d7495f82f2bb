#pragma once
// A flow solution for scripts and for ParaView: the network's pores and throats with their pressures, velocities and
// fluxes. SI units.

#include "suffuse/pores/network.hpp"

#include <filesystem>
#include <span>

namespace suffuse::io {

/// `pores.csv`: `x,y,z,volume,void_volume,pressure,vx,vy,vz`, a row a pore; x, y, z is its power center, vx, vy, vz the
/// mean velocity of its water.
void write_pores_csv(
    const std::filesystem::path& path, const pores::PoreNetwork& network, std::span<const double> pressure,
    std::span<const Vec3> velocity
);

/// `throats.csv`: `pore_1,pore_2,area,hydraulic_radius,inscribed_radius,length,conductance,flux`, a row a throat; pores
/// are rows of `pores.csv`, area is that of the void, the flux goes from the first to the second.
void write_throats_csv(
    const std::filesystem::path& path, const pores::PoreNetwork& network, std::span<const double> conductance,
    std::span<const double> flux
);

/// `pores.vtu`: pores as tetrahedra between the grains at `position`, with `pressure`, `void_volume` and
/// `velocity`.
void write_pores_vtu(
    const std::filesystem::path& path, const pores::PoreNetwork& network, std::span<const Vec3> position,
    std::span<const double> pressure, std::span<const Vec3> velocity
);

} // namespace suffuse::io
