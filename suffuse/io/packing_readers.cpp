#include "suffuse/io/packing_readers.hpp"

#include "suffuse/io/kratos_file.hpp"
#include "suffuse/io/lammps_dump.hpp"
#include "suffuse/io/lammps_file.hpp"
#include "suffuse/io/legacy_vtk.hpp"
#include "suffuse/io/mercury_file.hpp"
#include "suffuse/io/plain_xyz.hpp"
#include "suffuse/io/text_packing.hpp"
#include "suffuse/io/vtp_file.hpp"
#include "suffuse/io/xyz_file.hpp"

#include <array>

namespace suffuse::io {
namespace {

using Source = PackingSource;

bool is_any_text(std::string_view) {
    return true;
}

constexpr std::array readers{
    PackingReader{
        "VTK, `.vtp` and `.vtu`", "`<VTKFile` at the beginning",
        "points; point array `radius` or `diameter`, perhaps `velocity` (Yade: `linVelVec`), `angular_velocity` "
        "(`angVelVec`), `fine`; ASCII, base64 or appended, plain or zlib, little-endian",
        "field array `cell` of nine numbers, vector after vector, which only our own files have", false, looks_like_vtp,
        [](const Source& s) { return parse_vtp(s.file, s.text, s.density, s.radius); }},
    PackingReader{
        "legacy VTK, `.vtk`", "`# vtk DataFile` in line 1", "likewise, ASCII or binary", "none", false,
        looks_like_legacy_vtk, [](const Source& s) { return parse_vtp(s.file, s.text, s.density, s.radius); }},
    PackingReader{
        "LAMMPS dump (`dump custom`)", "`ITEM:` in line 1",
        "the last frame: `x y z`, `xu yu zu`, `xs ys zs` or `xsu ysu zsu`; `radius` or `diameter`; perhaps `vx vy vz`, "
        "`omegax omegay omegaz`",
        "its box, also `xy xz yz` and `abc origin`, where its boundaries are `pp pp pp` or not written", false,
        looks_like_lammps_dump, [](const Source& s) { return parse_lammps_dump(s.file, s.text, s.density, s.radius); }},
    PackingReader{
        "MercuryDPM `.restart`", "`restart_version` in line 1",
        "particles by their words; contact memory and walls are not read, with a warning", "three `PeriodicBoundary`",
        true, looks_like_mercury_restart,
        [](const Source& s) { return parse_mercury_restart(s.file, s.text, s.density); }},
    PackingReader{
        "MercuryDPM `.data`", "8 numbers in line 1 and 14 in line 2",
        "the last frame, of three dimensions: position, velocity, radius, spin",
        "its box, with a warning: the file does not say which sides are walls", true, looks_like_mercury_data,
        [](const Source& s) { return parse_mercury_data(s.file, s.text, s.density); }},
    PackingReader{
        "Kratos `.mdpa`", "`Begin` and the name of a section in the first line that is no comment",
        "`Nodes` and `NodalData RADIUS`; a warning names other nodal data", "none", false, looks_like_kratos,
        parse_kratos},
    PackingReader{
        "extended XYZ (OVITO, ASE)", "`Properties=` in line 2",
        "the first frame: `pos:R:3`, `radius:R:1` or `diameter:R:1`, perhaps `velo:R:3`, `angular_velocity:R:3`, "
        "`fine:I:1`",
        "`Lattice` and `Origin`, unless `pbc` has an `F`", false, looks_like_extended_xyz, parse_extended_xyz},
    PackingReader{
        "plain XYZ (OVITO, exaDEM)", "a whole number alone in line 1, and rows of numbers from line 3 on",
        "the first frame: the kind of the grain, x, y, z; or x, y, z; such a file has no radii",
        "three lengths in line 2, with a warning: the file does not say which sides are walls", false,
        looks_like_plain_xyz, parse_plain_xyz},
    PackingReader{
        "LAMMPS data, `atom_style sphere`, or `hybrid` that begins with it", "a line with a number and `atoms`",
        "`Atoms` (id, type, diameter, density, x, y, z, perhaps three images), `Velocities`; other sections are "
        "skipped with a warning; density and images are not used",
        "its box, sheared too, also `avec bvec cvec` and `abc origin`; the file does not say whether it is periodic",
        false, looks_like_lammps, [](const Source& s) { return parse_lammps(s.file, s.text, s.density, s.radius); }},
    PackingReader{
        "table (CSV, Yade, PFC, EDEM, MFIX, ParaView)", "any other text", "columns by their headings, see below",
        "`##PERIODIC:: LX LY LZ`, as Yade's `SpherePack.save` writes it", false, is_any_text, parse_table},
};

} // namespace

std::span<const PackingReader> packing_readers() {
    return readers;
}

} // namespace suffuse::io
