"""Contacts: a picture that carries the stress, and shows what has reached a limit of the law."""

import gc

import numpy
import pytest

import suffuse


def test_contacts_are_a_picture_that_steps_do_not_change(settled):
    contacts = settled.contacts
    overlap, kept = contacts.overlap, contacts.overlap.copy()
    del contacts
    settled.step(200, suffuse.Loading(strain_rate=(0, 0, "100 1/s")))
    gc.collect()
    assert (overlap == kept).all() and not overlap.flags.writeable


def test_contacts_carry_the_stress(settled):
    c, g = settled.contacts, settled.grains
    branch = g.position[c.j] + c.image @ settled.cell.T - g.position[c.i]
    # Love's formula: the sum of force (x) branch over the volume; forces act on grain i, so compression is positive.
    stress = -numpy.einsum("ca,cb->ab", c.normal_force + c.shear_force, branch) / numpy.linalg.det(settled.cell)
    assert numpy.allclose(stress, settled.stress, rtol=0, atol=1e-9 * settled.mean_stress)  # another order of the sum
    assert settled.mean_stress == pytest.approx(100e3, rel=5e-3)  # what the balance allows
    assert c.compression == pytest.approx(numpy.linalg.norm(c.normal_force, axis=1), rel=1e-12)  # rounding


def test_contacts_mark_which_slide_and_which_roll(settled):
    loading = suffuse.Loading(strain_rate=(None, None, "20 1/s"), stress=("100 kPa", "100 kPa", None))
    settled.material.twisting_friction = settled.material.twisting_stiffness = 0  # the moment is that of rolling
    for mode, rounding in (("reference", 1e-12), ("fast", 1e-6)):
        settled.step(500, loading, time_step=4e-8, mode=mode)
        c, g, law = settled.contacts, settled.grains, settled.material
        slip = numpy.linalg.norm(c.shear_force, axis=1) / (numpy.tan(law.friction) * c.force_n)
        smaller = numpy.minimum(g.radius[c.i], g.radius[c.j])
        roll = numpy.linalg.norm(c.moment, axis=1) / (law.rolling_friction * smaller * c.force_n)
        for ratio, claim in ((slip, c.sliding), (roll, c.rolling)):
            assert claim.dtype == bool and 0.02 < claim.mean() < 0.98
            assert ratio[claim] == pytest.approx(1, abs=rounding) and (ratio[~claim] < 1 - 1e-6).all()
    # stage.json counts a contact from 0.999 of the limit on.
    assert c.sliding.mean() == pytest.approx(settled.measure()["force_distribution"]["sliding_share"], abs=0.01)
    assert (c[c.sliding].force_n == c.force_n[c.sliding]).all() and (c[:9].image == c.image[:9]).all()
    assert f"{c.sliding.sum()} sliding" in repr(c)
