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


@pytest.fixture(scope="session")
def soil_once(settled_once):
    """500 settled grains, 240 of which count as fines."""
    world = settled_once.copy()
    world.grains.fine = world.grains.radius < numpy.median(world.grains.radius)
    return world


@pytest.fixture
def soil(soil_once):
    return soil_once.copy()


@pytest.fixture
def eroding_case(soil, tmp_path):
    """The same grains settled again and eroded twice."""
    folder = tmp_path / "case"
    folder.mkdir()
    suffuse.write_packing(folder / "packing.xyz", soil)
    finer_than = soil.grains.diameter[soil.grains.fine].max() * (1 + 1e-9)
    (folder / "case.toml").write_text(f"""schema = 1
title = "An erosion"
[grain]
density = "2600 kg/m^3"
[contact]
modulus = "356 MPa"
[soil.sand]
psd = {{ d = ["0.1 mm", "0.5 mm"], passing = ["0 %", "100 %"] }}
fines = {{ finer_than = "{1e3 * finer_than} mm" }}
[study.erosion]
soil = "sand"
[[study.erosion.stage]]
name = "start"
do = "import"
packing = "packing.xyz"
[[study.erosion.stage]]
name = "settled"
do = "settle"
pressure = "100 kPa"
[[study.erosion.stage]]
name = "eroded"
do = "erode"
gradient = 0.5
passes = 2
ramp = 100
watch = 100
passes_constriction = {{ size = "none" }}
""")
    return folder / "case.toml"


@pytest.fixture
def cloud():
    radius = numpy.random.default_rng(1).uniform(0.2e-3, 0.6e-3, 100)
    return suffuse.make_cloud(radius, porosity=0.65)
