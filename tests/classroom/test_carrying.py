"""What is carried on from wrong answers before, and how often numbers that come of nothing are taken for that."""

from __future__ import annotations

import math

import pytest
from numpy.random import Generator, default_rng

from classroom.books import item
from tmmcalc.classroom.answers.handed import Answer
from tmmcalc.classroom.carrying import carried_values
from tmmcalc.classroom.verdicts import Standing, standing_of

RIGHT = (4.0, 5.0, 2.5, 7.0)
POWERS = (2.0, -1.0, 1.0)


def written(value: float, digits: int = 4) -> Answer:
    text = f"{value:.{digits - 1}e}"
    return Answer(text, float(text), 10.0 ** (math.floor(math.log10(abs(float(text)))) - digits + 1), digits)


def carried(values: tuple[float, ...], powers: tuple[float, ...] = ()) -> bool:
    """Whether the last of some values is taken for what follows from those before it; all are wrong."""
    count = len(values) - 1
    items = (*(item(f"a{k}") for k in range(count)), item("y", after=tuple(range(count)), powers=powers))
    right = RIGHT[: count + 1]
    answers = [written(value) for value in values]
    standings = [standing_of(*each) for each in zip(answers, items, right, strict=True)]
    assert {*standings} == {Standing.wrong}
    return math.isfinite(carried_values(items, right, answers, standings)[-1])


def test_by_the_powers_that_are_told_or_by_1() -> None:
    assert carried((4.8, 5.0 * 1.2))
    assert not carried((4.8, 5.0 * 1.2**2))
    assert not carried((4.8, 5.0 / 1.2))
    assert carried((4.8, 5.0 * 1.2**2), (2.0,))
    assert not carried((4.8, 5.0 * 1.2), (2.0,))
    assert carried((-4.8, 5.0 * 1.2**2), (2.0,))
    assert carried((-4.8, -5.0 * 1.2))


def test_of_several_all_or_each_alone() -> None:
    wrong = (4.0 * 1.2, 5.0 * 0.8, 2.5 * 1.5)
    ratios = (1.2**2, 1 / 0.8, 1.5)
    for ratio in (math.prod(ratios), *ratios):
        assert carried((*wrong, 7.0 * ratio), POWERS)
    for ratio in (ratios[0] * ratios[1], ratios[0] * ratios[2], ratios[1] * ratios[2]):
        assert not carried((*wrong, 7.0 * ratio), POWERS)
    assert carried((*wrong, 7.0 * math.prod(ratios) * 1.009), POWERS)  # all: within the tolerance
    assert not carried((*wrong, 7.0 * ratios[2] * 1.009), POWERS)  # alone: within less


def random_wrong(rng: Generator, right: float) -> float:
    """A value near the right one that is wrong."""
    while abs((value := right * rng.uniform(0.5, 1.5)) / right - 1) < 0.04:
        pass
    return value


@pytest.mark.parametrize("powers", [(), POWERS])
@pytest.mark.parametrize("before", [1, 2, 3])
def test_numbers_that_come_of_nothing_are_seldom_carried_on(before: int, powers: tuple[float, ...]) -> None:
    """Of those within a half of the right value; farther ones are met less often."""
    rng = default_rng(before)
    tables = 4000
    met = sum(
        carried(tuple(random_wrong(rng, right) for right in RIGHT[: before + 1]), powers[:before])
        for _ in range(tables)
    )
    assert met / tables <= 0.03
