"""Internal stability of a soil by its grading alone, and the atlas of soils that were simulated before."""

import csv
import pathlib

from suffuse import _core
from suffuse.records import gather


class Assessment(dict):
    """What `suffuse assess --json` says of one soil; printed, what it says in the terminal."""

    def verdict(self, criterion):
        """"stable", "transition", "unstable" or "cannot say", by the criterion of this id: "kezdi-1979"."""
        for one in self["criteria"] + self["gradients"]:
            if one["id"] == criterion:
                return one["verdict"]
        known = ", ".join(one["id"] for one in self["criteria"] + self["gradients"])
        raise KeyError(f"{criterion}: no such criterion; there are {known}")

    def __str__(self):
        return self["text"]

    def __repr__(self):
        return f"<suffuse.Assessment of {self['soil']}: {self['summary']}>"


def assess(grading, **settings):
    """An Assessment of a grading: a CSV file, a World, or a pair (sizes [m], shares finer by mass), rising.

    The curve of a World has a step at each size of its grains; between the points of a pair it is linear in log d.

    finer_than: size below which grains count as fine; found on the curve unless given
    relative_density: 0 loosest, 1 densest; both unless given
    coarse_fabric: D60/D10 of the coarse part decides up to which F
    gradient: hydraulic gradient of the seepage; with it porosity, density (of the grains), alpha (mean stress of the
        fines over that of the soil), flow ("up", "down", "level" or the rise, "30deg"; upward unless given)
    sample: of a file with several, by name
    size, and passing, retained, share or mass: columns of a file, "COLUMN" or "COLUMN:UNIT", by heading or number, where the
        file does not decide; by: "mass" or "number"; sheet: the table of a file; rows: its lines, "A-B"

    Criteria that need what the curve does not reach cannot say.
    """
    if isinstance(grading, str):
        grading = pathlib.Path(grading)
    return Assessment(_core.assess(grading, **settings))


def atlas(of="gradients"):
    """A table of simulated soils, as Records.

    of="gradients": a row a sample and flow, of gap-graded soils whose fines rising gradients moved. ratio: D50/d50 of the
    two fractions; fines: their share of the mass; alpha: mean stress of the fines over that of the soil. i_c is the gradient
    of heave; i1, i10 and i50 move 1, 10 and 50 % of the fines' mass: not a number where they were not reached, upper bounds
    where i1_at_most, i10_at_most, i50_at_most are 1. drag_share: of the seepage force, on the fines; load_bearing and
    sifting: shares of the fines' mass that carry load, and that fall through without flow.

    of="filters": a row a sample and gradient, of bases on a uniform filter. ratio: D15 of the filter over d85 of the base;
    width: d85/d15 of the base; gradient: of the base; thickness and constriction: of the base, and the controlling one of the
    filter, over D15; passed, moving and entered: shares of the base's mass through the filter, on its way at the end, and
    beyond the interface; where ended is 0 the motion had not ended, and passed is a lower bound; overlap: over a radius.
    """
    tables = {"gradients": _core.atlas_table, "filters": _core.filter_atlas_table}
    if of not in tables:
        raise _core.CaseError(f'of = "{of}" is not known: expected {" or ".join(tables)}')
    ratios = dict.fromkeys(("thickness", "constriction", "overlap"), "-")
    return gather(list(csv.DictReader(tables[of]().splitlines())), ratios)
