"""What the tests share: a packing, worlds and a run made from it."""

import os
import pathlib

import numpy
import pytest

import suffuse

ROOT = pathlib.Path(os.environ["SUFFUSE_SOURCE_DIR"])
PACKING = ROOT / "examples" / "replay" / "packing.csv"
CELL = (1.4360856339985508e-3, 1.4358137235332051e-3, 1.436026846625529e-3)


@pytest.fixture
def packing():
    """500 grains that were settled at 100 kPa by Yade, without contacts."""
    return suffuse.read_packing(PACKING, cell=CELL)


@pytest.fixture(scope="session")
def settled_once():
    world = suffuse.read_packing(PACKING, cell=CELL)
    world.sort()
    world.settle(suffuse.Loading(stress="100 kPa"))
    return world


@pytest.fixture
def settled(settled_once):
    return settled_once.copy()


@pytest.fixture
def small_case(tmp_path):
    """The replay example with few steps: import, settle, advance, flow."""
    text = (ROOT / "examples" / "replay" / "case.toml").read_text().replace("2_000", "200")
    folder = tmp_path / "small"
    folder.mkdir()
    (folder / "case.toml").write_text(text)
    (folder / "packing.csv").write_bytes(PACKING.read_bytes())
    return folder / "case.toml"


@pytest.fixture
def two_grains():
    """Two equal grains that overlap by a hundredth of their radius."""
    radius = 1e-3
    position = numpy.array([[5e-3, 5e-3, 5e-3], [5e-3 + 1.99 * radius, 5e-3, 5e-3]])
    return suffuse.World((10e-3, 10e-3, 10e-3), position, [radius, radius])
