"""Wrong names of arguments are answered with the nearest that there is."""

import pytest

import suffuse


def test_a_wrong_argument_is_answered_with_the_nearest(settled, small_case):
    calls = (
        (lambda: settled.step(1, lodaing=None), "World.step: unknown argument lodaing; a similar one exists: loading"),
        (lambda: suffuse.Material(frction="30 deg"), "there is no field frction; a similar one exists: friction"),
        (lambda: suffuse.Loading(stres="1 kPa"), "a similar one exists: stress"),
        (lambda: settled.erode(0.5, rul=None), "World.erode: unknown argument rul; a similar one exists: rule"),
        (lambda: suffuse.World.load(paht="x"), "World.load: unknown argument paht; a similar one exists: path"),
        (lambda: suffuse.seep(settled, gradeint=1), "seep: unknown argument gradeint; a similar one exists: gradient"),
        (lambda: suffuse.assess("x.csv", finer_then=1), "a similar one exists: finer_than"),
        (lambda: suffuse.Case(small_case, presett=1), "Case: unknown argument presett; a similar one exists: preset"),
        (lambda: suffuse.Case(small_case).run(thread=1), "Case.run: unknown argument thread; a similar one exists: threads"),
        (lambda: suffuse.read_packing("x.csv", cel=1), "read_packing: unknown argument cel; a similar one exists: cell"),
    )
    for call, words in calls:
        with pytest.raises(TypeError) as raised:
            call()
        assert words in str(raised.value)
    with pytest.raises(TypeError, match="unknown argument sieve; there are steps, loading, time_step"):
        settled.step(1, sieve=3)


def test_other_wrong_arguments_are_answered_as_before(settled):
    with pytest.raises(TypeError, match="incompatible function arguments"):
        settled.step("many")
    with pytest.raises(TypeError, match="passed on"):
        settled.step(10**9, on_progress=lambda part, steps: (_ for _ in ()).throw(TypeError("passed on")))
    with pytest.raises(suffuse.CaseError, match="damping"):
        settled.step(1, damping=2)
