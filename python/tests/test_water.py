"""Pore networks and flow, on worlds and on packings brought as arrays."""

import copy
import gc
import pickle

import numpy
import pytest

import suffuse


def test_pores_fill_the_cell_and_their_voids_the_porosity(packing):
    network = suffuse.PoreNetwork(packing)
    volume = numpy.linalg.det(packing.cell)
    assert network.pore_volume.sum() == pytest.approx(volume, rel=1e-12)  # rounding of 13,000 terms
    # Overlaps of a settled packing, 3e-4 of the radius, are counted in both grains of a contact.
    assert network.void_volume.sum() / volume == pytest.approx(packing.porosity, rel=1e-4)
    assert network.side.shape == (network.throats, 2) and network.pore_grain.shape == (network.pores, 4)
    assert network.throats == 2 * network.pores  # four facets a tetrahedron, each shared by two


def test_columns_of_a_network_outlive_it(packing):
    radius = suffuse.PoreNetwork(packing).inscribed_radius
    gc.collect()
    assert not radius.flags.owndata and not radius.flags.writeable and (radius < packing.grains.radius.max()).all()


def test_corners_of_a_pore_with_their_images_have_its_volume(packing):
    network = suffuse.PoreNetwork(packing)
    corners = packing.grains.position[network.pore_grain] + network.pore_grain_image @ packing.cell.T
    edges = corners[:, 1:] - corners[:, :1]
    assert numpy.abs(numpy.linalg.det(edges)) / 6 == pytest.approx(network.pore_volume, rel=1e-9)


def test_flow_takes_arrays_or_a_world_and_balances_its_forces(packing):
    water = suffuse.seep(packing, gradient=0.05, direction="x", tensor=True)
    same = suffuse.seep(packing.cell, packing.grains.position, packing.grains.radius, gradient=0.05, direction="x")
    assert same.permeability == water.permeability and (same.grain_force == water.grain_force).all()
    volume = numpy.linalg.det(packing.cell)
    assert water.pressure_gradient == pytest.approx([-0.05 * 1000 * 9.81, 0, 0])
    assert water.grain_force.sum(axis=0) == pytest.approx(-volume * water.pressure_gradient, abs=1e-9 * volume * 490)
    assert water.tensor[0, 0] == pytest.approx(water.permeability, rel=1e-9)
    # Darcy's law closes the loop: v = -k/mu grad p.
    assert water.mean_velocity[0] == pytest.approx(water.permeability / 1e-3 * 0.05 * 1000 * 9.81, rel=1e-9)
    flux = numpy.zeros(water.network.pores)
    numpy.add.at(flux, water.network.side[:, 0], water.flux)
    numpy.add.at(flux, water.network.side[:, 1], -water.flux)
    assert numpy.abs(flux).max() < 1e-9 * numpy.abs(water.flux).max()  # what flows in flows out


def test_water_moves_from_pore_to_pore_as_it_does_on_the_whole(packing):
    water = suffuse.seep(packing, gradient=0.05, direction="x")
    volume, void = numpy.linalg.det(packing.cell), water.network.void_volume
    assert water.pore_velocity.shape == (water.network.pores, 3)
    assert void @ water.pore_velocity == pytest.approx(volume * water.mean_velocity, rel=1e-9)
    speed = numpy.linalg.norm(water.pore_velocity, axis=1)
    winding = void @ speed / (volume * numpy.linalg.norm(water.mean_velocity))
    assert water.tortuosity == pytest.approx(winding, rel=1e-9) and 1.05 < winding < 2
    assert numpy.isnan(suffuse.seep(packing).tortuosity)  # at rest


def test_water_reports_whether_it_is_slow_enough_for_a_flow_without_inertia(packing, small_case, tmp_path):
    water = suffuse.seep(packing, gradient=0.05, direction="x")
    radius = packing.grains.radius
    sauter = 2 * (radius**3).sum() / (radius**2).sum()
    assert water.reynolds_number == pytest.approx(1000 * water.mean_velocity[0] * sauter / 1e-3, rel=1e-9)
    assert 0.99 < water.flux_left_by_inertia < 1
    with pytest.warns(UserWarning, match="at i = -500 the water in the packing has a Reynolds number of"):
        fast = suffuse.seep(packing, gradient=-500, direction="x")
    assert fast.reynolds_number == pytest.approx(10000 * water.reynolds_number, rel=1e-9)
    assert fast.flux_left_by_inertia < 0.9 and suffuse.seep(packing).reynolds_number == 0
    stage = suffuse.Case(small_case).run(tmp_path / "run")["replay/seep"]  # the program's own number
    again = suffuse.seep(stage, gradient=stage["gradient"], direction="x", conductance="yade")  # as the case has it
    assert again.reynolds_number == stage["reynolds_number"] and again.permeability == stage["permeability_along"]


def test_flow_is_linear_in_gradient_and_viscosity(packing):
    one = suffuse.seep(packing, gradient=0.01)
    ten = suffuse.seep(packing, gradient="10 %", fluid=suffuse.Fluid(viscosity="2 mPa*s"))
    assert ten.permeability == pytest.approx(one.permeability, rel=1e-9)
    assert ten.grain_force == pytest.approx(10 * one.grain_force, rel=1e-6, abs=1e-18)
    assert ten.mean_velocity[2] == pytest.approx(5 * one.mean_velocity[2], rel=1e-9)


def test_constrictions_of_equal_spheres_in_a_cubic_lattice():
    # Face-centered cubic, slightly apart: every facet of three touching grains has the gap 2 (2/sqrt(3) - 1) r.
    edge, r = 1.0, 0.5 / numpy.sqrt(2)
    lattice = numpy.array([[0, 0, 0], [0.5, 0.5, 0], [0.5, 0, 0.5], [0, 0.5, 0.5]])
    cells = numpy.array([[i, j, k] for i in range(3) for j in range(3) for k in range(3)])
    position = (cells[:, None] + lattice[None]).reshape(-1, 3) * edge
    found = suffuse.constrictions((3 * edge,) * 3, position, numpy.full(len(position), r))
    assert found.diameter.min() == pytest.approx(2 * r * (2 / numpy.sqrt(3) - 1), rel=1e-6)
    assert found.mean == pytest.approx(found.diameter.mean(), rel=1e-12)


def test_merged_voids_have_each_square_window_of_a_simple_cubic_lattice_once():
    r, n = 1e-3, 3
    position = numpy.array([[i, j, k] for i in range(n) for j in range(n) for k in range(n)]) * 2 * r
    packing = ((2 * r * n,) * 3, position, numpy.full(n**3, r))
    assert len(suffuse.constrictions(*packing)) == 6 * n**3  # each half of a window by itself
    for merge in ("center", "overlap"):
        for found in (suffuse.constrictions(*packing, merge=merge), suffuse.PoreNetwork(*packing).constrictions(merge=merge)):
            assert len(found) == 3 * n**3
            assert found.diameter == pytest.approx(2 * r * (numpy.sqrt(2) - 1), rel=1e-9)
    with pytest.raises(suffuse.CaseError, match="overlap.*touching"):
        suffuse.constrictions(*packing, merge="touching")


def test_coarse_constrictions_are_wider(settled):
    settled.grains.fine = settled.grains.diameter < numpy.quantile(settled.grains.diameter, 0.3)
    assert suffuse.constrictions(settled, of="coarse").mean > suffuse.constrictions(settled).mean
    of_network = suffuse.PoreNetwork(settled).solve().network.constrictions(of="coarse")
    assert of_network.mean == suffuse.constrictions(settled, of="coarse").mean
    with pytest.raises(suffuse.CaseError, match="need a World"):
        suffuse.constrictions((1, 1, 1), [[0, 0, 0]], [0.1], of="coarse")


def test_bad_geometry_and_bad_words_are_errors(packing):
    with pytest.raises(suffuse.CaseError, match="direction"):
        suffuse.seep(packing, gradient=1, direction="up")
    with pytest.raises(suffuse.Error):
        suffuse.PoreNetwork((1, 1, 1), [[0.5, 0.5, 0.5]], [2.0])
    with pytest.raises(suffuse.CaseError, match="a packing is a World"):
        suffuse.PoreNetwork((1, 1, 1))


def test_a_world_has_its_own_positions():
    cell, position, radius = small()
    world = suffuse.World([1, 1, 1], position, radius)
    for call in (suffuse.seep, suffuse.PoreNetwork, suffuse.constrictions):
        with pytest.raises(suffuse.CaseError, match="leave them out"):
            call(world, 0.3, "-y")
    assert suffuse.seep(world, gradient=0.3).permeability > 0


def small():
    return numpy.eye(3), [(0.1, 0.2, 0.3), (0.6, 0.7, 0.8)], [0.42, 0.1]


def test_seepage_says_which_flow_it_is_of_and_how_far_off_such_are():
    network = suffuse.seep(*small(), gradient=0.1)
    assert network.solver == "network" and network.known_error["permeability"] == 0.2  # one fine grain
    for solver in ("resolved", "auto"):
        water = suffuse.seep(*small(), gradient=0.1, solver=solver, resolve=8)
        flow = suffuse.resolve_flow(*small(), gradient=0.1, boxes_across=8)
        assert water.solver == "resolved" and water.permeability == flow.permeability
        assert numpy.array_equal(water.grain_force, flow.grain_force)
        assert 0 < water.known_error["permeability"] < 0.2
        again = pickle.loads(pickle.dumps(water))
        assert again.solver == "resolved" and again.permeability == water.permeability
    with pytest.raises(suffuse.CaseError, match="resolve"):
        suffuse.seep(*small(), resolve=8)
    with pytest.raises(suffuse.CaseError, match="network, resolved, auto"):
        suffuse.seep(*small(), solver="grid")


def test_the_law_of_conductances_is_the_fluids_or_an_argument(packing):
    bounded, yade = suffuse.seep(packing), suffuse.seep(packing, conductance="yade")
    assert yade.permeability > 1.1 * bounded.permeability
    assert yade.fluid.conductance == "yade" and suffuse.Fluid().conductance == "bounded"
    assert suffuse.seep(packing, fluid=suffuse.Fluid(conductance="yade")).permeability == yade.permeability
    with pytest.raises(suffuse.CaseError, match="bounded, yade"):
        suffuse.seep(packing, conductance="cubic")


def test_a_permeability_that_a_grain_raises_is_warned_of():
    cell, touching = numpy.eye(3), [(0.1, 0.2, 0.3), (0.6, 0.7, 0.8)]
    with pytest.warns(UserWarning, match="times that of the coarse grains alone"):
        water = suffuse.seep(cell, touching, [0.5, 0.05])
    alone = suffuse.seep(cell, touching[:1], [0.5])
    assert water.raised_by_fines > 1.02
    assert water.permeability == pytest.approx(alone.permeability, rel=1e-12)  # more grains cannot raise it
    assert numpy.allclose(water.grain_force.sum(axis=0), -water.pressure_gradient, rtol=1e-10, atol=1e-10)
    with pytest.warns(UserWarning, match="too high by that at least"):
        yade = suffuse.seep(cell, touching, [0.5, 0.1], conductance="yade")
    assert yade.raised_by_fines > 1.02
    assert alone.raised_by_fines is None


def test_resolved_flow_carries_the_whole_gradient_and_reports_its_grid():
    position = [(0.1, 0.2, 0.3), (0.7, 0.6, 0.9), (0.4, 0.75, 0.35)]
    flow = suffuse.resolve_flow(numpy.eye(3), position, [0.3, 0.3, 0.15], gradient=0.3, direction="-x", boxes_across=8)
    assert numpy.allclose(flow.force_sum, -flow.pressure_gradient, rtol=1e-12)
    assert numpy.allclose(flow.grain_force.sum(axis=0), flow.force_sum, rtol=1e-12)
    assert flow.permeability == pytest.approx(-flow.mean_velocity[0] * 1e-3 / flow.pressure_gradient[0], rel=1e-12)
    assert len(flow.boxes) == 3 and flow.across_smallest == pytest.approx(0.3 / flow.spacing)
    assert flow.tensor is None
    full = suffuse.resolve_flow(numpy.eye(3), position, [0.3, 0.3, 0.15], gradient=0.3, tensor=True, boxes_across=4)
    names = [name for name in dir(flow) if not name.startswith("_")]
    for one in (flow, full):
        for other in (pickle.loads(pickle.dumps(one)), copy.deepcopy(one)):  # as its numbers: to solve it takes long
            for name in names:
                assert numpy.array_equal(getattr(other, name), getattr(one, name)), name
    with pytest.raises(suffuse.CaseError, match="at least 4"):
        suffuse.resolve_flow(numpy.eye(3), position, [0.3, 0.3, 0.15], boxes_across=2)


def test_grains_in_one_place_are_refused_by_their_rows():
    x, r = [[0, 0, 0], [2e-3, 2e-3, 0], [0, 4e-3, 0]], [1e-3] * 3
    for act in (suffuse.seep, suffuse.World, suffuse.PoreNetwork):
        with pytest.raises(suffuse.GeometryError, match="rows 0 and 2 are at the same place"):
            act((4e-3,) * 3, x, r)


def test_overlaps_that_close_voids_are_warned_of_or_refused():
    with pytest.warns(UserWarning, match="negative voids.*row"):
        suffuse.seep((2.2e-3,) * 3, [[0, 0, 0], [1e-4, 0, 0]], [1e-3, 1e-3], gradient=0.1)
    with pytest.raises(suffuse.GeometryError, match="no void is left"):
        suffuse.seep((1.61e-3,) * 3, [[0, 0, 0]], [1e-3], gradient=0.1)


def test_a_direction_may_have_any_length_and_a_gradient_not():
    grain = ((2.2e-3,) * 3, [[0, 0, 0]], [1e-3])
    k = suffuse.seep(*grain, gradient=0.1, direction="z").permeability
    for length in (1e200, 1e-200):
        assert suffuse.seep(*grain, gradient=0.1, direction=[0, 0, length]).permeability == k
    for gradient in (1e200, 1e-320):
        with pytest.raises(suffuse.CaseError, match="gradient"):
            suffuse.seep(*grain, gradient=gradient)
