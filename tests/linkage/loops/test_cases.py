"""The worked cases of class III and IV groups: positions, rates, reactions, all assemblies, range of existence."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

import tmmcalc
from linkage.loops.worked import case, class_four, class_three, loading
from linkage.scenes import CONFIGS
from tmmcalc import Forces, Kinematics, Mechanism
from tmmcalc.linkage.listing import GroupAssembly

CLASS_FOUR = "A-C4-MECH-12"
CLASS_THREE = "A-C3-MECH-12"


def close(found: Any, expected: Any) -> None:
    assert found == pytest.approx(np.asarray(expected), rel=1e-6, abs=1e-6)


def turned(found: Any, expected: Any) -> None:
    """Angles that are equal but for whole turns."""
    assert np.angle(np.exp(1j * (np.asarray(found) - np.asarray(expected)))) == pytest.approx(0.0, abs=1e-6)


def check_motion(result: Kinematics, expected: dict[str, Any], links: tuple[int, ...]) -> None:
    for k in links:
        row = result.trace.link_ids.index(k)
        rates = result.in_time(result.trace.dangle[row], result.trace.ddangle[row])
        turned(result.trace.angle[row][:12], expected[f"phi{k}"])
        close(rates[0][:12], expected[f"omega{k}"])
        close(rates[1][:12], expected[f"eps{k}"])


def check_reaction(forces: Forces, name: str, sign: float, expected: dict[str, Any], key: str) -> None:
    row = [pair.joint for pair in forces.pairs].index(name)
    reaction = sign * forces.reaction[row][:12]
    close(reaction.real, expected[f"R_{key}_x"])
    close(reaction.imag, expected[f"R_{key}_y"])


def four() -> tuple[Mechanism, dict[str, Any], dict[str, Any]]:
    given, expected = case(CLASS_FOUR)
    near = given["assembly_at_first_position"]
    a, f = complex(given["l_O1A"]), complex(*given["F"])
    sketch = {
        "C": complex(a + given["link2"]["l_AC"] * np.exp(1j * near["phi2_approx"])),
        "B": complex(f + given["link5"]["l_FB"] * np.exp(1j * near["phi5_approx"])),
    }
    return class_four(given, given["l_O1A"], f, sketch=sketch), given, expected


def three() -> tuple[Mechanism, dict[str, Any], dict[str, Any]]:
    given, expected = case(CLASS_THREE)
    p1, own = complex(*given["initial_mode"]["P1_approx"]), complex(*given["platform_local"]["P2"])
    turn = np.exp(1j * given["initial_mode"]["theta3_approx"])
    return class_three(given, given["l_O1A"], sketch={"P1": p1, "P2": complex(p1 + own * turn)}), given, expected


def test_class_four_motion_and_reactions() -> None:
    mechanism, given, expected = four()
    check_motion(tmmcalc.solve_kinematics(mechanism), expected, (2, 3, 4, 5))
    forces = tmmcalc.solve_forces(mechanism, loading(given, mechanism, {}))
    close(forces.drive[:12], expected["M_bal"])
    pairs = {"O": "O1_ground_on_1", "A": "A_1_on_2", "C": "C_2_on_3", "D": "D_2_on_4", "F": "F_ground_on_5"}
    for name, key in pairs.items():
        check_reaction(forces, name, 1.0, expected, key)
    for name, key in {"B": "B_5_on_3", "E": "E_5_on_4"}.items():
        check_reaction(forces, name, -1.0, expected, key)
    assert np.max(np.abs(forces.virtual)) < 1e-12


def test_class_three_motion_and_reactions() -> None:
    mechanism, given, expected = three()
    result = tmmcalc.solve_kinematics(mechanism)
    p1 = result.trace.r[result.trace.point_names.index("P1")][:12]
    close(p1.real, expected["P1_x"])
    close(p1.imag, expected["P1_y"])
    plate = result.trace.link_ids.index(3)
    turned(result.trace.angle[plate][:12], expected["theta3"])
    check_motion(result, {**expected, "phi3": expected["theta3"], "eps3": expected["eps3"]}, (2, 3, 4, 5))
    forces = tmmcalc.solve_forces(mechanism, loading(given, mechanism, {3: ("P1", "P2", "P3")}))
    close(forces.drive[:12], expected["M_bal"])
    for name, key in {"O": "O1_ground_on_1", "A": "A_1_on_2", "Q2": "Q2_ground_on_4", "Q3": "Q3_ground_on_5"}.items():
        check_reaction(forces, name, 1.0, expected, key)
    for name, key in {"P2": "P2_3_on_4", "P3": "P3_3_on_5"}.items():
        check_reaction(forces, name, 1.0, expected, key)
    check_reaction(forces, "P1", -1.0, expected, "P1_3_on_2")


@pytest.mark.parametrize("name", ["class-four", "class-three"])
def test_ready_specs_are_the_worked_cases(name: str) -> None:
    """Up to the last printed digit of their points."""
    mechanism = (four if name == "class-four" else three)()[0]
    ready = tmmcalc.solve_kinematics(tmmcalc.load_spec(CONFIGS / f"{name}.toml"))
    exact = tmmcalc.solve_kinematics(mechanism)
    assert ready.trace.dangle == pytest.approx(exact.trace.dangle, abs=1e-5)


def listed(mechanism: Mechanism) -> tuple[GroupAssembly, ...]:
    return tmmcalc.list_assemblies(mechanism).assemblies


def test_class_four_assemblies() -> None:
    """The crank stands so that A is the origin of the case."""
    given, expected = case("A-C4-MODES")
    mechanism = class_four(given, 1.0, complex(*given["F"]) + 1)
    found = []
    for one in listed(mechanism):
        c, b = one.points["C"] - 1, one.points["B"] - 1 - complex(*given["F"])
        found.append((float(np.angle(c)), float(np.angle(b)), one))
    assert len(found) == expected["number"]
    for (phi2, phi5, one), solution in zip(sorted(found, key=lambda row: row[0]), expected["solutions"], strict=True):
        assert (phi2, phi5) == pytest.approx((solution["phi2"], solution["phi5"]), abs=1e-7)
        c, d, b, e = (one.points[name] for name in "CDBE")
        a, f = 1 + 0j, complex(*given["F"]) + 1
        rows = [[turn(c - b, c - a), -turn(c - b, b - f)], [turn(d - e, d - a), -turn(d - e, e - f)]]
        assert np.linalg.det(rows) == pytest.approx(solution["detJ"], rel=1e-6)


def turn(along: complex, arm: complex) -> float:
    """Derivative of |along|^2 by the angle of an arm that carries its end."""
    return 2 * (np.conj(along) * 1j * arm).real


def test_class_three_assemblies() -> None:
    given, expected = case("A-C3-MODES")
    moved = {**given, "Q2": [given["Q2"][0] + 1, given["Q2"][1]], "Q3": [given["Q3"][0] + 1, given["Q3"][1]]}
    found = []
    for one in listed(class_three(moved, 1.0)):
        theta = float(np.angle((one.points["P2"] - one.points["P1"]) / complex(*given["platform_local"]["P2"])))
        found.append((theta, one.points["P1"] - 1))
    assert len(found) == expected["number"]
    for (theta, p1), solution in zip(sorted(found, key=lambda row: row[0]), expected["solutions"], strict=True):
        assert theta == pytest.approx(solution["theta"], abs=1e-7)
        assert (p1.real, p1.imag) == pytest.approx(solution["P1"], abs=1e-7)


def test_range_of_existence() -> None:
    """A hair inside there are the two assemblies, a hair outside there is none."""
    given, expected = case("A-C4-RANGE")
    for edge, inwards in ((expected["AF_min"], 1), (expected["AF_max"], -1)):
        for hair, number in ((1e-6, expected["number_of_assemblies_inside"]), (-1e-6, 0)):
            mechanism = class_four(given, 0.1, 0.1 + edge + inwards * hair)
            assert len(listed(mechanism)) == number
    assert number == expected["number_of_assemblies_outside"]
    middle = class_four(given, 0.1, 1.3)
    assert len(listed(replace(middle, input=replace(middle.input, start=2.0)))) == 2
