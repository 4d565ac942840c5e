"""Extreme tasks: a result of plain finite numbers, or an error that names the pair."""

from math import cos, radians

import numpy as np
import pytest
from sparing import sparing

from gears.meshing.pairs import plain_everywhere
from tmmcalc.core.errors import NoSolutionError
from tmmcalc.gears.involute.quality.verdicts import QualityLimits
from tmmcalc.gears.involute.rack import Rack
from tmmcalc.gears.meshing.results import MeshPair
from tmmcalc.gears.meshing.solve import solve_pair
from tmmcalc.gears.meshing.task import PairTask

TEETH = [5, 6, 8, 12, 17, 30, 100, 1000]
ANGLES = [(14.5, 1.0, 0.25), (20, 1.0, 0.25), (20, 0.8, 0.3), (25, 1.0, 0.2), (30, 0.8, 0.1)]


def drawn(kind: str, rng: np.random.Generator) -> PairTask:
    """A task with given shifts or a given distance."""
    z1, other = (int(z) for z in rng.choice(TEETH, 2))
    z2 = {"external": other, "internal": z1 + int(rng.choice([1, 3, 10, 40, 500])), "rack": 0}[kind]
    helix, module = float(rng.choice([0.0, radians(12), radians(45)])), float(rng.choice([5e-5, 0.005, 0.05]))
    angle, addendum, clearance = ANGLES[int(rng.integers(len(ANGLES)))]
    by_distance = bool(rng.integers(3) == 0)
    teeth = {"external": z1 + z2, "internal": z2 - z1, "rack": z1}[kind]
    given = float(rng.uniform(-1, 2)), float(rng.uniform(-1, 2))
    return PairTask(
        (z1, z2),
        module,
        kind=kind,
        helix=helix,
        rack=Rack(radians(angle), addendum, clearance),
        strategy="given_aw" if by_distance else "given",
        shifts=(given[0], None) if by_distance else given,
        distance=module * (teeth / (2 * cos(helix)) + float(rng.uniform(-0.5, 1.2))) if by_distance else None,
        limits=QualityLimits(undercut=bool(rng.integers(2))),
        refuse=bool(rng.integers(4) == 0),
        face_width=None if rng.integers(2) else 8 * module,
        fillet="ellipse" if rng.integers(2) else "circle",
    )


def solved(task: PairTask) -> MeshPair | None:
    """The pair; None if it is refused, with a text that names it and holds numbers only."""
    text = ""
    try:
        return solve_pair(task)
    except NoSolutionError as error:
        text = str(error)
    assert task.title in text
    assert "nan" not in text
    return None


@pytest.mark.slow
@sparing("kind", ["external", "internal", "rack"], every=3)
def test_extremes(kind):
    rng = np.random.default_rng(11)
    outcomes = []
    for _ in range(40):
        task = drawn(kind, rng)
        found = solved(task)
        if found is None:
            outcomes.append("none")
            continue
        plain_everywhere(found)
        assert not (task.refuse and found.verdict == "fail")
        assert found.sizes[0].active_left >= found.sizes[0].form * (1 - 1e-14)
        outcomes.append(found.verdict)
    assert {"none", "fail"} <= set(outcomes)
    assert {"ok", "warn"} & set(outcomes)


@sparing("kind", ["external", "internal", "rack"], every=3)
def test_strategies_of_small_and_large_wheels(kind):
    for z1, z2 in ((5, 1000), (5, 9), (1000, 1060)):
        if kind == "rack":
            z2 = 0
        task = PairTask((z1, z2), 0.005, kind=kind, strategy="balanced", refuse=False, helix=radians(20))
        plain_everywhere(solved(task))
