"""Relative velocities, normal, tangential and Coriolis accelerations; segments of the plans; columns by choice."""

from __future__ import annotations

import json
from dataclasses import replace

import numpy as np
import pytest
from random_mechanisms import KINDS

from linkage.scenes import CONFIGS, crank_slider, driven_rod, full_turn, shaper, slotted, with_input
from linkage.test_properties import regular_scenes
from tmmcalc import Kinematics, UsageError, solve_kinematics
from tmmcalc.core.columns import Column, select
from tmmcalc.linkage.chain import chain_of
from tmmcalc.linkage.columns import columns
from tmmcalc.linkage.differentiation import differentiate
from tmmcalc.linkage.facts.polygons import polygons_document
from tmmcalc.linkage.further import further_columns
from tmmcalc.linkage.model import FRAME, Mechanism
from tmmcalc.linkage.relative import relative_columns
from tmmcalc.linkage.results import Trace

CASES = json.loads((CONFIGS.parent / "tests" / "cases" / "kinematics.json").read_text(encoding="utf-8"))
DIFFERENCES = next(case for case in CASES if case["id"] == "KIN-S02")["expected"]
PLAN = next(case for case in CASES if case["id"] == "KIN-S04")["expected"]
POSITION = 21


def by_name(mechanism: Mechanism, result: Kinematics, dimensionless: bool = False) -> dict[str, np.ndarray]:
    found = relative_columns(mechanism, result, dimensionless=dimensionless)
    assert len({column.name for column in found}) == len(found)
    return {column.name: column.make() for column in found}


def test_the_terms_of_the_shaper_are_the_sides_of_its_plans() -> None:
    """KIN-S04: differences of the vertices of both plans, in units of the crank."""
    mechanism = shaper()
    found = by_name(mechanism, solve_kinematics(mechanism), dimensionless=True)
    v, a = (
        {name: complex(*at) for name, at in PLAN[f"{kind}_polygon"].items()} for kind in ("velocity", "acceleration")
    )
    sides = {
        "vrel{}_D_C": v["d"] - v["c"],
        "vrel{}_A3_B": v["a3"],
        "an{}_A3_B": a["n3"],
        "at{}_A3_B": a["a3"] - a["n3"],
        "an{}_D_C": a["n4"] - a["c"],
        "at{}_D_C": a["d"] - a["n4"],
        "aK{}_A3": a["a2"] - a["k"],
    }
    for name, side in sides.items():
        x, y, size = (found[name.format(axis)][POSITION] for axis in ("x", "y", ""))
        assert complex(x, y) == pytest.approx(side, abs=4e-6), name
        assert abs(size) == pytest.approx(abs(side), abs=4e-6), name


def test_outputs_by_differences_beside_the_exact_ones() -> None:
    """KIN-S02: the last two columns of table D.2.1, even positions."""
    mechanism = shaper()
    found = {c.name: c for c in further_columns(mechanism, solve_kinematics(mechanism), dimensionless=True)}
    for name, key in (("vS_D_differences", "vD_num"), ("aS_D_differences", "aD_num")):
        np.testing.assert_allclose(found[name].make()[::2], DIFFERENCES[key], atol=2e-6)
    rocker = slotted(0.1, 0.25)
    headers = {column.header for column in further_columns(rocker, solve_kinematics(rocker))}
    assert headers >= {"vS_3_differences[rad/s]", "aS_3_differences[rad/s^2]"}


class Differences:
    """Motion in time by central differences of positions alone."""

    def __init__(self, mechanism: Mechanism, result: Kinematics) -> None:
        trace: Trace = differentiate(chain_of(mechanism, result), result.x, 1e-4)
        self.points = {
            name: (r, *result.in_time(dr, ddr))
            for name, r, dr, ddr in zip(trace.point_names, trace.r, trace.dr, trace.ddr, strict=True)
        }
        still = np.zeros(result.x.shape, complex)
        for name, at in mechanism.frame.points.items():
            self.points.setdefault(name, (still + at, still, still))
        self.links = {
            k: (angle, *result.in_time(d, dd))
            for k, angle, d, dd in zip(trace.link_ids, trace.angle, trace.dangle, trace.ddangle, strict=True)
        }
        self.slides = {
            name: result.in_time(ds, dds) for name, ds, dds in zip(trace.joint_names, trace.ds, trace.dds, strict=True)
        }


@pytest.mark.parametrize("kind", KINDS)
def test_random_mechanisms_by_differences_of_positions(kind: str) -> None:
    """v_B - v_A and a_B - a_A of two points of a link; what the slider's acceleration has beside that of its guide."""
    compared = 0
    for _, found, _ in regular_scenes((kind, "RRR"), range(6)):
        mechanism = replace(found, input=replace(found.input, acceleration=0.7))
        result = solve_kinematics(mechanism)
        compared += pairs_of_points(mechanism, result) + sliders(mechanism, result)
    assert compared >= 3


def pairs_of_points(mechanism: Mechanism, result: Kinematics) -> int:
    terms, moved = by_name(mechanism, result), Differences(mechanism, result)
    compared = 0
    for name in terms:
        kind, _, rest = name.partition("_")
        head, _, base = rest.partition("_")
        if kind != "vrelx" or not {head, base} <= moved.points.keys():
            continue
        (_, v, a), (_, v0, a0) = moved.points[head], moved.points[base]
        velocity = terms[name] + 1j * terms[f"vrely_{rest}"]
        acceleration = sum(terms[f"{part}x_{rest}"] + 1j * terms[f"{part}y_{rest}"] for part in ("an", "at"))
        np.testing.assert_allclose(velocity, v - v0, atol=1e-5 * np.max(np.abs(velocity)) + 1e-9)
        np.testing.assert_allclose(acceleration, a - a0, atol=1e-5 * np.max(np.abs(acceleration)) + 1e-6)
        compared += 1
    return compared


def sliders(mechanism: Mechanism, result: Kinematics) -> int:
    """a^K = a of the slider's point, less a of the guide's point there, less the relative acceleration."""
    terms, moved = by_name(mechanism, result), Differences(mechanism, result)
    compared = 0
    for joint in mechanism.joints:
        if f"aK_{joint.name}" not in terms:
            continue
        slider, guide = joint.links
        at = f"P{guide}"
        if FRAME in joint.links or at not in moved.points or f"P{slider}" not in moved.points:
            continue
        r, _, a = moved.points[f"P{slider}"]
        r0, _, a0 = moved.points[at]
        angle, omega, eps = moved.links[guide]
        there = a0 + (1j * eps - omega**2) * (r - r0)
        along = np.exp(1j * angle) * joint.directions[1]
        expected = a - there - moved.slides[joint.name][1] * along
        coriolis = terms[f"aKx_{joint.name}"] + 1j * terms[f"aKy_{joint.name}"]
        np.testing.assert_allclose(coriolis, expected, atol=1e-5 * np.max(np.abs(a)) + 1e-6)
        np.testing.assert_allclose(terms[f"aK_{joint.name}"] * 1j * along, coriolis, atol=1e-9 * np.max(np.abs(a)))
        compared += 1
    return compared


def test_dimensionless_terms_do_not_depend_on_the_speed() -> None:
    slow, fast = (with_input(full_turn(crank_slider(0.1, 0.3)), speed=speed) for speed in (2.0, 30.0))
    one, other = (by_name(each, solve_kinematics(each), dimensionless=True) for each in (slow, fast))
    for name in one:
        np.testing.assert_allclose(one[name], other[name], atol=1e-12)


def test_further_columns_are_chosen_where_no_other_is_meant() -> None:
    made: list[str] = []

    def column(name: str) -> Column:
        def make() -> np.ndarray:
            made.append(name)
            return np.zeros(1)

        return Column(name, "m", make)

    own, beside = [column("v_A"), column("x_A")], [column("v_AB"), column("w_AB")]
    assert [c.name for c in select(own, ["v_*"], further=beside)] == ["v_A"]
    assert [c.name for c in select(own, ["w_*", "x_A"], further=beside)] == ["w_AB", "x_A"]
    assert [c.name for c in select(own, ["v_AB[m]"], further=beside)] == ["v_AB"]
    assert not made
    with pytest.raises(UsageError, match="w_AC") as error:
        select(own, ["w_AC"], further=beside)
    assert "w_AB" in str(error.value.remedy)


def test_nothing_is_evaluated_before_a_column_is_made(monkeypatch: pytest.MonkeyPatch) -> None:
    mechanism = shaper()
    result = solve_kinematics(mechanism)
    usual = [column.name for column in columns(result)]
    monkeypatch.setattr("tmmcalc.linkage.relative.chain_of", lambda *_: pytest.fail("evaluated"))
    assert not {column.name for column in relative_columns(mechanism, result)} & {*usual}


@pytest.mark.parametrize(("crank", "pin"), [(None, None), (40.0, 40.0)])
def test_segments_of_the_plans(crank: float | None, pin: float | None) -> None:
    """Every segment is its vector over the scale; at the scale of the crank its pin has segments of the told length."""
    mechanism = shaper()
    result = solve_kinematics(mechanism)
    document = polygons_document(mechanism, result, "", [POSITION, 3], crank)
    assert document.table is not None
    table = dict(zip(document.table.headers, document.table.columns, strict=True))
    mu = {key[3]: value for key, value in document.facts[0].values.items()}
    rows = [dict(zip(table, row, strict=True)) for row in zip(*table.values(), strict=True)]
    for row in rows:
        assert row["segment[mm]"] * mu[row["plan"]] == pytest.approx(row["size"])
        assert np.hypot(row["x"], row["y"]) == pytest.approx(row["size"])
        if row["size"]:
            assert np.degrees(np.angle(complex(row["x"], row["y"]))) == pytest.approx(row["direction[deg]"])
    if pin is not None:
        assert result.crank_length is not None
        ends = {(row["plan"], row["from"], row["to"]): row for row in rows if row["i"] == str(POSITION)}
        assert ends["v", "p", "a2"]["segment[mm]"] == pytest.approx(pin)
        assert ends["a", "pi", "a2"]["segment[mm]"] == pytest.approx(pin)
        expected = pin * abs(complex(*PLAN["velocity_polygon"]["c"]))
        assert ends["v", "p", "c"]["segment[mm]"] == pytest.approx(expected, abs=1e-4)
    else:
        assert 50 <= max(row["segment[mm]"] for row in rows) <= 100


def test_a_driven_slider_has_no_scale_of_the_crank() -> None:
    mechanism = driven_rod(1.0, 0.2, 0.5)
    result = solve_kinematics(mechanism)
    with pytest.raises(UsageError, match="slider"):
        polygons_document(mechanism, result, "", [0], 40.0)
    assert polygons_document(mechanism, result, "", [0]).table is not None
