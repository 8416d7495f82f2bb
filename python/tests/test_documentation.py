"""What help() says of arrays and numbers: their shape and their unit."""

import re

import numpy
import pytest

import suffuse

# "grains x 3: velocity [m/s]." or, of a number, "Mean diameter [m]."
SHAPE = re.compile(r"((?:[a-z]+|\d+)(?: x \d+)*): ")


def described(owner):
    for name in dir(type(owner)):
        if isinstance(getattr(type(owner), name), property) and not name.startswith("_"):
            yield name, getattr(type(owner), name).__doc__, getattr(owner, name)


@pytest.mark.parametrize("kind", ["World", "Grains", "Contacts", "PoreNetwork", "Seepage", "ResolvedFlow", "Constrictions"])
def test_every_array_documents_its_shape_and_every_number_its_unit(settled, kind):
    water = suffuse.seep(settled, gradient=0.05, tensor=True)
    owner = {
        "World": settled, "Grains": settled.grains, "Contacts": settled.contacts, "PoreNetwork": water.network,
        "Seepage": water, "ResolvedFlow": suffuse.resolve_flow(settled, gradient=0.05, tensor=True, boxes_across=4),
        "Constrictions": suffuse.constrictions(settled),
    }[kind]
    rows = {
        "grains": len(settled), "contacts": len(settled.contacts), "pores": water.network.pores,
        "throats": water.network.throats, "constrictions": len(suffuse.constrictions(settled)),
        "n": len(water.network.hidden),
    }
    count = 0
    for name, doc, value in described(owner):
        assert doc, f"{kind}.{name} says nothing"
        if isinstance(value, numpy.ndarray):
            found = SHAPE.match(doc)
            assert found, f"{kind}.{name}: {doc}"
            documented = tuple(int(size) if size.isdigit() else rows[size] for size in found.group(1).split(" x "))
            assert documented == value.shape, f"{kind}.{name}: {doc}"
        if isinstance(value, float) or (isinstance(value, numpy.ndarray) and value.dtype != bool):
            assert re.search(r"\[\S.*?\]", doc), f"{kind}.{name} tells no unit: {doc}"
            count += 1
    assert count >= 2
