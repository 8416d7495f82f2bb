"""A bound on the memory of a run: what does not fit is refused before anything is made."""

import pytest

import suffuse


def test_a_case_that_needs_more_memory_than_it_may_have_is_refused_before_a_folder_is_made(small_case, tmp_path):
    for memory in ("41MB", 41e6):
        with pytest.raises(suffuse.IoError, match="the run may use 41 MB"):
            suffuse.Case(small_case).run(tmp_path / "run", memory=memory)
        assert not (tmp_path / "run").exists()


def test_a_case_that_fits_ends_with_the_same_bits_and_may_be_resumed_within_less(small_case, tmp_path):
    case = suffuse.Case(small_case)
    run = case.run(tmp_path / "run", until="settled", memory="2GB")
    with pytest.raises(suffuse.IoError, match="the run may use 41 MB"):
        run.resume(memory="41MB")
    run.resume(memory="2GB")
    assert run["replay/seep"]["state_hash"] == case.run(tmp_path / "other")["replay/seep"]["state_hash"]
    assert run.resume(memory="41MB").outcome == "done", "nothing was left to do"


@pytest.mark.parametrize("memory", ["much", "16", "-1GB", -1, 0, float("nan")])
def test_an_amount_of_memory_is_bytes_or_has_its_unit(small_case, tmp_path, memory):
    with pytest.raises((suffuse.CaseError, suffuse.UnitError)):
        suffuse.Case(small_case).run(tmp_path / "run", memory=memory)
    assert not (tmp_path / "run").exists()
