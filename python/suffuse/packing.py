"""Packings from and for other programs."""

import warnings

from suffuse import _core
from suffuse.spelling import spelled


@spelled
def read_packing(path, cell=None, material=None, unit="1 m", max_overlap=0.1, radius=None, velocity_gradient=None, box=None,
                 contacts=None):
    """A World of the grains in a file, whichever of the formats it is: tables (CSV, Yade, PFC, EDEM, MFIX, ParaView),
    LAMMPS data and dump, XYZ, VTK, MercuryDPM, Kratos; plain or gzipped. docs/packings.md lists what is understood.

    cell: three edges or a 3 x 3 matrix whose columns are the cell vectors [m]; the file's own unless given.
    material: a Material, whose density [kg/m3] gives the masses; suffuse.Material() unless given
    unit: what a length of 1 stands for where the file names no unit, "mm" for a file in mm; grains of a size that no soil
        has are warned of
    max_overlap: largest overlap that is accepted / radius of the smaller grain, as in a case
    radius: of all grains, for a file that has none [m]
    velocity_gradient: dv/dx of the cell, extension positive [1/s], which the velocities of the file contain; the one that
        fits them best unless given, and none where no mean motion shows
    box: two corners of a box to cut out of a bed between walls, in the file's coordinates [m]: the grains with their centers in
        it, as a periodic cell. Of two that overlap across a face by more than max_overlap, the smaller one is left out.
    contacts: file of shear forces and moments, written by write_packing or a LAMMPS dump (docs/packings.md)
    What the file says beyond that is warned of, and so are a cell narrower than ten of the largest grains, one that they
    barely fill, and one taken in place of the file's own. Without `contacts` the contacts remember nothing: settle it first.
    """
    world, remarks = _core.read_packing(
        path, cell, material or _core.Material(), unit, max_overlap, radius, velocity_gradient, box, contacts
    )
    for remark in remarks:
        warnings.warn(remark, stacklevel=3)  # beyond what looks at the spelling
    return world


@spelled
def read(path, format=None, cell=None, material=None):
    """A packing from elsewhere, as read_packing; `format` ("csv", "yade", "lammps", "dump", "xyz", "vtp") is what the
    caller takes the file for. The file itself decides: an unknown word is an error, a known one is only a remark."""
    known = ("csv", "yade", "lammps", "dump", "xyz", "vtp")
    if format is not None and format not in known:
        raise _core.UsageError(f"format {format!r}: it is one of {', '.join(known)}")
    return read_packing(path, cell, material)


@spelled
def write_packing(path, world, format=None, contacts=None):
    """Writes the grains of a World for other programs: csv, yade, xyz, lammps, dump, vtp; by the file's ending unless
    `format` is given. contacts: a CSV file for shear forces and moments, as read_packing takes it."""
    for file in (path, contacts):
        if file is not None:
            _core.require_outside_runs(file)
    _core.write_packing(path, world, format or "")
    if contacts is not None:
        _core.write_contacts(contacts, world)
