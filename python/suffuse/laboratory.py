"""Tests of laboratories, read from their tables."""

import warnings

from suffuse import _core
from suffuse.records import records_of
from suffuse.spelling import spelled


@spelled
def read_test(path, kind, contraction=None):
    """Records of a table of laboratory tests, a row a reading: `test` is the name of its test, the other columns are named by
    what they measure ("axial_strain", "deviator_stress"). Values are in SI, compression and contraction positive;
    docs/laboratory-tests.md lists what is understood.

    kind: "triaxial", "oedometer" or "permeameter"
    contraction: "positive" or "negative", the sign of volumetric strains in the file; found out unless given
    What had to be assumed is warned of. A table that can be read in two ways is an error, a CaseError.
    """
    columns, units, assumed = _core.read_test(path, kind, contraction)
    for text in assumed:
        warnings.warn(f"{path}: assumed: {text}", stacklevel=3)  # beyond what looks at the spelling
    return records_of(columns, units)
