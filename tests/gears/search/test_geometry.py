"""Each planetary set is built: planets are turned tooth by tooth until they mesh with all their central wheels.

A wheel of Z teeth that is turned by beta has, facing the direction theta, the tooth phase Z (beta - theta)/(2 pi).
External wheels mesh if their phases add up to a half (the planet faces theta + pi), a ring and its pinion if their
phases differ by a half.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from itertools import product

import numpy as np
import pytest
from sparing import sparing

from tmmcalc.gears.exact import around
from tmmcalc.gears.layouts import LAYOUTS
from tmmcalc.gears.model import Demands, Limits, ToothSets, TrainTask
from tmmcalc.gears.scheme import Mesh
from tmmcalc.gears.search.measures import assembly_number
from tmmcalc.gears.search.search import synthesise

HALF = Fraction(1, 2)
Turn = Fraction  # angles are exact parts of a turn


def misfit(mesh: Mesh, planet: str, z: dict[str, int], theta: Turn, central: Turn, own: Turn) -> Turn:
    """Tooth phase, modulo 1, by which a planet at ``theta`` misses a central wheel, both turned as given."""
    wheel = mesh.second if mesh.first == planet else mesh.first
    at_wheel = z[wheel] * (central - theta)
    if mesh.internal:
        return (at_wheel - z[planet] * (own - theta) - HALF) % 1
    return (at_wheel + z[planet] * (own - theta - HALF) - HALF) % 1


def turns_that_fit(mesh: Mesh, planet: str, z: dict[str, int], theta: Turn, central: Turn) -> list[Turn]:
    """The turns of a planet, one for each of its teeth, with which it meshes with one central wheel."""
    start = misfit(mesh, planet, z, theta, central, Fraction(0))
    sign = 1 if mesh.internal else -1
    return [(sign * start + tooth) / z[planet] for tooth in range(z[planet])]


def assembles(layout: str, z: dict[str, int], planets: int) -> bool:
    """Whether identical planet blocks at equal angles mesh with central wheels that the first block has fixed."""
    scheme = LAYOUTS[layout]
    meshes = [(m, m.first if m.first in scheme.planets else m.second) for m in scheme.meshes]
    # The first block stands at 0 unturned; it fixes how the central wheels are turned.
    centrals = []
    for mesh, planet in meshes:
        wheel = mesh.second if mesh.first == planet else mesh.first
        centrals.append(-misfit(mesh, planet, z, Fraction(0), Fraction(0), Fraction(0)) / z[wheel])
    for k in range(planets):
        theta = Fraction(k, planets)
        first, *others = zip(meshes, centrals, strict=True)
        (mesh, planet), central = first
        # Blocks: one turn for both wheels. A block may be turned past its teeth by whole turns of its own only.
        fits = any(
            all(misfit(m, p, z, theta, c, own) == 0 for (m, p), c in others)
            for own in turns_that_fit(mesh, planet, z, theta, central)
        )
        if not fits:
            return False
    return True


@sparing(
    ("layout", "nominal", "proportions"),
    [
        ("coaxial", "8", ((2, 3),)),
        ("AA", "8", ((2, 3),)),
        ("AI", "20", ((4, 5),)),
        ("II", "0.98", ((1, 1),)),
        ("AIbar", "4.7", ((1,),)),
        ("AII", "100", ((1, 1),)),
    ],
    every=3,
)
@sparing("planets", [2, 3, 4], every=3, first=1)
def test_planets_fit_where_the_condition_says(
    layout: str, nominal: str, proportions: tuple[tuple[int, ...], ...], planets: int
) -> None:
    ratio = Fraction(nominal)
    free = TrainTask(
        layout,
        ratio,
        around(ratio, Fraction("0.01"), relative=True),
        proportions,
        planets,
        Limits(largest=110, largest_ring=250),
        Demands(assembly=False, gap=None),
    )
    every = synthesise(free).sets.teeth
    bound = replace(free, demands=Demands(gap=None))
    told = {tuple(teeth) for teeth in synthesise(bound).sets.teeth.tolist()}
    sample = every[np.random.default_rng(3).permutation(len(every))[:60]].tolist()
    answers = {
        tuple(teeth): assembles(layout, dict(zip(LAYOUTS[layout].wheels, teeth, strict=True)), planets)
        for teeth in sample
    }
    assert all(answer == (teeth in told) for teeth, answer in answers.items())
    assert any(answers.values())
    assert not all(answers.values()) or (layout, planets) == ("AIbar", 2)  # Z3 - Z1 is even, so is Z1 + Z3


@sparing("planets", [3, 5], every=2)
def test_pairs_of_planets_fit(planets: int) -> None:
    # Phases against the ray: sun 1 and planet 2, planets 2 and 3, planet 3 and sun 4 add up to what they do at k = 0.
    z2, z3 = 19, 23

    def fits(one: int, four: int, theta: Fraction) -> bool:
        return any(
            (-four * theta + z3 * (third - theta)) % 1 == 0
            for own in ((one * theta + tooth) / z2 + theta for tooth in range(z2))
            for third in ((-z2 * (own - theta) + tooth) / z3 + theta for tooth in range(z3))
        )

    for one, four in product(range(18, 24), range(50, 57)):
        built = all(fits(one, four, Fraction(k, planets)) for k in range(planets))
        sets = ToothSets("2A-AA", np.array([[one, z2, z3, four]]), np.array([[1]]), np.zeros((1, 3)), planets)
        assert built == (assembly_number(sets)[0] % 1 == 0)


@pytest.mark.parametrize(("planets", "nominal"), [(3, "12.5"), (4, "5.6"), (6, "2.9"), (12, "1.52")])
def test_neighbours_keep_their_gap(planets: int, nominal: str) -> None:
    ratio = Fraction(nominal)
    interval = around(ratio, Fraction("0.05"), relative=True)
    free = TrainTask("AIbar", ratio, interval, ((1,),), planets, demands=Demands(gap=None))
    bound = replace(free, demands=Demands(gap=Fraction(1)))
    kept = synthesise(bound).sets.teeth.tolist()
    answers = set()
    for one, two, three in synthesise(free).sets.teeth.tolist():
        # Doubled, in modules: the distance of neighbouring axes is 2 sin(pi/K) times the carrier's radius.
        room = (one + two) * abs(np.exp(2j * np.pi / planets) - 1) / 2 - (two + 2)
        apart = round(room, 9) > 1
        assert apart == ([one, two, three] in kept)
        answers.add(apart)
    assert answers == {True, False}
