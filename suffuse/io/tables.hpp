#pragma once
// The CSV tables of a stage: names and columns are a promise to users' scripts (docs: formats). SI units.

#include "suffuse/dem/world.hpp"
#include "suffuse/grains/load.hpp"

#include <filesystem>
#include <span>

namespace suffuse::io {

/// `grains.csv`: `id,x,y,z,r,vx,vy,vz,wx,wy,wz,fx,fy,fz,tx,ty,tz,contacts,fine`, in order of id; with a row a grain of
/// `mobile_gradient`, in storage order, that column too.
void write_grains_csv(
    const std::filesystem::path& path, const dem::World& world, std::span<const double> mobile_gradient = {}
);

/// `contacts.csv`: `i,j,overlap,nx,ny,nz,fnx,fny,fnz,fsx,fsy,fsz,mx,my,mz`; i < j are ids, in their
/// order; the normal points from i to j, force and moment act on i.
void write_contacts_csv(const std::filesystem::path& path, const dem::World& world);

/// `grain_forces.csv`: `id,fx,fy,fz`, the fluid's force on each grain, in order of id.
void write_grain_forces_csv(
    const std::filesystem::path& path, const grains::Grains& grains, const grains::GrainLoad& load
);

} // namespace suffuse::io
