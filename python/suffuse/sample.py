"""What a world, its contacts and its pores offer beyond their columns."""

import numpy

from suffuse import _core

_COLUMNS = ("i", "j", "overlap", "normal", "normal_force", "shear_force", "force_n")


def _force_n(contacts):
    """contacts: normal force, compression positive [N]."""
    return -numpy.einsum("ca,ca->c", contacts.normal_force, contacts.normal)


def _select(contacts, which):
    """The rows asked for (a mask, numbers or a slice), as a record array: strong.force_n, strong.i, ..."""
    columns = {name: numpy.asarray(getattr(contacts, name)) for name in _COLUMNS}
    kinds = [(name, column.dtype, column.shape[1:]) for name, column in columns.items()]
    rows = numpy.recarray(len(contacts), kinds)
    for name, column in columns.items():
        rows[name] = column
    return rows[which]


def _psd(world):
    """Grading of the grains that are there: sizes [m], rising, and the shares of the mass finer."""
    order = numpy.argsort(world.grains.radius, kind="stable")
    sizes, mass = 2 * world.grains.radius[order], world.grains.mass[order]
    sizes, last = numpy.unique(sizes[::-1], return_index=True)
    share = numpy.cumsum(mass)
    share /= share[-1]
    return sizes, share[len(mass) - 1 - last]


_core.Contacts.force_n = property(_force_n, doc=_force_n.__doc__)
_core.Contacts.__getitem__ = _select
_core.World.psd = property(_psd, doc=_psd.__doc__)


class PoreNetwork(_core.PoreNetwork):
    """The pore network of a periodic packing: of a World, of a stage of a run, or of cell, positions and radii [m]. A
    pore is a tetrahedron of the weighted Delaunay triangulation, a throat a facet; arrays look into it without copying.
    """

    def __init__(self, packing_or_cell, position=None, radius=None):
        self._packing = (getattr(packing_or_cell, "world", packing_or_cell), position, radius)
        super().__init__(*self._packing)

    def solve(self, gradient=0.0, direction="z", viscosity=None, density=None, tensor=False):
        """The flow through the packing: a Seepage.

        gradient: hydraulic gradient i along `direction`, or three numbers: i times the direction of the water
        """
        vector = numpy.asarray(gradient, dtype=float) if not isinstance(gradient, str) else numpy.zeros(())
        if vector.shape == (3,):
            gradient = float(numpy.linalg.norm(vector))
            direction = tuple(vector / gradient) if gradient > 0 else direction
        given = {"viscosity": viscosity, "density": density}
        fluid = _core.Fluid(**{name: value for name, value in given.items() if value is not None})
        return _core.seep(*self._packing, gradient=gradient, direction=direction, fluid=fluid, tensor=tensor)

    def constrictions(self, of="all", merge="none"):
        """Constrictions between all grains, or, of="coarse", of the coarse skeleton of a World.

        merge: which neighboring pores are one void, with no constriction between them; see suffuse.constrictions
        """
        if (of, merge) == ("all", "none"):
            return super().constrictions()
        return _core.constrictions(*self._packing, of=of, merge=merge)
