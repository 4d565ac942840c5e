"""The document of the reduction stage, against the textbook's press and closed forms of a crank-slider."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from linkage.scenes import crank_slider, driven_rod, full_turn, with_input
from loaded import DEG, press

from tmmcalc.linkage.facts.forces import summary as forces_summary
from tmmcalc.linkage.facts.kinematics import summary as kinematics_summary
from tmmcalc.linkage.kinematics import solve_kinematics
from tmmcalc.linkage.loading import Body, Load, Loading, Spring
from tmmcalc.linkage.loadlaws.constant import Constant
from tmmcalc.linkage.loadlaws.viscous import Viscous
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.results import Grade
from tmmcalc.machine.facts.reduction import document as reduction_document
from tmmcalc.machine.facts.reduction import summary as reduction_summary
from tmmcalc.machine.reduction.results import Reduction
from tmmcalc.machine.reduction.solve import solve_reduction
from tmmcalc.report.document import Document
from tmmcalc.report.plaintext import lines

R, L = 0.1, 0.25
CASES = {c["id"]: c for c in json.loads((Path(__file__).parents[2] / "cases" / "dynamics.json").read_text())}


def solved(mechanism: Mechanism, loading: Loading) -> Reduction:
    return solve_reduction(mechanism, loading, solve_kinematics(mechanism))


def slider(speed: float = 2.0) -> Mechanism:
    return with_input(full_turn(crank_slider(R, L)), speed=speed)


def values(document: Document) -> dict[str, Any]:
    return {key: value for fact in document.facts for key, value in fact.values.items()}


def text(document: Document, label: str) -> str:
    (fact,) = [fact for fact in document.facts if fact.label == label]
    return fact.text


@pytest.fixture(scope="module")
def pressed() -> Reduction:
    return solve_reduction(*press())


def test_works_of_the_press(pressed: Reduction) -> None:
    """Textbook appendix 3: exact work, and Simpson's rule over 12 steps beside it."""
    case = CASES["dyn-press-reduced"]["expected"]
    document = reduction_summary(pressed, "t")
    found = values(document)
    assert found["work_Q3[J]"] == pytest.approx(case["A_C_exact"], abs=1e-4)
    assert found["work_Simpson_Q3[J]"] == pytest.approx(case["A_C_simpson12"], abs=1e-4)
    assert found["work_friction[J]"] == pytest.approx(case["A_F_fine"], abs=1e-3)
    assert found["work_Simpson_friction[J]"] == pytest.approx(case["A_F_simpson12"], rel=3e-3)
    off = 100 * (case["A_C_simpson12"] - case["A_C_exact"]) / case["A_C_exact"]
    assert found["work_Simpson_Q3_off[%]"] == pytest.approx(off, abs=1e-3)
    assert "by Simpson's rule -57.28592 J, 0.141 % too much" in text(document, "work of Q3")


def test_weights_do_no_work_and_get_no_percentage(pressed: Reduction) -> None:
    document = reduction_summary(pressed, "t")
    assert text(document, "work of weight").startswith("0 J a cycle")
    assert "%" not in text(document, "work of weight")
    assert "work_Simpson_weight_off[%]" not in values(document)


def test_sum_and_mean(pressed: Reduction) -> None:
    """P_W of the case is the mean power at 5 rad/s with Simpson's works, -(A_C + A_F) / T."""
    case = CASES["dyn-press-reduced"]["expected"]
    found = values(reduction_summary(pressed, "t"))
    work = case["A_C_exact"] + case["A_F_fine"]
    assert found["work[J]"] == pytest.approx(work, abs=2e-3)
    assert found["M_red_mean[N*m]"] == pytest.approx(work / (2 * np.pi), abs=1e-3)
    assert -found["P_red_mean[W]"] == pytest.approx(case["P_W"], rel=2e-3)


def test_extremes_of_a_constant_force() -> None:
    """M = F x'; against a clockwise speed the same values stand at negative angles."""
    loading = Loading(loads=(Load("Q3", 3, "force", Constant(200.0)),))
    phi = np.linspace(0, 2 * np.pi, 200_001)
    s = R * np.sin(phi)
    moment = 200.0 * (-s - s * R * np.cos(phi) / np.sqrt(L**2 - s**2))
    for speed in (2.0, -2.0):
        found = values(reduction_summary(solved(slider(speed), loading), "t"))
        assert found["M_red_min[N*m]"] == pytest.approx(moment.min(), rel=1e-9)
        assert found["M_red_max[N*m]"] == pytest.approx(moment.max(), rel=1e-9)
        least = phi[np.argmin(moment)] if speed > 0 else phi[np.argmin(moment)] - 2 * np.pi
        assert found["M_red_min_at_phi[deg]"] == pytest.approx(least / DEG, abs=1e-2)


def test_the_mean_moment_has_the_sign_of_its_columns() -> None:
    """A resistance takes power: against a positive speed its moment is negative, against a negative one positive."""
    loading = Loading(loads=(Load("Q3", 3, "force", Viscous(30.0)),))
    for speed in (2.0, -2.0):
        result = solved(slider(speed), loading)
        found = values(reduction_summary(result, "t"))
        nodes = result.total[:-1].mean()  # spectrally accurate over a turn
        assert found["M_red_mean[N*m]"] == pytest.approx(nodes, rel=1e-6)
        assert found["M_red_mean[N*m]"] * speed < 0
        assert found["P_red_mean[W]"] < 0


def test_each_contribution_has_its_extremes(pressed: Reduction) -> None:
    """The weight of the rod: M = -m g l_AS2' cos phi: its amplitude 12 g (1 - 55/168) 37.5 mm."""
    found = values(reduction_summary(pressed, "t"))
    amplitude = 12 * 9.81 * (1 - 55 / 168) * 0.0375
    assert found["M_red_weight_max[N*m]"] == pytest.approx(amplitude, rel=1e-9)
    assert found["M_red_weight_max_at_phi[deg]"] == pytest.approx(180.0, abs=1e-4)
    assert found["M_red_weight_min[N*m]"] == pytest.approx(-amplitude, rel=1e-9)


def test_one_contribution_is_not_told_twice() -> None:
    loading = Loading(loads=(Load("Q3", 3, "force", Constant(200.0)),))
    labels = [fact.label for fact in reduction_summary(solved(slider(), loading), "t").facts]
    assert "moment of Q3" not in labels
    assert "reduced moment" in labels


def test_inertia_and_its_lumping(pressed: Reduction) -> None:
    """dyn-reduced-inertia-press; the maximum from the closed form on a fine grid."""
    case = CASES["dyn-reduced-inertia-press"]["expected"]
    document = reduction_summary(pressed, "t")
    found = values(document)
    r, l2, l_s, phi = 0.0375, 0.168, 0.055, np.linspace(0, 2 * np.pi, 400_001)
    psi = -np.arcsin(r * np.sin(phi) / l2)
    turn = -r * np.cos(phi) / (l2 * np.cos(psi))
    x_s = -r * np.sin(phi) - l_s * np.sin(psi) * turn
    y_s = r * np.cos(phi) + l_s * np.cos(psi) * turn
    x_b = -r * np.sin(phi) - l2 * np.sin(psi) * turn
    inertia = 12 * (x_s**2 + y_s**2) + 0.055 * turn**2 + 24 * x_b**2
    assert found["J_red_max[kg*m^2]"] == pytest.approx(inertia.max(), rel=1e-9)
    assert found["J_red_min[kg*m^2]"] == pytest.approx(case["J_exact"][0], abs=1e-6)
    change = np.array(case["J_lumped"]) - np.array(case["J_exact"])
    assert found["lumping_J_red[kg*m^2]"] == pytest.approx(change.max(), abs=1e-6)
    assert found["lumping[%]"] == pytest.approx(100 * change.max() / np.ptp(inertia), abs=2e-3)
    assert found["lumped_rods"] == [2]
    assert "2.31 % of the variable part" in text(document, "static lumping of 2")


def test_lumping_is_said_in_summary_and_header(pressed: Reduction) -> None:
    mechanism, loading, kinematics = press()
    result = solve_reduction(mechanism, loading, kinematics, "lumped")
    exact, static = (reduction_document(found, "t", everything=True) for found in (pressed, result))
    assert (values(exact)["rods"], values(static)["rods"]) == ("exact", "lumped")
    assert text(static, "rods") == "2, as masses in their pins: statically lumped"
    assert values(static)["lumping_J_red[kg*m^2]"] == pytest.approx(values(exact)["lumping_J_red[kg*m^2]"], rel=1e-12)
    assert exact.table is not None
    assert static.table is not None
    one, other = (dict(zip(view.headers, view.columns, strict=True)) for view in (exact.table, static.table))
    assert one["J_red[kg*m^2]"] == other["J_exact[kg*m^2]"]
    assert one["J_lumped[kg*m^2]"] == other["J_red[kg*m^2]"]
    assert "J_exact[kg*m^2]" not in one


def test_lumping_that_changes_nothing_says_so() -> None:
    """A rod that is two masses in its pins already: its own moment of inertia is theirs, m_A a^2 + m_B b^2."""
    mechanism, loading, kinematics = press()
    rod = Body(2, 12.0, 12.0 * 0.055 * (0.168 - 0.055), 0.055 + 0j)
    bodies = tuple(rod if body.link == 2 else body for body in loading.bodies)
    result = solve_reduction(mechanism, replace(loading, bodies=bodies), kinematics)
    assert text(reduction_summary(result, "t"), "static lumping of 2") == "the same reduced inertia"


def test_masses_alone_have_neither_work_nor_rods() -> None:
    """A slider without gravity: nothing does work; J = m x'^2."""
    document = reduction_document(solved(slider(), Loading((Body(3, 24, 0, 0j),))), "t")
    found = values(document)
    assert not [fact for fact in document.facts if "lumping" in fact.label or fact.label.startswith("work of Q")]
    assert found["work[J]"] == found["M_red_mean[N*m]"] == 0.0
    assert found["J_red_min[kg*m^2]"] == pytest.approx(0.0, abs=1e-12)
    phi = np.linspace(0, np.pi, 200_001)
    s = R * np.sin(phi)
    rate = -s - s * R * np.cos(phi) / np.sqrt(L**2 - s**2)
    assert found["J_red_max[kg*m^2]"] == pytest.approx(24 * np.max(rate**2), rel=1e-9)


def test_a_constant_inertia_is_told_once() -> None:
    result = solved(slider(), Loading((Body(1, 2.0, 0.3, 0j),), -9.81j))
    assert text(reduction_summary(result, "t"), "reduced inertia") == "0.3 kg*m^2 everywhere"


def test_a_spring_and_its_damper_have_names_of_their_own() -> None:
    spring = Spring("k", "linear", (3, 0), (0j, 1 + 0j), 100.0, 0.2, 5.0)
    document = reduction_summary(solved(slider(), Loading(springs=(spring,))), "t")
    labels = [fact.label for fact in document.facts]
    assert {"work of k", "work of k (damping)"} <= set(labels)
    assert len(set(labels)) == len(labels)
    found = values(document)
    assert found["work_k_spring[J]"] == pytest.approx(0.0, abs=1e-12)
    assert found["work_k_damper[J]"] < 0


def test_a_driven_slider_is_told_in_newtons_and_kilograms() -> None:
    mechanism = driven_rod(1.0, 0.2, 0.5)
    document = reduction_document(solved(mechanism, Loading((Body(2, 3.0, 0.1, 0.2 + 0j),), -9.81j)), "t")
    found = values(document)
    assert {"F_red_min[N]", "m_red_max[kg]", "F_red_mean[N]", "speed[m/s]"} <= set(found)
    assert "over the range" in text(document, "work of weight")
    assert document.table is not None
    assert document.table.headers[1:3] == ["phi[m]", "F_red[N]"]


def test_the_table_is_that_of_the_textbook(pressed: Reduction) -> None:
    case = CASES["dyn-press-reduced"]["expected"]
    table = reduction_document(pressed, "t", patterns=["M_red_Q3", "M_red_weight"], rows=range(13)).table
    assert table is not None
    found = dict(zip(table.headers, table.columns, strict=True))
    assert found["M_red_Q3[N*m]"] == pytest.approx(case["M_C"], abs=1e-4)
    assert found["M_red_weight[N*m]"] == pytest.approx(case["M_G"], abs=1e-4)


def test_resolution_error_and_grades(pressed: Reduction) -> None:
    graded = replace(pressed, grades=(Grade("warning", "load Q3", "drives"),))
    document = reduction_summary(graded, "t")
    found = values(document)
    assert document.notes == ("warning: load Q3: drives",)
    assert found["panels"] == pressed.cycle.panels.count
    assert 0 < found["error"]["functions"] < 1e-9
    assert found["speed[rad/s]"] == 5.0


def test_it_reads_well_in_80_columns(pressed: Reduction) -> None:
    printed = list(lines(reduction_document(pressed, "Press: reduction", where="p.out/reduction.csv")))
    assert max(map(len, printed)) <= 80
    assert not [line for line in printed if "e-1" in line and not line.startswith("error")]
    assert "see p.out/reduction.csv" in " ".join(printed)


def test_no_fact_is_lost_beside_other_stages(pressed: Reduction) -> None:
    from tmmcalc.linkage.forces.solve import solve_forces

    mechanism, loading, kinematics = press()
    before = [
        *kinematics_summary(kinematics, "k").facts,
        *forces_summary(solve_forces(mechanism, loading, kinematics), "f").facts,
    ]
    assert not {fact.label for fact in before} & {fact.label for fact in reduction_summary(pressed, "r").facts}
