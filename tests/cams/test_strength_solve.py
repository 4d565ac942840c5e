"""The stage of the requirements: worked cases through it, every margin against a dense scan, what is not judged."""

import json
from dataclasses import replace
from math import pi, radians
from pathlib import Path

import numpy as np
import pytest

import tmmcalc
from tmmcalc.cams.facts.cam_strength import document as strength_document
from tmmcalc.cams.follower import Follower, contact_path, curvature
from tmmcalc.cams.forces.solve import solve_forces
from tmmcalc.cams.laws.catalogue import LAWS
from tmmcalc.cams.program import Phase, Program
from tmmcalc.cams.strength.columns import margin_rows, strength_columns
from tmmcalc.cams.strength.results import CamStrength
from tmmcalc.cams.strength.solve import solve_strength
from tmmcalc.cams.task import AngleLimits, Asked, CamTask, Guide, Loads, Requirements, Spring
from tmmcalc.core.conversion import from_record, to_record
from tmmcalc.pipeline.runner import run

CONFIGS = Path(__file__).parents[2] / "configs"
CASES = {case["id"]: case for case in json.loads((Path(__file__).parents[1] / "cases/cams.json").read_text())}
NEEDS = Requirements(
    width=0.008, contact=4e8, rolling_arm=5e-5, roller_friction=0.1, pin_friction=0.1, pin_pressure=5e6,
    span=0.1, bending=1e8, deflection=1e-5, guide_pressure=5e6,
)  # fmt: skip
FOLLOWER = Follower("translating", 0.05, 0.005, 0.008)


def program(stroke, rise_law="cosine", back_law="shun", angles=(80, 20, 90)):
    rise, high, back = map(radians, angles)
    return Program(
        (
            Phase("rise", rise, 0.0, stroke, LAWS[rise_law]),
            Phase("high dwell", high, stroke, stroke),
            Phase("return", back, stroke, 0.0, LAWS[back_law]),
            Phase("low dwell", 2 * pi - rise - high - back, 0.0, 0.0),
        )
    )


def task(kind="translating", *, laws=("cosine", "shun"), stroke=0.02, closure="force", needs=NEEDS, step=5.0, **loads):
    given = {"speed": 100.0, "mass": 0.2, "friction": 0.1, "spring": Spring(safety=1.5), **loads}
    return CamTask(
        program(stroke, *laws), Asked(kind, closure=closure), AngleLimits(1.0, None), step=radians(step),
        loads=Loads(**given), guide=Guide(top=0.125, stem=0.004, land=0.005), requirements=needs,
    )  # fmt: skip


def margin(found, name):
    return next(each for each in found.margins if each.name == name)


def test_whole_turn_of_the_worked_case():
    expected = CASES["cams-s20"]["expected"]
    found = solve_strength(task(), FOLLOWER)
    phi = np.degrees(found.positions.phi)
    rows = [int(np.flatnonzero(np.abs(phi - angle) < 1e-9)[-1]) for angle in expected["phi_deg"]]
    close = {"rel": 1e-4, "abs": 1e-6}
    assert 1e-6 * found.stress[rows] == pytest.approx(expected["sigma_H_MPa"], **close)
    assert 1e3 * found.reduced[rows] == pytest.approx(expected["M_E_Nmm"], **close)
    assert 1e3 * found.run[rows] == pytest.approx(expected["A_mm"], **close)
    assert 1e-6 * margin(found, "contact stress").value == pytest.approx(expected["sigma_H_max_MPa"], **close)
    assert 1e3 * found.shaft.moment == pytest.approx(expected["M_E_max_Nmm"], **close)
    assert 1e3 * found.unit.pin == pytest.approx(expected["r0_pin_mm"], **close)
    assert found.rolling.resisting == pytest.approx(expected["C1"], **close)
    assert 1e-3 * found.rolling.driving == pytest.approx(expected["C2_N_per_mm"], **close)
    assert margin(found, "no slip").value == pytest.approx(expected["D_max"], **close)
    assert 1e3 * found.shaft.strength == pytest.approx(expected["r1_strength_mm"], **close)
    assert 1e3 * found.shaft.stiffness == pytest.approx(expected["r1_stiffness_mm"], **close)
    assert found.shaft.radius == pytest.approx(0.007)
    assert found.verdict == "ok"
    assert found.governing.name == "contact stress"


def test_flat_face_of_the_worked_case():
    given, expected = CASES["cams-s13b"]["inputs"], CASES["cams-s13b"]["expected"]
    start = 1e-3 * CASES["cams-s13"]["expected"]["S0_min_mm"]
    needs = replace(
        NEEDS, width=1e-3 * given["b_mm"], span=1e-3 * given["l_support_mm"], bending=1e8, deflection=1e-5
    )  # fmt: skip
    asked = CamTask(
        program(0.012, "sine", "sine", (70, 20, 70)), Asked("flat"), AngleLimits(1.0, None, convex=0.003),
        loads=Loads(120.0, mass=0.15, friction=0.1, spring=Spring("given", stiffness=8000.0, preload=60.0)),
        guide=Guide(length=1e-3 * expected["l_min_mm"], stem=0.004, land=0.005), requirements=needs,
    )  # fmt: skip
    follower = Follower("flat", start)
    forces, found = solve_forces(asked, follower), solve_strength(asked, follower)
    near = {"rel": 1e-5}
    assert forces.extreme("R").largest == pytest.approx(expected["R_max_N"], **near)
    assert forces.extreme("N1").largest == pytest.approx(expected["N1_max_N"], **near)
    assert forces.guide.top == pytest.approx(1e-3 * expected["H2_min_mm"], **near)
    assert 1e-6 * margin(found, "contact stress").value == pytest.approx(expected["sigma_H_max_MPa"], **near)
    assert 1e3 * found.shaft.moment == pytest.approx(expected["M_E_max_Nmm"], **near)
    assert 1e3 * found.shaft.strength == pytest.approx(expected["r1_strength_mm"], **near)
    assert 1e3 * found.shaft.stiffness == pytest.approx(expected["r1_stiffness_mm"], **near)
    stem = 1e-3 * expected["stem_M_max_Nmm"] * 4 / (pi * 0.004**3)
    assert margin(found, "bending of the stem").value == pytest.approx(stem, **near)
    assert margin(found, "pressure in the guide").margin == pytest.approx(0, abs=1e-6)  # l is the shortest
    assert margin(found, "convex profile").margin == pytest.approx(0, abs=1e-6)  # S0 is the least
    assert margin(found, "no slip").verdict == "not judged"


@pytest.mark.parametrize("case", ["cams-s08", "cams-s09"])
def test_rocker_of_program_27(case):
    given, expected = CASES[case]["inputs"], CASES[case]["expected"]
    law = given["law"]
    asked = CamTask(
        program(radians(30), law, law, (60, 20, 60)), Asked("oscillating"), AngleLimits(1.0, None), steps=10,
        loads=Loads(100.0, mass=1e-4, spring=Spring("safety", safety=1.25)),
        requirements=Requirements(width=0.007, contact=2e8),
    )  # fmt: skip
    follower = Follower("oscillating", radians(30), roller=0.01, centres=0.1, rocker=0.1, assembly=given["assembly"])
    forces = solve_forces(asked, follower)
    found = solve_strength(asked, follower, forces)
    table = expected["table"]
    close = {"rel": 1e-5, "abs": 1e-6}
    assert forces.load[:11] == pytest.approx(table["M_sum_Nm"], **close)
    assert forces.contact[:11] == pytest.approx(table["R_N"], **close)
    assert 1e-6 * found.stress[:11] == pytest.approx(table["sigma_H_MPa"], **close)
    assert margin(found, "contact stress").value >= 1e6 * max(table["sigma_H_MPa"])
    assert margin(found, "bending of the stem").why == "a rocker has none"


ROCKER = Follower("oscillating", radians(40), roller=0.006, centres=0.1, rocker=0.08, assembly=-1)


@pytest.mark.parametrize(
    ("given", "follower"),
    [
        (task(), FOLLOWER),
        (task(laws=("const", "poly5")), FOLLOWER),
        (task(closure="groove", spring=Spring("given", stiffness=1500.0, preload=12.0)), FOLLOWER),
        (task("oscillating", laws=("sine", "shun"), stroke=radians(20), mass=1e-3, friction=0.0), ROCKER),
    ],
)
def test_extremes_against_a_dense_scan(given, follower):
    """No row of a dense table is beyond an extreme, and the extremes are near one."""
    found, fine = (solve_strength(replace(given, step=radians(step)), follower) for step in (5.0, 0.01))
    columns = {header.partition("[")[0]: column for header, column in strength_columns(fine).items()}
    for name, column in (
        ("contact stress", "sigma_H"),
        ("bending of the stem", "sigma_F"),
        ("pressure in the guide", "p"),
    ):
        if column in columns:
            top = columns[column].max()
            assert margin(found, name).value == pytest.approx(top, rel=1e-5)
            assert margin(found, name).value >= top * (1 - 1e-9)
    assert found.shaft.moment >= columns["M_E"].max() * (1 - 1e-9)
    assert found.shaft.moment == pytest.approx(columns["M_E"].max(), rel=1e-5)
    path = contact_path(follower, fine.positions.phi, given.program.at(fine.positions.phi, fine.positions.piece))
    bend = curvature(path)
    assert 1 / found.convex == pytest.approx(bend.max(), rel=1e-5)
    if margin(found, "no slip").value is not None:
        assert margin(found, "no slip").value == pytest.approx(columns["D"].max(), rel=1e-4)


def test_the_largest_stress_under_a_face_is_resolved():
    """R/rho peaks where neither R nor rho does: a scan of a hundredth of a degree comes within its square."""
    spec = tmmcalc.load_spec(CONFIGS / "cam-flat.toml", ["cam.step='0.01 deg'"])
    found = run(spec, target="cam_strength").results["cam_strength"]
    largest = margin(found, "contact stress").value
    assert 0 <= largest / np.max(found.stress) - 1 < 1e-7
    assert found.error["extremes"] < 1e-13


def test_slipping_is_located_at_the_change_of_walls():
    found = solve_strength(task(closure="groove", spring=Spring("none")), FOLLOWER)
    judged = margin(found, "no slip")
    assert judged.verdict == "slip"
    assert found.verdict == "slip"
    assert judged.value is None
    assert len(found.rolling.slipping) == 2
    for (low, high), middle in zip(found.rolling.slipping, (40, 145), strict=True):
        assert low < radians(middle) < high
    fine = solve_strength(replace(task(closure="groove", spring=Spring("none")), step=radians(0.02)), FOLLOWER)
    over = np.degrees(fine.positions.phi[fine.slip > 1])
    assert over.min() == pytest.approx(np.degrees(found.rolling.slipping[0][0]), abs=0.021)
    assert over.max() == pytest.approx(np.degrees(found.rolling.slipping[1][1]), abs=0.021)


def test_undercut_leaves_the_stress_open():
    follower = replace(FOLLOWER, start=0.03, offset=0.0, roller=0.026)
    found = solve_strength(task(laws=("const", "const")), follower)
    assert found.convex < 0.026
    assert margin(found, "no undercut").verdict == "undercut"
    assert margin(found, "contact stress").why == "the profile has a cusp"
    assert found.stress is None
    assert found.verdict == "undercut"


def test_without_data_nothing_is_judged_but_the_profile():
    found = solve_strength(task(needs=Requirements()), FOLLOWER)
    known = {each.name for each in found.margins if each.verdict != "not judged"}
    assert known == {"no undercut", "concave parts", "rule of the roller"}
    assert all(each.why for each in found.margins if each.verdict == "not judged")
    assert found.reduced is None
    assert found.slip is None


def test_nothing_acts():
    found = solve_strength(task(mass=0.0, spring=Spring("none")), FOLLOWER)
    assert found.verdict == "slip"
    to_record(found)


def test_knife_edge():
    found = solve_strength(task(), replace(FOLLOWER, roller=0.0))
    assert margin(found, "no slip").why == "a knife edge has no roller"
    assert "knife edge" in margin(found, "contact stress").why


def test_given_shaft_and_pin_are_judged():
    limits = AngleLimits(1.0, None, shaft=0.0068)
    found = solve_strength(replace(task(needs=replace(NEEDS, pin=0.003)), limits=limits), FOLLOWER)
    assert margin(found, "shaft stiffness").verdict == "exceeded"
    assert margin(found, "shaft strength").verdict == "ok"
    assert margin(found, "pressure on the pin").margin == pytest.approx(1 - (found_pin() / 0.003) ** 2, rel=1e-9)
    assert found.verdict == "exceeded"


def found_pin():
    """The pin by its pressure: p grows with 1/r0^2."""
    return solve_strength(task(), FOLLOWER).unit.pin


def test_groove_judges_its_outer_wall():
    follower = Follower("translating", 0.02, 0.0, 0.006)
    found = solve_strength(task(closure="groove", spring=Spring("none"), friction=0.0), follower)
    outer = margin(found, "outer wall")
    assert outer.limit == pytest.approx(found.concave)
    assert outer.value == pytest.approx(0.006 + AngleLimits(1.0, None).convex)
    assert outer.margin == pytest.approx(1 - outer.value / outer.limit)
    assert margin(found, "concave parts").verdict == "not judged"


def test_margin_is_zero_at_its_limit():
    found = solve_strength(task(), FOLLOWER)
    again = solve_strength(task(needs=replace(NEEDS, contact=margin(found, "contact stress").value)), FOLLOWER)
    assert margin(again, "contact stress").margin == 0
    assert margin(again, "contact stress").verdict == "ok"


@pytest.mark.parametrize("given", [task(), task(needs=Requirements()), task(closure="groove", spring=Spring("none"))])
def test_stored_and_restored(given):
    found = solve_strength(given, FOLLOWER)
    again = from_record(CamStrength, to_record(found))
    assert to_record(again).scalars == to_record(found).scalars
    for name, array in to_record(found).arrays.items():
        assert np.array_equal(to_record(again).arrays[name], array), name
    assert margin_rows(again) == margin_rows(found)


def test_forces_that_are_known_give_the_same():
    forces = solve_forces(task(), FOLLOWER)
    one, other = solve_strength(task(), FOLLOWER), solve_strength(task(), FOLLOWER, forces)
    assert one.margins == other.margins


@pytest.mark.parametrize("needs", [replace(NEEDS, pin=0.009), replace(NEEDS, pin_pressure=2e5)])
def test_a_pin_that_does_not_fit_is_told(needs):
    """As given, or as the pressure on it asks for."""
    found = solve_strength(task(needs=needs), FOLLOWER)
    assert found.unit.pin > FOLLOWER.roller
    assert found.rolling is None
    assert (margin(found, "no slip").verdict, margin(found, "no slip").why) == (
        "not judged",
        "the pin does not fit into the roller",
    )


@pytest.mark.parametrize(
    ("name", "missing"),
    [("contact stress", "contact"), ("bending of the stem", "bending"), ("pressure in the guide", "guide_pressure")],
)
def test_stresses_without_a_limit_show_their_largest(name, missing):
    known = margin(solve_strength(task(), FOLLOWER), name)
    bare = margin(solve_strength(task(needs=replace(NEEDS, **{missing: None})), FOLLOWER), name)
    assert (bare.verdict, bare.value, bare.phi) == ("not judged", known.value, known.phi)
    assert (bare.limit, bare.margin) == (None, None)
    assert missing in bare.why


def test_a_limit_far_behind_is_told_as_a_ratio():
    first = margin(solve_strength(task(), FOLLOWER), "contact stress").value
    found = solve_strength(task(needs=replace(NEEDS, contact=first / 1234)), FOLLOWER)
    document = strength_document(found, "S")
    assert "least margin 1234 times over: contact stress" in document.facts[0].text
    assert "1234 times over" in document.table.columns[3]


def test_weight_alone_can_be_judged():
    found = solve_strength(task(speed=4.0, gravity=-9.81), FOLLOWER)
    assert margin(found, "contact stress").value > 0
