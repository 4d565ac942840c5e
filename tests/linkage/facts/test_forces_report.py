"""The document of the forces stage, against closed forms of a massless crank-slider and the textbook's press."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from loaded import DEG, press

from linkage.scenes import crank_slider, driven_rod, full_turn, with_input
from tmmcalc.core.errors import UsageError
from tmmcalc.linkage.facts.forces import document as forces_document
from tmmcalc.linkage.facts.forces import summary as forces_summary
from tmmcalc.linkage.facts.iteration import iteration_document
from tmmcalc.linkage.facts.kinematics import summary as kinematics_summary
from tmmcalc.linkage.facts.structure import summary as structure_document
from tmmcalc.linkage.forces.columns import columns
from tmmcalc.linkage.forces.iteration import textbook_iteration
from tmmcalc.linkage.forces.kinetostatics import compile_statics
from tmmcalc.linkage.forces.results import Forces
from tmmcalc.linkage.forces.solve import solve_forces
from tmmcalc.linkage.kinematics import solve_kinematics
from tmmcalc.linkage.loading import Body, GearDrive, Load, Loading, Pair, Window
from tmmcalc.linkage.loadlaws.constant import Constant
from tmmcalc.linkage.loadlaws.viscous import Viscous
from tmmcalc.linkage.loads.scene import compile_scene
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.results import Extreme
from tmmcalc.report.document import Document
from tmmcalc.report.plaintext import lines

R, L, F = 0.1, 0.25, 200.0  # crank, rod [m], force on the slider [N]
HALF = Window(angles=(0.0, np.pi))  # one half of the turn, so that maxima are single
PUSH = Load("Q3", 3, "force", Constant(F), window=HALF)  # against the way in
CASE = next(
    case
    for case in json.loads((Path(__file__).parents[2] / "cases" / "dynamics.json").read_text())
    if case["id"] == "dyn-press-friction"
)["expected"]


def solved(mechanism: Mechanism, loading: Loading) -> Forces:
    return solve_forces(mechanism, loading, solve_kinematics(mechanism))


def slider(speed: float = 2.0) -> Mechanism:
    return with_input(full_turn(crank_slider(R, L)), speed=speed)


def values(document: Document) -> dict[str, Any]:
    return {key: value for fact in document.facts for key, value in fact.values.items()}


def text(document: Document, label: str) -> str:
    (fact,) = [fact for fact in document.facts if fact.label == label]
    return fact.text


def transfer(phi: np.ndarray) -> np.ndarray:
    """dx/dphi of the slider of an in-line crank-slider."""
    s = R * np.sin(phi)
    return -s - s * R * np.cos(phi) / np.sqrt(L**2 - s**2)


def finest(f: Any, low: float, high: float) -> tuple[float, float]:
    """Largest value of f and its place, by a sample made finer around the best point."""
    for _ in range(12):
        x = np.linspace(low, high, 401)
        k = int(np.argmax(f(x)))
        low, high = x[max(k - 1, 0)], x[min(k + 1, 400)]
    return float(f(x[k])), float(x[k])


@pytest.fixture(scope="module")
def pressed() -> Forces:
    mechanism, loading, kinematics = press()
    return solve_forces(mechanism, loading, kinematics)


def test_drive_and_reactions_of_a_massless_crank_slider() -> None:
    """M = F x', N = F tan psi with sin psi = R sin phi / L, the rod's force F / cos psi."""
    found = values(forces_summary(solved(slider(), Loading(loads=(PUSH,))), "t"))
    moment, at = finest(lambda phi: -F * transfer(phi), 0.0, np.pi)
    assert found["drive"] == "coupling"
    assert found["M_drive_max[N*m]"] == pytest.approx(moment, rel=1e-12)
    assert found["M_drive_max_at_phi[deg]"] == pytest.approx(at / DEG, abs=1e-4)
    assert found["P_drive_max[W]"] == pytest.approx(2.0 * moment, rel=1e-12)
    root = np.sqrt(L**2 - R**2)
    assert found["R_B0_max[N]"] == pytest.approx(F * R / root, rel=1e-12)
    assert found["R_B0_max_at_phi[deg]"] == pytest.approx(90.0, abs=1e-4)
    for joint in ("O", "A", "B"):
        assert found[f"R_{joint}_max[N]"] == pytest.approx(F * L / root, rel=1e-12)
    assert found["friction"] is False


def test_a_clockwise_crank_has_negative_places() -> None:
    found = values(forces_summary(solved(slider(-2.0), Loading(loads=(PUSH,))), "t"))
    moment, at = finest(lambda phi: -F * transfer(phi), 0.0, np.pi)
    assert found["M_drive_min[N*m]"] == pytest.approx(-moment, rel=1e-12)
    assert found["M_drive_min_at_phi[deg]"] == pytest.approx(-at / DEG, abs=1e-4)
    assert found["P_drive_max[W]"] == pytest.approx(2.0 * moment, rel=1e-12)


def test_mean_power_overcomes_what_is_lost() -> None:
    """Against -c v on the slider the mean power is c times the mean of v^2, spectrally accurate over a turn."""
    loading = Loading(loads=(Load("Q3", 3, "force", Viscous(30.0)),))
    found = values(forces_summary(solved(slider(), loading), "t"))
    phi = 2 * np.pi * np.arange(2000) / 2000
    assert found["P_drive_mean[W]"] == pytest.approx(30.0 * np.mean((2.0 * transfer(phi)) ** 2), rel=1e-13)
    assert 0 < found["P_drive_mean_error[W]"] < 1e-8 * found["P_drive_mean[W]"]


def test_arm_and_tipping_of_a_slider_that_is_pushed_beside_its_pin() -> None:
    """A force a above the pin turns the slider by a F; the normal force F tan psi balances it at h = -a / tan psi."""
    a, length = 0.02, 0.16
    push = replace(PUSH, point=1j * a)
    document = forces_summary(solved(slider(), Loading(loads=(push,), pairs=(Pair("B0", length=length),))), "t")
    found = values(document)
    arm = -a * np.sqrt(L**2 - R**2) / R
    assert found["h_B0[m]"] == pytest.approx(arm, rel=1e-9)
    assert found["h_B0_in_position"] == "6"
    assert f"arm h = {1e3 * arm:.5g} mm in position 6" in text(document, "reaction in B0 (0-3)")
    assert found["M_B0_max[N*m]"] == pytest.approx(a * F, rel=1e-12)
    psi = np.arcsin(R * np.sin(np.arange(25) * 15 * DEG) / L)
    tipping = [str(k) for k in range(13) if F * np.tan(psi[k]) * length / 2 < a * F]
    assert found["tips_B0"] == tipping
    assert "bears on two opposite edges in positions 0, 1," in text(document, "reaction in B0 (0-3)")
    assert found["edge_B0_max[N]"] == pytest.approx(F * R / np.sqrt(L**2 - R**2) / 2 + a * F / length, rel=1e-9)


def test_a_slider_without_couple_says_so() -> None:
    document = forces_summary(solved(slider(), Loading(loads=(PUSH,), pairs=(Pair("B0", length=0.1),))), "t")
    told = text(document, "reaction in B0 (0-3)")
    assert "no couple" in told
    assert "arm" not in told
    assert "bears on one side throughout" in told
    assert values(document)["tips_B0"] == []


def test_the_mesh_force_is_largest_where_the_moment_is() -> None:
    """|F| = |M| / (r cos alpha)."""
    loading = Loading(loads=(PUSH,), drive=GearDrive(0.12, 20 * DEG, -90 * DEG))
    found = values(forces_summary(solved(slider(), loading), "t"))
    moment, at = finest(lambda phi: -F * transfer(phi), 0.0, np.pi)
    assert found["drive"] == "gear"
    assert found["F_mesh_max[N]"] == pytest.approx(moment / (0.12 * np.cos(20 * DEG)), rel=1e-9)
    assert found["F_mesh_max_at_phi[deg]"] == pytest.approx(at / DEG, abs=1e-4)


def test_a_driven_slider_is_told_in_newtons_and_metres() -> None:
    mechanism = driven_rod(1.0, 0.2, 0.5)
    document = forces_document(solved(mechanism, Loading((Body(2, 3.0, 0.1, 0.2 + 0j),), -9.81j)), "t")
    found = values(document)
    assert found["drive"] == "slider"
    assert "F_drive_max[N]" in found
    assert "F_drive_max_at_phi[m]" in found
    assert text(document, "drive").startswith("a force along the guide")
    assert document.table is not None
    assert document.table.headers[:3] == ["i", "phi[m]", "F_drive[N]"]
    assert "F_drive" in document.more


def test_friction_is_told_with_its_jumps(pressed: Forces) -> None:
    """The rod reverses at 90 and 270 degrees, the slider at 180."""
    document = forces_summary(pressed, "t")
    found = values(document)
    assert found["friction"] is True
    assert found["friction_jumps"] == ["3", "6", "9"]
    assert 1 <= found["friction_passes"] <= 40
    assert "f = 0.1 in A, B, B0" in text(document, "friction")


def test_residuals_and_error_are_stated(pressed: Forces) -> None:
    found = values(forces_summary(pressed, "t"))
    assert 0 <= found["residual"]["equilibrium"] < 1e-12
    assert 0 <= found["residual"]["virtual_power"] < 1e-12
    assert 0 < found["error"]["reactions"] < 1e-10


def test_grades_are_notes(pressed: Forces) -> None:
    from tmmcalc.linkage.results import Grade

    graded = replace(pressed, grades=(Grade("warning", "group RRP(2,3)", "further solution"),))
    assert forces_summary(graded, "t").notes == ("warning: group RRP(2,3): further solution",)


def test_usual_columns_come_first(pressed: Forces) -> None:
    table = forces_document(pressed, "t").table
    assert table is not None
    assert table.headers[:7] == ["i", "phi[deg]", "M_drive[N*m]", "R_O[N]", "R_A[N]", "R_B[N]", "R_B0[N]"]
    assert sorted(table.headers[1:]) == sorted(column.header for column in columns(pressed))
    whole = forces_document(pressed, "t", everything=True).table
    assert whole is not None
    assert whole.headers[1:] == [column.header for column in columns(pressed)]


def test_the_table_is_that_of_the_textbook(pressed: Forces) -> None:
    rows = [k for k, label in enumerate(pressed.labels) if label in [str(i) for i in range(13)]]
    table = forces_document(pressed, "t", patterns=["M_drive", "N_B0", "M_fr_A"], rows=rows).table
    assert table is not None
    found = dict(zip(table.headers, table.columns, strict=True))
    assert found["i"] == [str(i) for i in range(13)]
    kept = [i for i in range(13) if i != 9]  # the case gives the other limit there
    for header, key in (("M_drive[N*m]", "M_bal"), ("N_B0[N]", "R30")):
        assert np.array(found[header])[kept] == pytest.approx(np.array(CASE[key])[kept], rel=1e-4, abs=1e-3)


def test_unknown_columns_are_refused(pressed: Forces) -> None:
    with pytest.raises(UsageError, match="R_Z"):
        forces_document(pressed, "t", patterns=["R_Z"])


def test_the_example_under_the_table_works(pressed: Forces) -> None:
    document = forces_document(pressed, "t", where="my.out/forces.csv")
    assert document.more.endswith("or see my.out/forces.csv")
    example = document.more.split("'")[1].split(",")
    table = forces_document(pressed, "t", patterns=example).table
    assert table is not None
    assert len(table.headers) > 3


@pytest.mark.parametrize("friction", [True, False])
def test_it_reads_well_in_80_columns(friction: bool) -> None:
    mechanism, loading, kinematics = press(friction)
    printed = list(lines(forces_document(solve_forces(mechanism, loading, kinematics), "Press: forces")))
    assert max(map(len, printed)) <= 80
    told = printed[: printed.index("", 3)]
    noise = [line for line in told if "e-1" in line and not line.startswith(("residuals", "error", " "))]
    assert not noise
    assert not any("nan" in line or "inf " in line for line in printed)


def test_noise_against_the_largest_is_zero() -> None:
    """A pair that only rounding loads."""
    result = solved(slider(), Loading(loads=(PUSH,)))
    pairs = tuple(replace(p, force=Extreme(1e-14, 0.0)) if p.joint == "B0" else p for p in result.pairs)
    assert text(forces_summary(replace(result, pairs=pairs), "t"), "reaction in B0 (0-3)").startswith("max 0 N")


def test_no_fact_is_lost_beside_other_stages(pressed: Forces) -> None:
    """In the document of a run a label that was said before is left out."""
    kinematics = press()[2]
    before = [*kinematics_summary(kinematics, "k").facts, *structure_document(kinematics.structure, "s").facts]
    own = [fact.label for fact in forces_summary(pressed, "f").facts]
    assert len(set(own)) == len(own)
    assert not {fact.label for fact in before} & set(own)


def test_passes_that_do_not_settle_or_have_no_solution() -> None:
    mechanism, loading, kinematics = press()
    statics = compile_statics(compile_scene(mechanism, loading, kinematics))
    found = textbook_iteration(statics, "RRP(2,3)", 1.0, most=2)
    document = iteration_document(found, "t", 0.03)
    assert "warning: the passes do not settle" in document.notes[0]
    assert document.table is not None
    assert document.table.columns[0] == ["1", "2", "solution"]
    locked = iteration_document(replace(found, exact=None, exact_friction=None), "t", 0.03)
    assert locked.table is not None
    assert locked.table.columns[0] == ["1", "2"]
    assert locked.table.columns[2] == ["", ""]
