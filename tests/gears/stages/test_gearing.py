"""The ready specs of written trains by hand; the stage in its files; a synthesis as a choice of planetary trains."""

from __future__ import annotations

import math
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest

import tmmcalc
from tmmcalc.core.errors import UsageError
from tmmcalc.gears.facts.gearing import document as gearing_document
from tmmcalc.gears.facts.planetary import planetary_document
from tmmcalc.gears.gearing import Gearing
from tmmcalc.pipeline.runner import run
from tmmcalc.project import templates

RPM = math.pi / 30


def solved(name: str, *overrides: str) -> Gearing:
    spec = tmmcalc.load_spec(templates.folder() / f"{name}.toml", overrides)
    result: Gearing = run(spec, target="gearing").results["gearing"]
    return result


def test_differential() -> None:
    """n_H = 11/37 n_pinion = (n_left + n_right)/2; torques with the losses of every mesh, step by step."""
    found = solved("gears-differential")
    cage = 2000 * 11 / 37
    assert found.motion.speed("H") == pytest.approx(cage * RPM, rel=1e-14)
    assert found.motion.speed("right") == pytest.approx((2 * cage - 560) * RPM, rel=1e-13)
    assert found.flow is not None
    on_cage = 120 * 37 / 11 * 0.96
    # the cage drives both wheels; in its frame the left one drives the planet and the planet the right one
    left = on_cage / (1 + 0.97**2)
    assert found.flow.torque("left") == pytest.approx(-left, rel=1e-13)
    assert found.flow.torque("right") == pytest.approx(-left * 0.97**2, rel=1e-13)
    assert found.flow.efficiency == pytest.approx(
        (left * 560 + left * 0.97**2 * (2 * cage - 560)) / (120 * 2000), rel=1e-13
    )


GEARS = [  # known speeds, member that drives, ratio to the ring by Willis for sun 30, sun 36, ring 74
    ("gearing.speeds={small=10, H=0}", "small", Fraction(74, 30)),
    ("gearing.speeds={small=10, large=0}", "small", Fraction(74 * 66, 30 * 110)),
    ("gearing.speeds={H=10, large=0}", "H", Fraction(74, 110)),
    ("gearing.speeds={large=10, H=0}", "large", Fraction(-74, 36)),
]


@pytest.mark.parametrize(("speeds", "driver", "expected"), GEARS)
def test_ravigneaux(speeds: str, driver: str, expected: Fraction) -> None:
    found = solved("gears-ravigneaux", speeds)
    assert found.input == driver
    assert found.ratio_to("ring") == expected
    assert found.flow is not None
    assert found.flow.power("ring") < 0
    assert abs(found.flow.torque("ring")) == pytest.approx(250)


def test_ravigneaux_locked() -> None:
    found = solved("gears-ravigneaux", 'gearing.locked=[["small","large"]]', "gearing.speeds={small=10}")
    assert found.ratio_to("ring") == 1
    assert found.flow is not None
    assert not found.flow.losses.any()
    assert found.flow.torque("small") == pytest.approx(250)
    # free carrier: the suns share the ring's torque so that 30 : 74 and -36 : 74 of it leave nothing to the carrier
    on_suns = np.linalg.solve([[1, 1], [74 / 30, -74 / 36]], [250, 250])
    assert abs(found.flow.lock_torques[0]) == pytest.approx(abs(on_suns[1]))


def test_circulating() -> None:
    """The shares of tests/gears/test_gearing.py, of 3 kW."""
    found = solved("gears-circulating")
    eta = 0.98
    assert found.flow is not None
    (loop,) = found.flow.loops
    assert loop.power == pytest.approx(3000 * 2 * eta / (3 / eta**3 - 2 * eta), rel=1e-12)
    assert {name for name in loop.path if name in found.motion.members} == {"x", "ring", "sun"}


@pytest.mark.parametrize("name", ["gears-differential", "gears-ravigneaux", "gears-circulating"])
def test_files(name: str, tmp_path: Path) -> None:
    """What comes back from the files is what was computed."""
    spec = tmmcalc.load_spec(templates.folder() / f"{name}.toml")
    first, again = (run(spec, target="gearing", out=tmp_path) for _ in range(2))
    assert [event.kind for event in again.events if event.stage == "gearing"] == ["loaded"]
    one, other = (result.results["gearing"] for result in (first, again))
    assert one.task == other.task
    assert one.ways == other.ways
    assert one.motion.transfer == other.motion.transfer
    np.testing.assert_array_equal(one.flow.mesh_torques, other.flow.mesh_torques)
    lines = (tmp_path / "gearing.csv").read_text().splitlines()
    assert lines[0].startswith("member,omega[rad/s],omega_rel[rad/s],")
    assert len(lines) == 1 + len(one.motion.members)


def test_a_train_that_locks_itself_has_a_file(tmp_path: Path) -> None:
    spec = tmmcalc.parse_spec('[gearing]\nlayout = "AA"\nteeth = [100, 101, 100, 99]\nload = { H = 10 }\n')
    for _ in range(2):
        found: Gearing = run(spec, target="gearing", out=tmp_path).results["gearing"]
        assert found.flow is None
        assert "self-locking" in found.locking


def test_a_bare_spec_leaves_the_stage_out() -> None:
    with pytest.raises(UsageError, match=r"no \[gearing\]"):
        run(tmmcalc.parse_spec('[train]\nlayout = "AIbar"\nratio = 7\n'), target="gearing")


TRAIN = '[train]\nlayout = "AIbar"\nratio = "7.29"\ntolerance = "0.1"\ntolerance_kind = "absolute"\nz_max = 120\n'


def test_choice_of_a_synthesis() -> None:
    """Table 4.7 with K = 3, 4; the types of 4.4.1; the chosen set by (4.19)."""
    trains = run(tmmcalc.parse_spec(TRAIN), target="train").results["train"]
    printed = planetary_document(trains, "title", 50.0, choose=2, everything=True)
    types, limits, chosen = printed.parts
    assert types.table is not None
    rows = dict(
        zip(zip(*types.table.columns[:2], strict=True), zip(*types.table.columns[2:], strict=True), strict=True)
    )
    assert rows["AIbar", "1"][:2] == pytest.approx((7.29, 6.29))
    assert rows["AIbar", "1"][3] is rows["AI", "1"][3] is True
    assert rows["AA", "H"][3] is False
    assert limits.table is not None
    assert limits.table.columns[2][1:3] == pytest.approx([13.92, 5.82], abs=0.01)
    assert limits.table.columns[3][:3] == [True, True, False]
    z1, z2, z3 = (int(z) for z in trains.variants[0].sets.teeth[1])
    values = {key: value for fact in chosen.facts for key, value in fact.values.items()}
    assert values["i_1_H_exact"] == str(Fraction(z1 + z3, z1))
    assert values["known_speeds[rad/s]"] == {"1": 50.0, "3": 0.0}
    assert f"{z1}/{z2}/{z3}" in chosen.title


def test_power_that_is_rounding_alone_is_nothing() -> None:
    """A train that locks itself gives nothing out: the rest of in less lost is not printed."""
    text = '[gearing]\nlayout = "AA"\nteeth = [99, 100, 101, 100]\nefficiency = 0.9\nspeeds = { 1 = 100 }\n'
    for torque in (7, 10, 13, 19, 23):
        spec = tmmcalc.parse_spec(f"{text}torques = {{ 1 = {torque} }}\n")
        result = run(spec, target="gearing").results["gearing"]
        facts = {fact.label: fact.text for fact in gearing_document(result, "title").facts}
        assert ", 0 W out, " in facts["power"]


def test_choice_beyond_the_sets() -> None:
    trains = run(tmmcalc.parse_spec(TRAIN), target="train").results["train"]
    with pytest.raises(UsageError, match="there is no tooth set 1000"):
        planetary_document(trains, "title", choose=1000)


def test_a_carrier_that_drives() -> None:
    text = (templates.folder() / "gears-kinematic.toml").read_text()
    trains = run(tmmcalc.parse_spec(text), target="train").results["train"]
    chosen = planetary_document(trains, "title", power=False).parts[-1]
    values = {key: value for fact in chosen.facts for key, value in fact.values.items()}
    assert values["i_H_1_exact"] == "10000"
    assert values["self_locking_1_H"] is True
