"""What a world, its contacts and its pores offer beyond their columns; and functions that make or read worlds."""

import numpy

from suffuse import _core
from suffuse.spelling import spelled

_COLUMNS = (
    "i", "j", "image", "overlap", "normal", "normal_force", "shear_force", "moment", "force_n", "sliding", "rolling",
)


def _force_n(contacts):
    """contacts: normal force, compression positive [N]."""
    return -numpy.einsum("ca,ca->c", contacts.normal_force, contacts.normal)


def _select(contacts, which):
    """The requested rows (a mask, numbers or a slice), as a record array: strong.force_n, strong.i, ..."""
    columns = {name: numpy.asarray(getattr(contacts, name)) for name in _COLUMNS}
    kinds = [(name, column.dtype, column.shape[1:]) for name, column in columns.items()]
    rows = numpy.recarray(len(contacts), kinds)
    for name, column in columns.items():
        rows[name] = column
    return rows[which]


@spelled
def _solve(network, gradient=0.0, direction="z", viscosity=None, density=None, tensor=False, conductance=None):
    """The flow through the packing: a Seepage.

    gradient: hydraulic gradient i along `direction`, or three numbers: i times the direction of the water [-]
    viscosity [Pa s] and density [kg/m3]: those of Fluid() unless given
    tensor: solves three directions and reports the permeability tensor
    conductance: "bounded" or "yade"; that of Fluid() unless given
    """
    vector = numpy.asarray(gradient, dtype=float) if not isinstance(gradient, str) else numpy.zeros(())
    if vector.shape == (3,):
        gradient = float(numpy.linalg.norm(vector))
        direction = tuple(vector / gradient) if gradient > 0 else direction
    given = {"viscosity": viscosity, "density": density, "conductance": conductance}
    fluid = _core.Fluid(**{name: value for name, value in given.items() if value is not None})
    return _core.seep(network, gradient=gradient, direction=direction, fluid=fluid, tensor=tensor)


_core.Contacts.force_n = property(_force_n, doc=_force_n.__doc__)
_core.Contacts.__getitem__ = _select
_core.PoreNetwork.solve = _solve


def _as(core):
    """Marks a function of ours as what stands for one of pybind11's: those cannot be sent to another process."""

    def take(function):
        function.__doc__ = core.__doc__.partition("\n\n")[2]
        function.__module__ = "suffuse"
        return function

    return take


@spelled
@_as(_core.seep)
def seep(
    packing_or_cell, position=None, radius=None, *, gradient=0.0, direction="z", fluid=None, tensor=False,
    conductance=None, solver="network", resolve=None, resolve_tolerance=1e-4
):
    return _core.seep(
        packing_or_cell, position, radius, gradient=gradient, direction=direction, fluid=fluid or _core.Fluid(),
        tensor=tensor, conductance=conductance, solver=solver, resolve=resolve, resolve_tolerance=resolve_tolerance,
    )


@spelled
@_as(_core.resolve_flow)
def resolve_flow(
    packing_or_cell, position=None, radius=None, *, gradient=0.0, direction="z", fluid=None, tensor=False, boxes_across=12.0,
    tolerance=1e-4
):
    return _core.resolve_flow(
        packing_or_cell, position, radius, gradient=gradient, direction=direction, fluid=fluid or _core.Fluid(),
        tensor=tensor, boxes_across=boxes_across, tolerance=tolerance,
    )


@spelled
@_as(_core.constrictions)
def constrictions(packing_or_cell, position=None, radius=None, *, of="all", merge="none"):
    return _core.constrictions(packing_or_cell, position, radius, of=of, merge=merge)


@spelled
@_as(_core.make_cloud)
def make_cloud(radius, porosity=0.65, *, fine=None, material=None, seed=0):
    return _core.make_cloud(radius, porosity, fine=fine, material=material or _core.Material(), seed=seed)


@_as(_core.largest_overlap)
def largest_overlap(world):
    return _core.largest_overlap(world)


@_as(_core.set_threads)
def set_threads(threads=0):
    _core.set_threads(threads)
