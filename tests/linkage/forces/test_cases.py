"""Worked cases of the force analysis, with their own tolerances."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from linkage.forces.worked import CASES, DEGREE, press, press_loading
from linkage.scenes import bar, crank_slider, four_bar, full_turn, pin, slide, with_input
from tmmcalc import SingularityError, solve_kinematics
from tmmcalc.linkage.forces.drive import Driven, crank, mesh_force
from tmmcalc.linkage.forces.dyad import DyadEquilibrium, Three
from tmmcalc.linkage.forces.iteration import textbook_iteration
from tmmcalc.linkage.forces.kinetostatics import compile_statics
from tmmcalc.linkage.forces.results import Forces
from tmmcalc.linkage.forces.solve import solve_forces
from tmmcalc.linkage.forces.wrench import Pivot, Plan, Seat, Slideway, Wrench
from tmmcalc.linkage.loading import Body, Coupling, GearDrive, Load, Loading
from tmmcalc.linkage.loadlaws.constant import Constant
from tmmcalc.linkage.loads.scene import compile_scene
from tmmcalc.linkage.model import Assembly, Input, Link, Mechanism, Output
from tmmcalc.linkage.structure import Group

TURN = 2 * np.pi
Array = NDArray[Any]


def polar(length: float, angle: float) -> complex:
    return complex(length * np.exp(1j * angle))


def like(case: str, key: str, found: Any, rows: Any = slice(None)) -> None:
    """The value agrees with the case within the case's own tolerance."""
    expected, tolerance = CASES[case]["expected"][key], CASES[case]["tolerance"]
    expected = np.asarray(expected)[rows] if np.ndim(expected) else expected
    if key.startswith("gamma"):
        expected, found = np.exp(1j * np.asarray(expected)), np.exp(1j * np.asarray(found))
    # a fact printed with six digits is good to half a unit of the last
    rtol = max(tolerance.get("rel", 0.0), 5e-6 if case.startswith("dyn") else 0.0)
    np.testing.assert_allclose(found, expected, rtol=rtol, atol=tolerance.get("abs", 1e-9), err_msg=f"{case} {key}")


def row(result: Forces, label: str) -> int:
    return result.labels.index(label)


def pairs(result: Forces) -> dict[str, int]:
    return {pair.joint: j for j, pair in enumerate(result.pairs)}


@cache
def pressed(friction: float) -> Forces:
    mechanism, kinematics = press()
    return solve_forces(mechanism, press_loading(friction), kinematics)


class TestPressIdeal:
    """dyn-press-ideal: the table of appendix 3 without friction."""

    case = "dyn-press-ideal"

    def test_reactions(self) -> None:
        result = pressed(0.0)
        at, r = pairs(result), result.reaction
        rod = press()[1].trace.angle[1]
        like(self.case, "R21T", (np.conj(1j * np.exp(1j * rod)) * r[at["A"]]).real)
        like(self.case, "R21N", (np.conj(np.exp(1j * rod)) * r[at["A"]]).real)
        like(self.case, "R30", r[at["B0"]].imag)
        like(self.case, "R30", result.normal[at["B0"]])
        like(self.case, "R32x", r[at["B"]].real)
        like(self.case, "R32y", r[at["B"]].imag)

    def test_drive(self) -> None:
        result = pressed(0.0)
        like(self.case, "M_bal", result.drive)
        size = max(abs(extreme.value) for extreme in result.drive_extremes)
        like(self.case, "M_bal_virtual_power", result.drive + size * result.virtual)

    def test_no_position_has_two_rows_without_friction(self) -> None:
        assert pressed(0.0).labels == tuple(str(i) for i in range(13))


class TestPressFriction:
    """dyn-press-friction: friction in three pairs, both limits where it jumps."""

    case = "dyn-press-friction"

    @property
    def rows(self) -> Array:
        """The book takes the limit before position 9, the limits after all others."""
        return np.array([row(pressed(0.1), "9-" if i == 9 else str(i)) for i in range(13)])

    def test_two_rows_where_friction_jumps(self) -> None:
        """The rod turns back at 3 and 9, the slider at 0, 6 and 12."""
        doubled = [label for label in pressed(0.1).labels if label.endswith("-")]
        assert doubled == ["3-", "6-", "9-"]
        assert np.all(np.diff(pressed(0.1).theta)[[row(pressed(0.1), label) for label in doubled]] == 0)

    def test_friction(self) -> None:
        at, f = pairs(pressed(0.1)), pressed(0.1).friction[:, self.rows]
        like(self.case, "M21", f[at["A"]])
        like(self.case, "M23", -f[at["B"]])
        like(self.case, "F30", f[at["B0"]])

    def test_reactions(self) -> None:
        at, r = pairs(pressed(0.1)), pressed(0.1).reaction[:, self.rows]
        rod = press()[1].trace.angle[1]
        like(self.case, "R21T", (np.conj(1j * np.exp(1j * rod)) * r[at["A"]]).real)
        like(self.case, "R21N", (np.conj(np.exp(1j * rod)) * r[at["A"]]).real)
        like(self.case, "R30", pressed(0.1).normal[at["B0"], self.rows])
        like(self.case, "h_mm", 1e3 * (pressed(0.1).couple / pressed(0.1).normal)[at["B0"], self.rows])
        like(self.case, "R32x", r[at["B"]].real)
        like(self.case, "R32y", r[at["B"]].imag)
        like(self.case, "R10x", r[at["O"]].real)
        like(self.case, "R10y", r[at["O"]].imag)
        like(self.case, "M_bal", pressed(0.1).drive[self.rows])

    def test_the_other_limit_at_270_degrees(self) -> None:
        other, at, k = (
            CASES[self.case]["expected"]["alternative_side_at_i9"],
            pairs(pressed(0.1)),
            row(pressed(0.1), "9"),
        )
        rod = press()[1].trace.angle[1][9]
        force = pressed(0.1).reaction[at["A"], k] * np.exp(-1j * rod)
        found = {
            "M21": pressed(0.1).friction[at["A"], k],
            "M23": -pressed(0.1).friction[at["B"], k],
            "F30": pressed(0.1).friction[at["B0"], k],
            "R21T": force.imag,
            "R21N": force.real,
            "R30": pressed(0.1).normal[at["B0"], k],
        }
        for key, value in found.items():
            assert value == pytest.approx(other[key], rel=1e-5), key

    @pytest.mark.parametrize(("position", "side"), [(1, 1.0), (9, -1.0)])
    def test_the_history_of_the_plain_iteration(self, position: int, side: float) -> None:
        """dyn-press-friction-iterations: table D.3.3."""
        case = CASES["dyn-press-friction-iterations"]["expected"]
        mechanism, kinematics = press()
        statics = compile_statics(compile_scene(mechanism, press_loading(), kinematics))
        history = textbook_iteration(statics, "RRP(2,3)", position * np.pi / 6, side)
        assert history.joints == ("A", "B", "B0")
        assert history.units == ("N*m", "N*m", "N")
        np.testing.assert_allclose(history.friction, case[f"position_{position}"], rtol=1e-5)
        assert history.passes == case["iterations_to_stop"][f"position_{position}"]
        assert history.stopped


class TestFourBar:
    """dyn-fourbar-forces."""

    case = "dyn-fourbar-forces"
    inputs = CASES[case]["inputs"]
    mechanism = with_input(full_turn(four_bar(0.1, 0.35, 0.25, 0.38 + 0.05j), 0.0, 6), speed=12.0)
    loading = Loading(
        bodies=(Body(2, 4.0, 0.05, 0.15 + 0j), Body(3, 3.0, 0.02, 0.12 + 0j)),
        gravity=-9.81j,
        loads=(Load("M", 3, "moment", Constant(-40.0)),),
    )

    def result(self) -> Forces:
        kinematics = solve_kinematics(self.mechanism)
        k = kinematics.trace.link_ids.index(2)
        like(self.case, "phi2_deg", np.degrees(kinematics.trace.angle[k][:6]))  # the same assembly
        return solve_forces(self.mechanism, self.loading, kinematics)

    def test_everything(self) -> None:
        result = self.result()
        at, r = pairs(result), result.reaction[:, :6]
        for key, joint, sign in (("R21", "A", 1), ("R32", "B", 1), ("R30", "C", 1), ("R10", "O", 1)):
            like(self.case, f"{key}x", sign * r[at[joint]].real)
            like(self.case, f"{key}y", sign * r[at[joint]].imag)
        like(self.case, "M_bal", result.drive[:6])


def test_gear_driven_crank() -> None:
    """dyn-gear-driven-crank."""
    given, case = CASES["dyn-gear-driven-crank"]["inputs"], "dyn-gear-driven-crank"
    gear = GearDrive(given["pitch_radius"], given["pressure_angle_deg"] * DEGREE, -90 * DEGREE)
    force, at = complex(given["R12x"], given["R12y"]), complex(given["A_x"], given["A_y"])
    driven = at_pivot([(force, at)], 0.0, gear)
    like(case, "M_bal", driven.drive[0])
    like(case, "F_bal", abs(driven.mesh[0]))
    like(case, "R_bal_x", driven.mesh[0].real)
    like(case, "R_bal_y", driven.mesh[0].imag)
    like(case, "R10x", driven.frame.force[0].real)
    like(case, "R10y", driven.frame.force[0].imag)


def test_gear_driven_press() -> None:
    """The same through the whole stage: position 10 of the press, the gear below the crank."""
    mechanism, kinematics = press()
    loading = press_loading(0.0)
    gear = GearDrive(0.12, 20 * DEGREE, -90 * DEGREE)
    result = solve_forces(mechanism, Loading(loading.bodies, loading.gravity, loading.loads, drive=gear), kinematics)
    like("dyn-gear-driven-crank", "R_bal_x", result.mesh[10].real)
    like("dyn-gear-driven-crank", "R10y", result.reaction[pairs(result)["O"], 10].imag)
    assert result.drive_kind == "gear"


def at_pivot(forces: list[tuple[complex, complex]], moment: float, drive: Coupling | GearDrive) -> Driven:
    """The crank under forces at places counted from its pivot."""
    total = np.array([sum(force for force, _ in forces)])
    about = np.array([moment + sum((place.conjugate() * force).imag for force, place in forces)])
    return crank(Wrench(total, about), drive, np.zeros(()))


def crank_case(case: str) -> tuple[dict[str, Any], list[tuple[complex, complex]]]:
    given = CASES[case]["inputs"]
    return given, [
        (polar(given["F1"], given["gamma1"]), polar(given["l_O1S1"], given["phi1"])),
        (polar(given["R21"], given["gamma21"]), polar(given["l_O1A"], given["phi1"])),
    ]


@pytest.mark.parametrize("case", ["F-WL1-01", "F-WL1-02", "F-WL1-03"])
def test_crank_with_a_gear(case: str) -> None:
    given, forces = crank_case(case)
    gear = GearDrive(given["r_w"], given["alpha_w"], given["pinion_direction_beta"])
    driven = at_pivot(forces, given["M1"], gear)
    like(case, "F_bal", abs(driven.mesh[0]))
    like(case, "gamma_bal", np.angle(driven.mesh[0]))
    like(case, "RO1", abs(driven.frame.force[0]))
    like(case, "gammaO1", np.angle(driven.frame.force[0]))
    if "M_bal" in CASES[case]["expected"]:
        like(case, "M_bal", driven.drive[0])
    np.testing.assert_allclose(mesh_force(gear, driven.drive), driven.mesh)


def test_crank_with_a_coupling() -> None:
    given, forces = crank_case("F-WL2-01")
    driven = at_pivot(forces, given["M1"], Coupling())
    like("F-WL2-01", "M_bal", driven.drive[0])
    like("F-WL2-01", "RO1", abs(driven.frame.force[0]))
    like("F-WL2-01", "gammaO1", np.angle(driven.frame.force[0]))


def one(z: Any) -> complex:
    return complex(np.ravel(z)[0])


def load(force: complex, moment: float, arm: complex) -> Wrench:
    """A force at the vector ``arm`` from the inner joint's point and a moment, about that point."""
    return Wrench(np.array([force]), np.array([moment + (arm.conjugate() * force).imag]))


def reactions(kind: str, on_a: Wrench, on_b: Wrench, *seats: Seat) -> Three:
    """Of a dyad of links 2 and 3 without friction, loads about the inner joint's point."""
    plan = Plan(Group((2, 3), kind, 2, 2, ("B",), ("A", "C"), (0, 1)), ())
    first, second, third = DyadEquilibrium(plan, (seats[0], seats[1], seats[2]), (on_a, on_b), {}).solve(1).reactions
    return first, second, third


@pytest.mark.parametrize("case", ["F-SR1-01", "F-SR1-02"])
def test_rrr_dyad(case: str) -> None:
    g = CASES[case]["inputs"]
    a, c = -polar(g["l_BA"], g["phi2"]), -polar(g["l_BC"], g["phi3"])
    found = rrr(g, a, c)
    on_2, on_3, by_2 = one(found[0].force), one(found[2].force), -one(found[1].force)
    for key, force, phi in (("R12", on_2, g["phi2"]), ("R43", on_3, g["phi3"])):
        own = force * np.exp(-1j * phi)
        like(case, f"{key}_n", own.real)
        like(case, f"{key}_tau", own.imag)
        like(case, key, abs(force))
        like(case, f"gamma{key[1:]}", np.angle(force))
    like(case, "R23", abs(by_2))
    like(case, "gamma23", np.angle(by_2))


def rrr(g: dict[str, Any], a: complex, c: complex) -> Three:
    on_a = load(polar(g["F2"], g["gamma2"]), g["M2"], -polar(g["l_BS2"], g["phi2"]))
    on_b = load(polar(g["F3"], g["gamma3"]), g["M3"], -polar(g["l_BS3"], g["phi3"]))
    return reactions("RRR", on_a, on_b, Pivot(np.array([a])), Pivot(np.array([0j])), Pivot(np.array([c])))


def test_rrr_dyad_at_its_dead_point() -> None:
    """It transmits no force, so a motion through it is refused before forces are sought."""
    g = CASES["F-SR1-03"]["inputs"]
    with np.errstate(invalid="ignore"):
        at_rest = rrr(g, -polar(g["l_BA"], g["phi2"]), -polar(g["l_BC"], g["phi3"]))
    assert not np.abs(at_rest[1].force[0]) < 1e15 * g["F2"]
    with pytest.raises(SingularityError, match="dead point") as raised:
        solve_kinematics(four_bar(g["l_BC"], g["l_BA"], g["l_BC"], g["l_BA"]))
    assert raised.value.exit_code == 3
    assert raised.value.value < raised.value.limit


@pytest.mark.parametrize("case", ["F-SR2-01", "F-SR2-02"])
def test_rrp_dyad(case: str) -> None:
    g = CASES[case]["inputs"]
    on_2 = load(polar(g["F2"], g["gamma2"]), g["M2"], -polar(g["l_BS2"], g["phi2"]))
    found, e = rrp(g, on_2, load(polar(g["F3"], g["gamma3"]), 0.0, 0j))
    force = one(found[0].force)
    own = force * np.exp(-1j * g["phi2"])
    normal = (np.conj(1j * e) * one(found[2].force)).real
    like(case, "R12_n", own.real)
    like(case, "R12_tau", own.imag)
    like(case, "R12", abs(force))
    like(case, "gamma12", np.angle(force))
    like(case, "R43_signed", normal)
    like(case, "gamma43", np.angle(one(found[2].force)))
    like(case, "R23", abs(one(found[1].force)))
    like(case, "gamma23", np.angle(-one(found[1].force)))
    assert abs(one(found[2].moment)) < 1e-9  # the line of action passes through B


def rrp(g: dict[str, Any], on_2: Wrench, on_3: Wrench) -> tuple[Three, complex]:
    e = polar(1, g["phi4"])
    a = -polar(g["l_BA"], g["phi2"])
    guide = Slideway(np.array([0j]), np.array([e]))
    return reactions("RRP", on_2, on_3, Pivot(np.array([a])), Pivot(np.array([0j])), guide), e


def test_rrp_dyad_with_everything_off_its_axes() -> None:
    case = "F-SR2-03"
    g = CASES[case]["inputs"]
    on_2 = load(complex(*g["F2_xy"]), g["M2"], complex(*g["r_BS2"]))
    found, e = rrp(g, on_2, load(complex(*g["F3_xy"]), g["M3"], complex(*g["r_BS3"])))
    normal, couple = (np.conj(1j * e) * one(found[2].force)).real, one(found[2].moment).real
    like(case, "R12_xy", [one(found[0].force).real, one(found[0].force).imag])
    like(case, "R43_signed", normal)
    like(case, "R23_xy", [-one(found[1].force).real, -one(found[1].force).imag])
    like(case, "M43_couple_about_B", couple)
    like(case, "h43_along_guide_from_B", couple / normal)


@pytest.mark.parametrize("case", ["F-SR3-01", "F-SR3-02", "F-SR3-03"])
def test_rpr_dyad(case: str) -> None:
    """A piston rod and a cylinder; the couple of the slide is told about A even where no force goes with it."""
    g = CASES[case]["inputs"]
    e = polar(1, g["phi2"])
    length = g["l_AB"] - g["l_BC"] + g["l_EC"]
    a, hinge = 0j, length * e
    slot = Slideway(np.array([a]), np.array([e]))
    on_3 = load(polar(g["F3"], g["gamma3"]), g["M3"], hinge - g["l_ES3"] * e)
    on_2 = load(polar(g["F2"], g["gamma2"]), g["M2"], g["l_AS2"] * e)
    found = reactions("RPR", on_2, on_3, Pivot(np.array([a])), slot, Pivot(np.array([hinge])))
    force, by_3 = one(found[0].force), one(found[1].force)
    own, normal = force / e, (np.conj(1j * e) * by_3).real
    like(case, "l_EA", length)
    like(case, "R12_tau", own.imag)
    like(case, "R12_n", own.real)
    like(case, "R12", abs(force))
    like(case, "gamma12", np.angle(force))
    like(case, "R32_signed", normal)
    like(case, "R43", abs(one(found[2].force)))
    like(case, "M32_couple_about_A", one(found[1].moment).real)
    if CASES[case]["expected"]["h32"] is not None:
        like(case, "gamma32", np.angle(by_3))
        like(case, "gamma43", np.angle(one(found[2].force)))
        like(case, "h32", one(found[1].moment).real / normal)


def check_group(case: str, result: Forces, on_higher: dict[str, str]) -> None:
    """Sizes and directions of reactions: case key -> joint; all act on the higher-numbered link."""
    at = pairs(result)
    for key, joint in on_higher.items():
        force = result.reaction[at[joint], :12]
        like(case, key, np.abs(force))
        letter = "gamma" + key[1:]
        if letter in CASES[case]["expected"]:
            like(case, letter, np.angle(force))


class TestFourBarOfTwelvePositions:
    """F-MECH-4BAR-12."""

    case = "F-MECH-4BAR-12"
    mechanism = with_input(full_turn(four_bar(0.1, 0.3, 0.25, 0.32 - 0.05j), 0.0, 12), speed=15.0)
    loading = Loading(
        bodies=(Body(1, 2.0, 0.01, 0.03 + 0j), Body(2, 3.0, 0.03, 0.15 + 0j), Body(3, 2.5, 0.02, 0.12 + 0j)),
        gravity=-9.81j,
        loads=(Load("M", 3, "moment", Constant(-50.0)),),
    )

    def forces(self, drive: Coupling | GearDrive) -> Forces:
        loading = self.loading
        loading = Loading(loading.bodies, loading.gravity, loading.loads, drive=drive)
        return solve_forces(self.mechanism, loading, solve_kinematics(self.mechanism))

    def test_coupling(self) -> None:
        result = self.forces(Coupling())
        check_group(self.case, result, {"R12": "A", "R23": "B"})
        ground = result.reaction[pairs(result)["C"], :12]
        like(self.case, "R43", np.abs(ground))
        like(self.case, "gamma43", np.angle(ground))
        like(self.case, "M_bal", result.drive[:12])
        bearing = result.reaction[pairs(result)["O"], :12]
        like(self.case, "RO1_coupling", np.abs(bearing))
        like(self.case, "gammaO1_coupling", np.angle(bearing))

    def test_gear(self) -> None:
        result = self.forces(GearDrive(0.12, 20 * DEGREE, np.pi))
        like(self.case, "F_bal_gear", np.abs(result.mesh[:12]))
        like(self.case, "gamma_bal_gear", np.angle(result.mesh[:12]))
        bearing = result.reaction[pairs(result)["O"], :12]
        like(self.case, "RO1_gear", np.abs(bearing))
        like(self.case, "gammaO1_gear", np.angle(bearing))


def test_offset_slider_crank_of_twelve_positions() -> None:
    """F-MECH-SC-12."""
    case = "F-MECH-SC-12"
    mechanism = with_input(full_turn(crank_slider(0.06, 0.24, 0.015), 0.0, 12), speed=100.0)
    loading = Loading(
        bodies=(Body(1, 1.2, 0.004, 0j), Body(2, 1.5, 0.008, 0.08 + 0j), Body(3, 2.0, 0.001, 0j)),
        gravity=-9.81j,
        loads=(Load("Q", 3, "force", Constant(-1500.0)),),
    )
    result = solve_forces(mechanism, loading, solve_kinematics(mechanism))
    check_group(case, result, {"R12": "A", "R23": "B", "RO1": "O"})
    like(case, "gammaO1", np.angle(result.reaction[pairs(result)["O"], :12]))
    like(case, "R43_signed", result.normal[pairs(result)["B0"], :12])
    like(case, "M_bal", result.drive[:12])


def cylinder() -> Mechanism:
    """Crank OA, rod 2 with its piston in cylinder 3, which turns about E."""
    g = CASES["F-MECH-CYL-12"]["inputs"]
    e = complex(*g["E"])
    mechanism = Mechanism(
        Link(0, {"O": 0j, "E": e}),
        (bar(1, O=0, A=g["l_O1A"]), bar(2, A=0, B=g["l_AB"]), bar(3, E=0)),
        (pin("O", 0, 1), pin("A", 1, 2, g["l_O1A"]), slide("B", 2, 3, 0, 0, g["l_AB"]), pin("E", 0, 3, e)),
        Input("O", g["omega1"], start=0.0),
        (Output(link=3),),
        assembly=Assembly(variants={(2, 3): -1}),
    )
    return full_turn(mechanism, 0.0, 12)


def test_oscillating_cylinder_of_twelve_positions() -> None:
    """F-MECH-CYL-12: the pressure acts between rod and cylinder, along the rod."""
    case = "F-MECH-CYL-12"
    g, mechanism = CASES[case]["inputs"], cylinder()
    kinematics = solve_kinematics(mechanism)
    # axes of links 2 and 3 lie along A -> E
    loading = Loading(
        bodies=(Body(1, 3.0, 0.01, 0.02 + 0j), Body(2, 2.0, 0.02, 0.12 + 0j), Body(3, 4.0, 0.05, -0.14 + 0j)),
        gravity=-9.81j,
        loads=(Load("p", 2, "force", Constant(-g["pressure_force"]), 0j, 1 + 0j, follows=2, against=3),),
    )
    like(case, "phi2", kinematics.trace.angle[kinematics.trace.link_ids.index(2)][:12])
    result = solve_forces(mechanism, loading, kinematics)
    at, u = pairs(result), np.exp(1j * kinematics.trace.angle[1][:12])
    check_group(case, result, {"R12": "A", "RO1": "O"})
    like(case, "gammaO1", np.angle(result.reaction[at["O"], :12]))
    ground = result.reaction[at["E"], :12]
    like(case, "R43", np.abs(ground))
    like(case, "gamma43", np.angle(ground))
    # on 2 by 3; the slide's reaction is told about the piston B, the case about A
    normal = -(np.conj(1j * u) * result.reaction[at["B"], :12]).real
    couple = -result.couple[at["B"], :12] + normal * g["l_AB"]
    like(case, "R32_signed", normal)
    like(case, "M32_couple_about_A", couple)
    like(case, "h32", couple / normal)
    like(case, "M_bal", result.drive[:12])


def test_no_case_of_forces_is_forgotten() -> None:
    """Every verified case of the two files that speaks of forces is named in this file or beside it."""
    here = Path(__file__).parent
    beside = (here / "test_friction.py", here.parents[1] / "machine" / "reduction" / "test_cases.py")
    told = "".join(file.read_text() for file in (Path(__file__), *beside))
    forces = ("press-ideal", "press-friction", "press-friction-iterations", "press-reduced", "vengine-table31")
    others = ("shaper-reduced", "fourbar-forces", "friction-extreme", "reduced-inertia-press", "gear-driven-crank")
    wanted = [name for name in CASES if name.startswith("F-")] + [f"dyn-{name}" for name in (*forces, *others)]
    assert len(wanted) == 16 + 10
    assert [name for name in wanted if name not in told] == []
