"""A stage computed, and loaded from what was stored of it."""

from __future__ import annotations

from pathlib import Path

import numpy as np

import tmmcalc
from tmmcalc.core.conversion import to_record
from tmmcalc.rooms import STAGES


def assert_stored_as_found(scene: tmmcalc.Spec, name: str, folder: Path) -> None:
    """What is loaded from the folder, and what its record gives back, is what was found, to the last bit."""
    found, loaded = (tmmcalc.run(scene, out=folder).results[name] for _ in range(2))
    stage = STAGES[name]
    for other in (loaded, stage.load(stage.dump(found))):
        a, b = to_record(found), to_record(other)
        assert a.scalars == b.scalars
        assert a.arrays.keys() == b.arrays.keys()
        assert all(np.array_equal(a.arrays[key], b.arrays[key]) for key in a.arrays)
    table, again = stage.table(found), stage.table(loaded)
    assert (table and table.header) == (again and again.header)
    assert (folder / f"{name}.csv").exists() == (table is not None and table.rows <= 2000)
