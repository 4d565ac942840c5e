"""Where no pair exists: the nearest centre distance and the nearest shifts, which then work."""

import re

import pytest
from sparing import sparing

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.gears.involute.quality.verdicts import QualityLimits
from tmmcalc.gears.meshing.solve import solve_pair
from tmmcalc.gears.meshing.task import PairTask

M = 0.002
TASKS = [
    PairTask((20, 60), M, kind="internal", strategy="given_aw", distance=0.035),
    PairTask((20, 40), M, strategy="given_aw", distance=0.05),
    PairTask((12, 14), M, strategy="given_aw", distance=0.02, limits=QualityLimits(undercut=False)),
    PairTask((17, 23), M, strategy="given_aw", distance=0.03, helix=0.3),
]


def told(task: PairTask) -> NoSolutionError:
    with pytest.raises(NoSolutionError) as error:
        solve_pair(task)
    return error.value


@sparing("task", TASKS, every=4)
def test_the_distance_that_is_named_works_and_a_smaller_one_does_not(task):
    remedy = told(task).remedy
    found = re.search(r"centre distance is ([\d.]+) mm, with x1 = (-?[\d.]+), x2 = (-?[\d.]+)", remedy)
    distance, x1, x2 = (float(part) for part in found.groups())
    named = PairTask(
        task.teeth,
        M,
        kind=task.kind,
        strategy="given_aw",
        distance=distance / 1e3,
        shifts=(x1, None),
        limits=task.limits,
        helix=task.helix,
    )
    pair = solve_pair(named)
    assert pair.shifts[1] == pytest.approx(x2, abs=6e-5)
    assert not pair.broken
    for least in (0.02, 0.2):
        nearer = PairTask(
            task.teeth, M, kind=task.kind, strategy="given_aw", distance=distance / 1e3 - least * M, limits=task.limits,
            helix=task.helix,
        )  # fmt: skip
        told(nearer)


def test_shifts_of_a_ring_that_add_up_to_too_much():
    task = PairTask((20, 60), M, kind="internal", strategy="given", shifts=(0.5, 0.5))
    error = told(task)
    assert "it has to stay below 0.818989 (margin -0.181)" in error.message
    offers = re.findall(r"x1 = (-?[\d.]+), x2 = (-?[\d.]+)", error.remedy)
    assert len(offers) == 3
    for x1, x2 in offers:
        assert not solve_pair(
            PairTask((20, 60), M, kind="internal", strategy="given", shifts=(float(x1), float(x2)))
        ).broken


def test_rounding_never_makes_the_nearest_shifts_worse_than_those_of_a_line():
    task = PairTask((10, 20), 0.005, strategy="given", shifts=(-0.3, 0.0), limits=QualityLimits(undercut=False))
    remedy = told(task).remedy
    offers = [tuple(map(float, pair)) for pair in re.findall(r"x1 = (-?[\d.]+), x2 = (-?[\d.]+)", remedy)]
    away = [(x1 + 0.3) ** 2 + x2**2 for x1, x2 in offers]
    assert away[0] == min(away)
    assert "-0.0001" not in remedy


def test_the_word_pair_is_said_once():
    error = told(PairTask((20, 40), M, name="pair 1", strategy="given_aw", distance=0.05))
    assert error.where.startswith("pair 1: z = 20/40")
