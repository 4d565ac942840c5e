"""Scenes in other units and in a mirror: the same mechanics."""

from __future__ import annotations

import pytest
from sparing import sparing

from tmmcalc.core.errors import UsageError
from tmmcalc.stress.compare import Alignment, difference
from tmmcalc.stress.mirror import mirrored
from tmmcalc.stress.similarity import in_units
from tmmcalc.stress.units import Factors, powers

from .scenes import scene, variants

UNITS = Factors(0.3, 7.0, 1.7)
# name: a tolerance of the worst stage: a few hundred roundings
SCENES = {
    "press": 1e-12,
    "four-bar": 1e-13,
    "slotted-link": 1e-13,
    "hydraulic-lift": 1e-12,
    "crane-luffing": 1e-12,
    "four-stroke-engine": 1e-12,
    "rotor": 1e-13,
    "cam-groove": 1e-12,
    "cam-flat": 1e-12,
    "cam-oscillating": 1e-12,
    "gears-circulating": 1e-13,
    "extra-bearing": 1e-13,
    "extra-tie-down": 1e-13,
    "extra-liner": 1e-13,
    "extreme/travel-tiny": 5e-8,  # a nanometre of 0.2 m: eps 0.2/1e-9 is what a rounding of its ends is to it
    "manipulator-angular": 1e-13,
    "pair-helical": 1e-13,
    "synth-crank-rocker": 1e-13,
    "dyad": 1e-13,
}


@sparing("name", SCENES, every=5)
def test_results_scale_with_the_units(name: str) -> None:
    one = scene(name)
    two = one.run(in_units(one.document, UNITS))
    assert set(two.outcomes) == set(one.base.outcomes)
    compared = 0
    for stage in two.outcomes:
        found = difference(stage, one.base, two, Alignment(UNITS))
        assert not found.skipped, (stage, found.skipped)
        if found.size is not None:
            assert found.size < SCENES[name], (stage, found)
            compared += 1
    assert compared


def test_a_scene_that_is_not_the_same_differs() -> None:
    one = scene("press")
    document = in_units(one.document, UNITS)
    document["loads"][0]["factor"] = 1.001
    two = one.run(document)
    found = difference("forces", one.base, two, Alignment(UNITS))
    assert found.size is not None
    assert 1e-4 < found.size < 1e-2


def test_defaults_with_a_dimension_are_written_out() -> None:
    document = dict(variants("hydraulic-lift").data)
    document["mechanism"] = {key: value for key, value in document["mechanism"].items() if key != "gravity"}
    assert in_units(document, Factors(2.0, 3.0, 1.0))["mechanism"]["gravity"] == "19.62 m/s^2"


def test_bare_numbers_are_of_what_they_act_on() -> None:
    document = variants("hydraulic-lift").data | {
        "springs": [
            {"links": [0, 1], "kind": "torsion", "stiffness": 5},
            {"links": [0, 1], "points": ["A", "A"], "stiffness": 5},
        ]
    }
    torsion, linear = in_units(document, Factors(2.0, 3.0, 1.0))["springs"]
    assert torsion["stiffness"] == "60.0 N*m/rad"
    assert linear["stiffness"] == "15.0 N/m"


@pytest.mark.parametrize(("name", "word"), [("gears-coaxial", "standard"), ("extra-reliability", "no lengths")])
def test_what_has_no_other_units(name: str, word: str) -> None:
    with pytest.raises(UsageError, match=word):
        in_units(variants(name).data, UNITS)


@pytest.mark.parametrize(("unit", "expected"), [("kN*m/rad", (2, 1, -2)), ("1/m", (-1, 0, 0)), ("mm/s", (1, 0, -1))])
def test_powers_of_units(unit: str, expected: tuple[float, ...]) -> None:
    assert powers(unit) == expected


@sparing("name", ["press", "shaper", "four-bar", "scotch-yoke", "hydraulic-lift", "trammel"], every=3)
def test_mirrored_scenes_move_alike(name: str) -> None:
    one = scene(name)
    two = one.run(mirrored(one.document))
    assert set(two.outcomes) == set(one.base.outcomes)
    for stage in two.outcomes:
        found = difference(stage, one.base, two, Alignment(mirrored=True))
        assert (found.size or 0.0) < 1e-12, (stage, found)
        assert not found.skipped, (stage, found.skipped)
    y = (one.base.results["kinematics"].trace.r.imag, two.results["kinematics"].trace.r.imag)
    assert abs(y[0] + y[1]).max() < 1e-12


def test_what_is_not_mirrored() -> None:
    with pytest.raises(UsageError, match=r"\[rotor\] is not mirrored"):
        mirrored(variants("rotor").data)
