"""Worked numbers of structure and kinematics, through the public interface.

Every case of the two files is either asserted here with its own tolerance, or listed below with the reason.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import tmmcalc
from linkage.scenes import CONFIGS
from tmmcalc import Guide, Kinematics, Method, Point, load_spec, parse_spec, solve_dyad, solve_kinematics
from tmmcalc.linkage.columns import columns
from tmmcalc.linkage.kinematics import step_study
from tmmcalc.linkage.tables.tasks.mechanism import to_linkage

FILES = ("kinematics.json", "force-groups-and-linkage-synthesis.json")
Array = NDArray[Any]

FORCES = "linkage/forces/test_cases.py"
LOOPS = "linkage/loops/test_cases.py"
SYNTHESIS = "linkage/synthesis/test_synthesis_cases.py"
ELSEWHERE = {  # cases of stages with tests of their own
    **{
        f"L-{name}": SYNTHESIS
        for name in ("SYN-SC-EX1", "SYN-SC-02", "SYN-SLOT-EX2", "SYN-SLOT-03", "SYN-ROT-01", "OUT-01")
    },
    "KIN-S04": "linkage/facts/test_pictures.py",
    **{f"F-SR{kind}-0{number}": FORCES for kind in (1, 2, 3) for number in (1, 2, 3)},
    **{f"F-{name}": FORCES for name in ("WL1-01", "WL1-02", "WL1-03", "WL2-01")},
    **{f"A-{name}": LOOPS for name in ("C4-MECH-12", "C4-RANGE", "C4-MODES", "C3-MODES", "C3-MECH-12")},
}
LEFT_OUT = {
    "KIN-S08": "crane luffing gear: unsteady motion of the input, not in the program yet",
    "KIN-S10": "time-optimal laws of motion, not in the program yet",
    "KIN-S11": "manipulator, not in the program yet",
    "KIN-S25": "crane luffing gear: unsteady motion of the input, not in the program yet",
    "B-CHAR-01": "characteristic functions of regions, not in the program yet",
}
TESTED: set[str] = set()


@cache
def all_cases() -> dict[str, dict[str, Any]]:
    folder = Path(__file__).parents[1] / "cases"
    return {case["id"]: case for name in FILES for case in json.loads((folder / name).read_text())}


def case(name: str) -> Callable[[Callable[..., None]], Any]:
    """Hand the test its case: inputs, expected, tolerance."""
    TESTED.add(name)
    return pytest.mark.parametrize("book", [pytest.param(name, id=name)], indirect=True)


@pytest.fixture
def book(request: pytest.FixtureRequest) -> dict[str, Any]:
    found = all_cases()[request.param]
    assert found["verified"]
    return found


def test_every_case_is_tested_or_left_out_for_a_reason() -> None:
    cases = all_cases()
    unverified = {name for name, each in cases.items() if not each["verified"]}
    assert not unverified & TESTED
    assert cases.keys() == TESTED | ELSEWHERE.keys() | LEFT_OUT.keys() | unverified
    assert not (TESTED | ELSEWHERE.keys()) & LEFT_OUT.keys()


@pytest.mark.parametrize("name", ELSEWHERE)
def test_cases_of_other_stages_are_used_there(name: str) -> None:
    """By the name in quotes, as code has it, not in prose."""
    assert f'"{name}"' in (Path(__file__).parents[1] / ELSEWHERE[name]).read_text(encoding="utf-8")


def solved(config: str, *overrides: str, method: Method | None = None) -> Kinematics:
    return solve_kinematics(load_spec(CONFIGS / f"{config}.toml", overrides), method)


def table(result: Kinematics, dimensionless: bool = False) -> dict[str, Array]:
    return {column.name: column.make() for column in columns(result, dimensionless=dimensionless)}


def close(found: Any, expected: Any, absolute: float, relative: float = 0.0) -> None:
    """Every number within the absolute or the relative tolerance, whichever is wider."""
    found, expected = np.asarray(found, float), np.asarray(expected, float)
    assert found.shape == expected.shape
    excess = np.abs(found - expected) - np.maximum(absolute, relative * np.abs(expected))
    assert np.all(excess <= 0), f"off by up to {np.max(np.abs(found - expected)):.3g}"


def close_angles(found: Any, expected: Any, absolute: float, turn: float = 360.0) -> None:
    """Angles, modulo the whole turn."""
    off = np.asarray(found, float) - np.asarray(expected, float)
    close(off - turn * np.round(off / turn), np.zeros_like(off), absolute)


def check_table(book: dict[str, Any], values: dict[str, Array], names: dict[str, str], absolute: float) -> None:
    """All columns of a case; ``names`` maps them to columns of the program."""
    expected = book["expected"]["columns"]
    assert expected.keys() - names.keys() <= {"i", "phi1_deg", "phi_deg"}
    for printed, own in names.items():
        if printed.endswith("_deg"):
            close_angles(values[own], expected[printed], book["tolerance"]["abs_deg"])
        else:
            close(values[own], expected[printed], absolute)


ROW = {
    "phi3_deg": "angle_3", "phi4_deg": "angle_4", "S_over_l1": "S_D", "v23": "v_A3", "a23": "a_A3",
    "om3": "omega_3", "om4": "omega_4", "ep3": "eps_3", "ep4": "eps_4", "vD": "vS_D", "aD": "aS_D",
}  # fmt: skip


@case("KIN-S01")
def test_shaper_dimensionless(book: dict[str, Any]) -> None:
    result = solved("shaper")
    check_table(book, table(result, dimensionless=True), ROW, book["tolerance"]["abs_dimensionless"])
    close(np.degrees(result.x[0]), book["expected"]["phi1_start_deg"], book["tolerance"]["abs_deg"])
    assert result.labels == tuple(map(str, range(25)))


@case("KIN-S02")
def test_shaper_by_central_differences(book: dict[str, Any]) -> None:
    expected, tolerance = book["expected"], book["tolerance"]
    theta = np.radians(book["inputs"]["theta_deg"])
    exact = table(solved("shaper"), dimensionless=True)
    found = table(solved("shaper", method=Method("differences", step=theta)), dimensionless=True)
    for printed, own, letter in (("vD_num", "vS_D", "v"), ("aD_num", "aS_D", "a")):
        close(found[own][expected["i"]], expected[printed], tolerance["abs"])
        error = np.abs(found[own] - exact[own])
        close(error.max(), expected[f"max_abs_err_{letter}_all24"], 0, tolerance["err_rel"])
        close(error[:24].mean(), expected[f"mean_abs_err_{letter}"], 0, tolerance["err_rel"])


@case("KIN-S03")
def test_shaper_in_si_units(book: dict[str, Any]) -> None:
    values, tolerance = table(solved("shaper")), book["tolerance"]
    names = {
        "om3": "omega_3", "ep3": "eps_3", "l3": "s_A3", "v23": "v_A3", "a23": "a_A3", "om4": "omega_4",
        "ep4": "eps_4", "xD": "x_D", "vD": "vx_D", "aD": "ax_D", "xC": "x_C", "yC": "y_C", "vCx": "vx_C",
        "vCy": "vy_C", "aCx": "ax_C", "aCy": "ay_C",
    }  # fmt: skip
    for row in book["expected"]["rows"]:
        assert row.keys() == names.keys() | {"i", "phi3", "phi4"}
        for printed, own in names.items():
            close(values[own][row["i"]], row[printed], tolerance["abs"], tolerance["rel"])
        for link in (3, 4):
            close_angles(values[f"angle_{link}"][row["i"]], np.degrees(row[f"phi{link}"]), np.degrees(tolerance["abs"]))


@case("KIN-S05")
def test_shaper_on_a_grid_of_two_steps(book: dict[str, Any]) -> None:
    expected, tolerance = book["expected"], book["tolerance"]
    steps = f"mechanism.grid={{working={book['inputs']['n1']}, idle={book['inputs']['n2']}}}"
    result = solved("shaper", steps)
    summary = result.summaries[0]
    degrees = tolerance["abs_deg"]
    close(np.degrees(result.x), expected["grid_phi1_deg"], degrees)
    close(np.degrees([centre.x for centre in summary.dead_centres]), expected["phi1_extreme_deg"], degrees)
    close(
        np.degrees([summary.working_angle, summary.idle_angle]),
        [expected["working_angle_deg"], expected["idle_angle_deg"]],
        degrees,
    )
    close(summary.time_ratio, expected["time_ratio"], 0, tolerance["rel"])
    close(summary.stroke, expected["stroke_m"], tolerance["abs_m"])
    close_angles(table(result)["angle_3"][[0, book["inputs"]["n1"]]], expected["phi3_extreme_deg"], degrees)


@case("KIN-S06")
def test_four_bar(book: dict[str, Any]) -> None:
    names = {
        "phi2_deg": "angle_2",
        "phi3_deg": "angle_3",
        "om2": "omega_2",
        "om3": "omega_3",
        "ep2": "eps_2",
        "ep3": "eps_3",
    }
    result = solved("four-bar")
    check_table(book, table(result), names, book["tolerance"]["abs"])
    assert result.domain.full is book["expected"]["grashof"]["rotatable"]


@case("KIN-S07")
def test_press(book: dict[str, Any]) -> None:
    names = {
        "phi2_deg": "angle_2", "om2": "omega_2", "ep2": "eps_2", "xB": "x_B", "vB": "vx_B", "aB": "ax_B",
        "aS2x": "ax_S2", "aS2y": "ay_S2",
    }  # fmt: skip
    values = table(solved("press"))
    book["tolerance"]["abs_deg"] = 1e-5  # as in all tables of this kind; the case names none for angles
    check_table(book, values, names, book["tolerance"]["abs"])
    inertia = book["expected"]["inertia_check"]
    misprints = {"P3": (4, 6, 8), "P2x": (1, 8, 11), "P2y": ()}  # as the notes of the case tell
    for name, force in (("P3", -24 * values["ax_B"]), ("P2x", -12 * values["ax_S2"]), ("P2y", -12 * values["ay_S2"])):
        kept = [i for i in range(13) if i not in misprints[name]]
        close(force[kept], np.array(inertia[name])[kept], book["tolerance"]["abs_N"])


@case("KIN-S09")
@pytest.mark.parametrize(("key", "config"), [("engine", "engine-compressor"), ("shaper", "shaper")])
def test_structure(book: dict[str, Any], key: str, config: str) -> None:
    structure, expected = tmmcalc.solve_structure(load_spec(CONFIGS / f"{config}.toml")), book["expected"][key]
    assert structure.mobility == expected["dof"]
    assert [list(group.links) for group in structure.groups] == expected["groups_in_assembly_order"]
    assert [group.kind for group in structure.groups] == expected["types"]
    assert [list(group.outer) for group in structure.groups] == expected["attachments"]
    assert [list(group.source) for group in structure.groups] == expected["source_chains"]
    assert structure.links == len({k for pair in book["inputs"][key]["pairs"] for k in pair[:2]}) - 1
    assert structure.joints == len(book["inputs"][key]["pairs"])


def point(state: dict[str, float]) -> Point:
    return Point(*(complex(state[f"{p}x"], state[f"{p}y"]) for p in ("", "v", "a")))


def guide(state: dict[str, Any]) -> Guide:
    return Guide.along(point(state["point"]), np.radians(state["gamma_deg"]), state["omega"], state["eps"])


def components(at: Point) -> dict[str, float]:
    parts = zip(("", "v", "a"), at, strict=True)
    return {f"{p}{axis}": value for p, z in parts for axis, value in (("x", z.real), ("y", z.imag))}


def check_point(found: Point, expected: dict[str, float], absolute: float) -> None:
    own = components(found)
    assert expected.keys() == own.keys()
    for name, value in expected.items():
        close(own[name], value, absolute)


def check_slide(slide: Any, expected: dict[str, float], name: str, absolute: float) -> None:
    close([*slide], [expected[name], expected[f"{name}_dot"], expected[f"{name}_ddot"]], absolute)


@case("KIN-S12")
def test_dyad_rrr(book: dict[str, Any]) -> None:
    given, expected, tolerance = book["inputs"], book["expected"], book["tolerance"]["abs"]
    found = solve_dyad(
        tmmcalc.RRR(given["l_a"], given["l_b"], given["variant"]), point(given["P1"]), point(given["P2"])
    )
    for link, motion in (("a", found.a), ("b", found.b)):
        turned = [np.angle(motion.u), motion.omega, motion.eps]
        close(turned, [expected[f"{q}_{link}"] for q in ("phi", "omega", "eps")], tolerance)
    assert found.inner is not None
    check_point(found.inner, expected["B"], tolerance)


@case("KIN-S13")
def test_dyad_rrp(book: dict[str, Any]) -> None:
    given, expected, tolerance = book["inputs"], book["expected"], book["tolerance"]["abs"]
    dyad = tmmcalc.RRP(given["l"], given["h"], given["variant"])
    found = solve_dyad(dyad, point(given["P1"]), guide(given["guide"]))
    close([np.angle(found.a.u), found.a.omega, found.a.eps], [expected[q] for q in ("phi", "omega", "eps")], tolerance)
    check_slide(found.slides[0], expected, "s", tolerance)
    assert found.inner is not None
    check_point(found.inner, expected["B"], tolerance)


@case("KIN-S14")
def test_dyad_rpr(book: dict[str, Any]) -> None:
    given, expected, tolerance = book["inputs"], book["expected"], book["tolerance"]["abs"]
    found = solve_dyad(tmmcalc.RPR(given["h"], given["variant"]), point(given["P1"]), point(given["P2"]))
    close([np.angle(found.b.u), found.b.omega, found.b.eps], [expected[q] for q in ("phi", "omega", "eps")], tolerance)
    check_slide(found.slides[0], expected, "s", tolerance)


@case("KIN-S15")
def test_dyad_prp(book: dict[str, Any]) -> None:
    given, expected, tolerance = book["inputs"], book["expected"], book["tolerance"]["abs"]
    found = solve_dyad(tmmcalc.PRP(given["h1"], given["h2"]), guide(given["guide1"]), guide(given["guide2"]))
    for slide, name in zip(found.slides, ("s1", "s2"), strict=True):
        check_slide(slide, expected, name, tolerance)
    assert found.inner is not None
    check_point(found.inner, expected["B"], tolerance)


@case("KIN-S16")
def test_dyad_rpp(book: dict[str, Any]) -> None:
    given, expected, tolerance = book["inputs"], book["expected"], book["tolerance"]["abs"]
    dyad = tmmcalc.RPP(np.exp(1j * np.radians(given["delta_deg"])), given["h1"], given["h2"])
    found = solve_dyad(dyad, point(given["P1"]), guide(given["guide"]))
    inner, outer = found.slides  # in the order of the letters R P P
    check_slide(outer, expected, "s1", tolerance)
    check_slide(inner, expected, "s2", tolerance)


@case("KIN-S17")
def test_rotating_slotted_link(book: dict[str, Any]) -> None:
    names = {"phi3_deg": "angle_3", "om3": "omega_3", "ep3": "eps_3", "l3": "s_A3", "v23": "v_A3", "a23": "a_A3"}
    values = table(solved("slotted-link"))
    check_table(book, values, names, book["tolerance"]["abs"])
    printed = book["expected"]["columns"]["phi3_deg"]
    close(values["angle_3"] - values["angle_3"][0], np.array(printed) - printed[0], book["tolerance"]["abs_deg"])
    close(values["angle_3"][-1] - values["angle_3"][0], 360.0, 1e-12)


@case("KIN-S18")
def test_angle_recovery(book: dict[str, Any]) -> None:
    pairs = np.array(book["inputs"]["pairs_sin_cos"], float)
    still = np.zeros(len(pairs), complex)
    found = solve_dyad(tmmcalc.RPR(), Point(pairs[:, 1] + 1j * pairs[:, 0], still, still), Point(still, still, still))
    close(np.angle(found.b.u), book["expected"]["angle_rad"], book["tolerance"]["abs"])


def slider_lengths(given: dict[str, float]) -> list[str]:
    return [
        f"mechanism.links[id=1].points.A=[{given['l1']}, 0]",
        f"mechanism.links[id=2].points.B=[{given['l2']}, 0]",
        f"mechanism.joints[name=B0].guide={{through=[0, {given['e']}]}}",
    ]


@case("KIN-S19")
def test_impossible_positions_are_reported(book: dict[str, Any]) -> None:
    given, expected = {each["id"]: each for each in book["inputs"]["cases"]}, book["expected"]
    lengths = slider_lengths(given["a"])
    with pytest.raises(tmmcalc.AssemblyError, match="the crank cannot make a full turn") as refused:
        solved("crank-slider", *lengths)
    assert "RRP(2,3)" in str(refused.value)
    part = solved("crank-slider", *lengths, "mechanism.input.start=0", 'mechanism.grid.span="60 deg"')
    (interval,) = part.domain.intervals
    blocked = np.degrees([interval.high, interval.low + 2 * np.pi])
    close(blocked, expected["a"]["blocked_phi1_deg"], book["tolerance"]["abs_deg"])
    with pytest.raises(tmmcalc.AssemblyError, match="the crank cannot make a full turn"):
        solved("four-bar", *bars(given["b"], f"[{given['b']['l0']}, 0]"))
    here = Point(0j, 0j, 0j)
    guides = (Guide.along(here, np.radians(given["c"][f"gamma{k}_deg"])) for k in (1, 2))
    with pytest.raises(tmmcalc.SingularityError):
        solve_dyad(tmmcalc.PRP(), *guides)
    at = Point(complex(*given["d"]["P1"]), 0j, 0j)
    with pytest.raises(tmmcalc.SingularityError):
        solve_dyad(tmmcalc.RPR(given["d"]["h"]), at, at)
    with pytest.raises(tmmcalc.AssemblyError, match="cannot be assembled at any crank angle"):
        solved("crank-slider", *slider_lengths(given["e"]))


def bars(given: dict[str, float], c: str) -> list[str]:
    names = (("l1", 1, "A"), ("l2", 2, "B"), ("l3", 3, "B"))
    moving = [f"mechanism.links[id={link}].points.{end}=[{given[l]}, 0]" for l, link, end in names]
    return [*moving, f"mechanism.fixed.C={c}"]


@case("KIN-S20")
def test_error_of_differences_against_their_step(book: dict[str, Any]) -> None:
    expected, tolerance = book["expected"], book["tolerance"]
    spec = load_spec(CONFIGS / "shaper.toml")
    study = step_study(to_linkage(spec.mechanism), solve_kinematics(spec))
    assert [row["theta_deg"] for row in expected["table"]] == pytest.approx([np.degrees(e.step) for e in study])
    factor = tolerance["factor_six_decimals"]
    for row, found in zip(expected["table"], study, strict=True):
        for own, printed in ((found.double.first, "max_v"), (found.double.second, "max_a")):
            close(own, row["double"][printed], 0, tolerance["rel_double"])
        for own, printed in ((found.rounded.first, "max_v"), (found.rounded.second, "max_a")):
            assert row["six_decimals"][printed] / factor < own < row["six_decimals"][printed] * factor
    best = min(study, key=lambda each: each.rounded.second)
    low, high = expected["best_theta_for_acceleration_six_decimals_deg"]
    assert low - 1e-9 <= np.degrees(best.step) <= high + 1e-9


@case("KIN-S21")
def test_slotting_machine(book: dict[str, Any]) -> None:
    names = {
        "phi3_deg": "angle_3", "phi4_deg": "angle_4", "om3": "omega_3", "om4": "omega_4", "ep3": "eps_3",
        "ep4": "eps_4", "yE": "y_E", "vE": "vy_E", "aE": "ay_E",
    }  # fmt: skip
    result = solved("slotter", "mechanism.input.speed=1", "mechanism.input.start=0", "mechanism.grid.extremes=false")
    check_table(book, table(result), names, book["tolerance"]["abs"])


@case("KIN-S22")
def test_offset_crank_slider(book: dict[str, Any]) -> None:
    names = {"phi2_deg": "angle_2", "om2": "omega_2", "ep2": "eps_2", "s": "x_B", "v": "vx_B", "a": "ax_B"}
    expected, tolerance = book["expected"], book["tolerance"]
    overrides = [*slider_lengths(book["inputs"]), "mechanism.input.start=0"]
    result = solved("crank-slider", *overrides)
    check_table(book, table(result), names, tolerance["abs"])
    summary = result.summaries[0]
    angles = sorted(np.degrees(centre.x) for centre in summary.dead_centres)
    close_angles(angles, expected["extreme_phi1_deg"][::-1], tolerance["abs_deg"])
    close(summary.stroke, expected["stroke"], tolerance["abs"])
    assert summary.working_angle is not None
    assert summary.idle_angle is not None
    between = min(np.degrees([summary.working_angle, summary.idle_angle]))
    close(between, expected["angle_outer_to_inner_deg"], tolerance["abs_deg"])
    assert result.domain.full is expected["rotatable"]


@case("KIN-S23")
def test_v_engine(book: dict[str, Any]) -> None:
    expected, degrees = book["expected"], book["tolerance"]["abs_deg"]
    result = solved("v-engine")
    l1, values = book["inputs"]["l1"] / 1000, table(result, dimensionless=True)
    right, left = result.summaries
    bottom = min(left.dead_centres, key=lambda centre: centre.value)
    along = (values["x_D"] + values["y_D"]) / np.sqrt(2)
    values |= {"S3": values["S_B"], "S5": along - bottom.value / l1}
    names = {"phi4_deg": "angle_4", "S3": "S3", "S5": "S5", "v3": "vS_B", "a3": "aS_B", "v5": "vS_D", "a5": "aS_D"}
    check_table(book, values, names, book["tolerance"]["abs"])
    assert right.stroke is not None
    assert left.stroke is not None
    close(right.stroke / l1, expected["stroke_right_over_l1"], book["tolerance"]["abs"])
    close(left.stroke / l1, expected["stroke_left_over_l1"], book["tolerance"]["abs"])
    close_angles(np.degrees(bottom.x) - 180, expected["bdc_left_phi_deg"], degrees)
    top = max(left.dead_centres, key=lambda centre: centre.value)
    close_angles(np.degrees(top.x), expected["tdc_left_phi1_deg"], degrees)
    c = load_spec(CONFIGS / "v-engine.toml").mechanism.links[1].points["C"]
    close(np.degrees(np.arctan2(c[1], c[0])), expected["alpha_deg"], degrees)


@case("KIN-S24")
def test_inertial_conveyor(book: dict[str, Any]) -> None:
    names = {
        f"{a}{k}{end}": f"{b}_{k}"
        for k in (2, 3, 4)
        for a, b, end in (("phi", "angle", "_deg"), ("om", "omega", ""), ("ep", "eps", ""))
    }
    result = solved("inertial-conveyor", "mechanism.input.speed=1", "mechanism.input.start=0")
    check_table(book, table(result), names | {"xD": "x_D", "vD": "vx_D", "aD": "ax_D"}, book["tolerance"]["abs"])


@case("L-PLAN-SC")
def test_position_plan_of_a_crank_slider(book: dict[str, Any]) -> None:
    given, expected, tolerance = book["inputs"], book["expected"], book["tolerance"]
    lengths = slider_lengths({"l1": given["r"], "l2": given["l"], "e": given["e"]})
    result = solved(
        "crank-slider", *lengths, 'mechanism.outputs=[{point="B"}]', "mechanism.grid={positions=12, extremes=true}"
    )
    check_plan(result, expected, tolerance, "B")
    summary = result.summaries[0]
    assert summary.working_angle is not None
    close(np.degrees(summary.working_angle), expected["second_extreme_relative_deg"], 0, tolerance["rel"])
    extra = result.labels.index("6'")
    close(np.degrees(result.phi[extra]), expected["second_extreme_relative_deg"], 0, tolerance["rel"])
    close(table(result)["x_B"][extra], expected["slider_x_second_extreme"], tolerance["abs"])


def check_plan(result: Kinematics, expected: dict[str, Any], tolerance: dict[str, float], name: str) -> None:
    """Twelve positions, the thirteenth closes the cycle; an extra one only if it is no position already."""
    assert len(result.x) == 13 + expected["extra_position_added"]
    plain = [i for i, label in enumerate(result.labels) if "'" not in label][:12]
    close_angles(np.degrees(result.x[plain]), expected["crank_angles_deg"], np.degrees(tolerance["abs"]))
    close(table(result)[f"x_{name}"][plain], expected["slider_x"], tolerance["abs"], tolerance["rel"])


@case("L-PLAN-SLOT")
def test_position_plan_of_a_slotted_link(book: dict[str, Any]) -> None:
    given, expected = book["inputs"], book["expected"]
    result = solved(
        "shaper",
        f"mechanism.fixed.O={given['crank_centre']}",
        f"mechanism.links[id=1].points.A=[{given['r']}, 0]",
        f"mechanism.links[id=3].points.C=[{given['R']}, 0]",
        f"mechanism.links[id=4].points.D=[{given['l']}, 0]",
        f"mechanism.joints[name=D0].guide={{through=[0, {given['e']}]}}",
        "mechanism.grid={positions=12, extremes=true}",
    )
    check_plan(result, expected, book["tolerance"], "D")
    second = result.summaries[0].dead_centres[1]
    close(np.degrees(second.x - result.x[0]), expected["second_extreme_relative_deg"], 0, book["tolerance"]["rel"])
    close(result.phi[expected["coincides_with_position"]], second.x - result.x[0], 1e-6)


def check_motion(book: dict[str, Any], values: dict[str, Array], names: dict[str, str]) -> None:
    """The first twelve positions of a case; angles in rad."""
    tolerance = book["tolerance"]
    for printed, own in names.items():
        if printed.startswith("phi"):
            close_angles(np.radians(values[own][:12]), book["expected"][printed], tolerance["abs"], 2 * np.pi)
        else:
            close(values[own][:12], book["expected"][printed], tolerance["abs"], tolerance["rel"])


@case("F-MECH-4BAR-12")
def test_crank_rocker(book: dict[str, Any]) -> None:
    given = book["inputs"]
    lengths = bars({"l1": given["l_O1A"], "l2": given["l_AB"], "l3": given["l_CB"]}, str(given["C"]))
    result = solved("four-bar", *lengths, f"mechanism.input.speed={given['omega1']}")
    names = {f"{a}{k}": f"{b}_{k}" for k in (2, 3) for a, b in (("phi", "angle"), ("omega", "omega"), ("eps", "eps"))}
    check_motion(book, table(result), names)


@case("F-MECH-SC-12")
def test_fast_crank_slider(book: dict[str, Any]) -> None:
    given = book["inputs"]
    lengths = slider_lengths({"l1": given["l_O1A"], "l2": given["l_AB"], "e": given["guide_offset_e"]})
    result = solved("crank-slider", *lengths, f"mechanism.input={{joint='O', start=0, speed={given['omega1']}}}")
    names = {"phi2": "angle_2", "omega2": "omega_2", "eps2": "eps_2", "s_B": "s_B0", "v_B": "v_B0", "a_B": "a_B0"}
    check_motion(book, table(result), names)


CYLINDER = """
[mechanism]
grid = {{ positions = 12 }}
input = {{ joint = "O", speed = {omega1}, start = 0 }}
fixed = {{ O = {O1}, E = {E} }}
links = [
    {{ id = 1, points = {{ O = [0, 0], A = [{l_O1A}, 0] }} }},
    {{ id = 2, points = {{ A = [0, 0], B = [{l_AB}, 0] }} }},
    {{ id = 3, points = {{ E = [0, 0], C = [-{l_EC}, 0] }} }},
]
joints = [
    {{ name = "O", kind = "revolute", links = [0, 1] }},
    {{ name = "A", kind = "revolute", links = [1, 2] }},
    {{ name = "B", kind = "prismatic", links = [2, 3], slider = {{ through = "B" }}, guide = {{ through = "C" }} }},
    {{ name = "E", kind = "revolute", links = [0, 3] }},
]
assembly = {{ sketch = {{ B = [0.4, 0.08] }} }}
"""


@case("F-MECH-CYL-12")
def test_oscillating_cylinder(book: dict[str, Any]) -> None:
    """The piston B stands in the cylinder beyond its cap C, measured from C."""
    result = solve_kinematics(parse_spec(CYLINDER.format(**book["inputs"])))
    check_motion(book, table(result), {"phi2": "angle_2", "omega2": "omega_2", "eps2": "eps_2", "l_BC": "s_B"})


def dyad_of(book: dict[str, Any]) -> tuple[tmmcalc.RRR, Sequence[Point]]:
    given = book["inputs"]
    still = {"vel": [0.0, 0.0], "acc": [0.0, 0.0]}
    ports = [Point(*(complex(*(still | given[name])[part]) for part in ("pos", "vel", "acc"))) for name in ("P1", "P2")]
    return tmmcalc.RRR(given["PAR"]["l1"], given["PAR"]["l2"], given["K"]), ports


@case("A-DYAD-01")
def test_dyad_with_extra_points(book: dict[str, Any]) -> None:
    check_dyad(book)


@case("A-DYAD-02")
def test_dyad_with_extra_points_on_both_links(book: dict[str, Any]) -> None:
    check_dyad(book)


def check_dyad(book: dict[str, Any]) -> None:
    expected, tolerance, par = book["expected"], book["tolerance"], book["inputs"]["PAR"]
    dyad, ports = dyad_of(book)
    found = solve_dyad(dyad, *ports)
    for name, phi, motion in (("angle1", np.angle(found.a.u), found.a), ("angle2", np.angle(found.b.u), found.b)):
        close(
            [phi, motion.omega, motion.eps], [expected[name][q] for q in ("phi", "omega", "eps")], **limits(tolerance)
        )
    points = {
        "inner": found.inner,
        "extra_on_link1": found.a.point(par["l3"] * np.exp(1j * par["alpha1"])),
        "extra_on_link2": found.b.point(par["l4"] * np.exp(1j * par["alpha2"])),
    }
    for name, at in points.items():
        assert at is not None
        for part, value in zip(("pos", "vel", "acc"), at, strict=True):
            close([value.real, value.imag], expected[name][part], **limits(tolerance))


def limits(tolerance: dict[str, float]) -> dict[str, float]:
    return {"absolute": tolerance["abs"], "relative": tolerance["rel"]}


@case("A-DYAD-03")
def test_dyad_that_does_not_reach(book: dict[str, Any]) -> None:
    dyad, ports = dyad_of(book)
    with pytest.raises(tmmcalc.AssemblyError, match="does not assemble"):
        solve_dyad(dyad, *ports)
