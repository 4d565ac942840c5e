"""The documents and pictures of balancing, against the worked case, closed forms and brute force over a turn."""

from __future__ import annotations

import io
import json
import math
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from linkage.scenes import crank_slider, four_bar, full_turn, with_input, yoke
from paper import curves, written

from tmmcalc.core.errors import UsageError
from tmmcalc.linkage.chain import compile_chain
from tmmcalc.linkage.kinematics import solve_kinematics
from tmmcalc.linkage.loading import Body
from tmmcalc.linkage.model import Mechanism
from tmmcalc.machine.balance.arrangements import Gear, in_line, vee
from tmmcalc.machine.balance.enginetask import solve_engine
from tmmcalc.machine.balance.redistribution import Place
from tmmcalc.machine.balance.rotors import Rotor, Unbalance
from tmmcalc.machine.balance.rotortask import solve_rotor
from tmmcalc.machine.balance.schemes import RotatingWeight
from tmmcalc.machine.balance.shaking import inertia_loads
from tmmcalc.machine.balance.solve import BalanceTask, Balancing, solve_balance
from tmmcalc.machine.facts.balance import document as balance_document
from tmmcalc.machine.facts.balance import summary as balance_summary
from tmmcalc.machine.model import EngineTask, RotorTask
from tmmcalc.machine.stages.balance import Balances
from tmmcalc.report.document import Document
from tmmcalc.report.drawing.pens import CURVES
from tmmcalc.report.drawing.shapes import Area
from tmmcalc.report.plaintext import lines
from tmmcalc.report.render import render

CASES = {c["id"]: c for c in json.loads((Path(__file__).parents[2] / "cases" / "dynamics.json").read_text())}
TURN = 2 * math.pi
R, L, AS, M2, M3 = 0.0375, 0.168, 0.055, 12.0, 24.0  # the press of the textbook
ROTATING, RECIPROCATING = M2 * (1 - AS / L), M3 + M2 * AS / L
PRESS = (Body(2, M2, 0.055, AS + 0j), Body(3, M3, 0.0, 0j))


def values(document: Document) -> dict[str, Any]:
    return {key: value for fact in document.facts for key, value in fact.values.items()}


def text(document: Document, label: str) -> str:
    (fact,) = [fact for fact in document.facts if fact.label == label]
    return fact.text


def column(document: Document, header: str) -> list[Any]:
    assert document.table is not None
    return list(document.table.columns[list(document.table.headers).index(header)])


def printed(document: Document, form: Any) -> str:
    stream = io.StringIO()
    render(document, form, stream)
    return stream.getvalue()


def balanced(mechanism: Mechanism, bodies: tuple[Body, ...], **task: Any) -> Balancing:
    return solve_balance(mechanism, bodies, solve_kinematics(mechanism), BalanceTask(**task))


def press(speed: float = 5.0, start: float = 0.0, **task: Any) -> Balances:
    mechanism = with_input(full_turn(crank_slider(R, L)), speed=speed, start=start)
    return Balances(balanced(mechanism, PRESS, **task), None, None)


def shaken(phi: Any, speed: float = 5.0) -> Any:
    """Shaking force of the press: a mass at the crank pin, one on the slider's line."""
    s = R * np.sin(phi)
    q = np.sqrt(L**2 - s**2)
    # second derivative of R cos(phi) + q
    first = -s * R * np.cos(phi) / q
    second = (s**2 - (R * np.cos(phi)) ** 2 - first**2) / q
    return speed**2 * (ROTATING * R * np.exp(1j * phi) + RECIPROCATING * (R * np.cos(phi) - second))


PHI = np.arange(100_000) * (TURN / 100_000)


def test_the_press_of_the_worked_case() -> None:
    case = CASES["dyn-balance-press"]["expected"]
    document = balance_summary(press(), "t")
    found = values(document)
    assert found["X0[N]"] == pytest.approx(case["centroid_X1"], rel=1e-5)
    assert found["Y0[N]"] == pytest.approx(0.0, abs=1e-9)
    assert found["R_rms[N]"] == pytest.approx(case["rms_before"], rel=1e-5)
    assert found["R_max[N]"] == pytest.approx(case["max_before"], rel=1e-5)
    assert found["R_max_at_phi[deg]"] == 0.0
    assert found["D_least_squares_rms[N]"] == pytest.approx(case["rms_after"], rel=1e-5)
    assert found["D_least_squares_max[N]"] == pytest.approx(case["max_after"], rel=1e-5)
    assert found["D_least_squares_ratio"] == pytest.approx(case["ratio"], rel=1e-5)
    assert found["D_least_squares_max_ratio"] == pytest.approx(case["max_before"] / case["max_after"], rel=1e-5)
    assert found["D_lanchester_rms[N]"] == pytest.approx(case["rms_after_counterrotating_pair"], rel=1e-5)
    (weight,) = found["weights_least_squares"]
    assert weight["moment[kg*m]"] == pytest.approx(case["counterweight_static_moment_kg_m"], rel=1e-6)
    assert abs(weight["angle[deg]"]) == pytest.approx(180)
    assert text(document, "least squares").splitlines()[:-1] == [
        "counterweight for the least mean square of the force",
        "order 1, 180 deg: 22.036 kg * 37.5 mm = 0.82634 kg*m",
        "leaves rms 13.74438 N, 1.805 times less",
        "max 18.93595 N at phi = 0 deg, 2.091 times less",
    ]


def test_weights_by_the_rule_of_the_reciprocating_mass() -> None:
    """m r = (m_rot + m_rec/2) l_1 on the crank, m_rec/2 l_1 against it; made to the mass that was chosen."""
    found = values(balance_summary(press(mass=15.0, schemes=("lanchester",)), "t"))
    on, against = found["weights_lanchester"]
    assert (on["order"], against["order"]) == (1, -1)
    assert on["moment[kg*m]"] == pytest.approx((ROTATING + RECIPROCATING / 2) * R)
    assert against["moment[kg*m]"] == pytest.approx(RECIPROCATING / 2 * R)
    assert on["mass[kg]"] == against["mass[kg]"] == 15
    assert against["radius[m]"] == pytest.approx(RECIPROCATING / 2 * R / 15)


@pytest.mark.parametrize(("speed", "start"), [(5.0, 0.0), (-5.0, 0.7), (5.0, -2.0)])
def test_places_count_from_position_0_along_the_motion(speed: float, start: float) -> None:
    found = values(balance_summary(press(speed, start), "t"))
    force = np.abs(shaken(PHI))
    assert found["R_rms[N]"] == pytest.approx(math.sqrt(np.mean(force**2)), rel=1e-9)
    assert found["R_max[N]"] == pytest.approx(force.max(), rel=1e-9)
    at = math.radians(found["R_max_at_phi[deg]"]) + start
    assert math.cos(at) == pytest.approx(1.0)
    assert 0 <= math.copysign(1, speed) * found["R_max_at_phi[deg]"] < 360
    left = np.abs(shaken(PHI) - (ROTATING + RECIPROCATING / 2) * R * 25 * np.exp(1j * PHI))
    assert found["D_least_squares_max[N]"] == pytest.approx(left.max(), rel=1e-9)
    assert found["D_minimax_max[N]"] < found["D_least_squares_max[N]"]


def test_weights_of_ones_own_are_told_by_their_moments() -> None:
    document = balance_summary(press(weights=(RotatingWeight(-1, 0.6j, -0.2j),), schemes=(), point=0.1 + 0.05j), "t")
    found = values(document)
    (weight,) = found["weights_given"]
    assert weight == {
        "order": -1,
        "moment[kg*m]": 0.6,
        "angle[deg]": pytest.approx(90),
        "axis_x[m]": 0.0,
        "axis_y[m]": -0.2,
    }
    assert "order -1, 90 deg: 0.6 kg*m, axis at (0, -200) mm" in text(document, "given")
    left = np.abs(shaken(PHI) + 0.6j * 25 * np.exp(-1j * PHI))
    assert found["D_given_rms[N]"] == pytest.approx(math.sqrt(np.mean(left**2)), rel=1e-9)
    assert (found["about_x[m]"], found["about_y[m]"]) == (0.1, 0.05)
    assert "about (100, 50) mm" in text(document, "shaking moment M_R")
    # the force of the weight acts on its axis, which lies beside the point
    assert "moment left: rms" in text(document, "given")


def test_weights_on_the_crank_leave_the_moment_about_it() -> None:
    document = balance_summary(press(), "t")
    found = values(document)
    assert found["M_D_minimax_rms[N*m]"] == found["M_R_rms[N*m]"]
    assert "moment left" not in text(document, "minimax")
    assert "moment as before: rms" in text(document, "minimax")
    assert any("do not change the shaking moment" in note for note in document.notes)


def test_the_moment_before_and_after_counterweights() -> None:
    """A four-bar freed of its shaking force: the moment left against (3.71) over a dense turn."""
    places = (Place(1, radius=0.06), Place(3, radius=0.1))
    bodies = (Body(1, 6.0, 0.05, 0.03 + 0j), Body(2, 4.0, 0.05, 0.17 + 0j), Body(3, 8.0, 0.1, 0.15 + 0j))
    mechanism = with_input(full_turn(four_bar(0.1, 0.35, 0.3, 0.4 + 0.05j), 0.0, 24), speed=8.0)
    result = balanced(mechanism, bodies, places=places)
    document = balance_summary(Balances(result, None, None), "t")
    found, said = values(document), text(document, "counterweights")
    assert result.redistribution is not None
    kinematics = solve_kinematics(mechanism)
    chain = compile_chain(mechanism, kinematics.structure, kinematics.variants)
    x = np.arange(4000) * (TURN / 4000)
    sizes = []
    for some in (bodies, (*bodies, *result.redistribution.counterweights)):
        moments = inertia_loads(chain, some, x, 8.0)[1]
        sizes.append((math.sqrt(np.mean(moments**2)), np.max(np.abs(moments))))
    (rms, largest), (rms_left, largest_left) = sizes
    assert found["M_D_counterweights_ratio"] == pytest.approx(rms / rms_left, rel=1e-9)
    assert found["M_D_counterweights_max_ratio"] == pytest.approx(largest / largest_left, rel=1e-5)
    assert rms_left > rms
    assert f"rms {rms_left / rms:.4g} times more" in said
    assert f"moment before: rms {rms:.5g}"[:-1] in said
    said = "note: counterweights: what takes the force raises the shaking moment"
    assert any(note.startswith(said) for note in document.notes)
    assert not any("raises the shaking" in note for note in balance_summary(press(), "t").notes)


def test_counterweights_on_links_and_what_they_lack() -> None:
    """Both turning links bear an exact balance: a weight on the rod takes the slider, one on the crank both."""
    one = balance_summary(press(places=(Place(1, radius=0.06),)), "t")
    assert values(one)["counterweights_exact"] is False
    assert values(one)["sufficient_links"] == [[1, 2]]
    assert any("counterweights on links 1 and 2 would" in note for note in one.notes)
    least = math.sqrt(np.mean(np.abs(shaken(PHI) - (ROTATING + RECIPROCATING / 2) * R * 25 * np.exp(1j * PHI)) ** 2))
    assert values(one)["D_counterweights_rms[N]"] == pytest.approx(least, rel=1e-9)
    both = balance_summary(press(places=(Place(1, radius=0.06), Place(2, radius=0.08))), "t")
    assert values(both)["counterweights_exact"] is True
    crank, rod = values(both)["counterweights"]
    # about the crank pin: (M3 L + M2 AS) = m 0.08; about the pivot all of it turns with the pin
    assert rod["mass[kg]"] == pytest.approx((M3 * L + M2 * AS) / 0.08)
    assert crank["mass[kg]"] == pytest.approx((M2 + M3 + rod["mass[kg]"]) * R / 0.06)
    assert (rod["x[m]"], crank["x[m]"]) == (pytest.approx(-0.08), pytest.approx(-0.06))
    assert values(both)["counterweights_added[kg]"] == pytest.approx(rod["mass[kg]"] + crank["mass[kg]"])
    assert "leaves no force" in text(both, "counterweights")
    assert not any("do not balance" in note for note in both.notes)


def test_a_yoke_is_balanced_altogether_by_a_pair() -> None:
    mechanism = full_turn(yoke(0.1, 1.2))
    link = mechanism.links[-1].id
    found = balanced(mechanism, (Body(link, 4.0, 0.0, 0j),))
    document = balance_summary(Balances(found, None, None), "t")
    assert "leaves no force" in text(document, "lanchester")
    assert "D_lanchester_ratio" not in values(document)
    assert values(document)["D_least_squares_ratio"] == pytest.approx(math.sqrt(2))
    shown = "\n".join(lines(balance_document(Balances(found, None, None), "t")))
    assert "e-1" not in shown.replace(text(document, "error of force (est.)"), "")


def test_what_needs_no_weight() -> None:
    """A mass on the crank's pivot shakes nothing."""
    document = balance_summary(
        Balances(balanced(full_turn(crank_slider(R, L)), (Body(1, 2.0, 0.1, 0j),)), None, None), "t"
    )
    assert text(document, "shaking force R") == "0 N"
    assert "no weight" in text(document, "least squares")
    assert "weights_least_squares" not in values(document)


def test_the_table_begins_with_sizes_and_holds_everything() -> None:
    result = press()
    case = CASES["dyn-balance-press"]["expected"]
    document = balance_document(result, "t", where="p.out/balance.csv")
    assert document.table is not None
    assert document.table.headers[:4] == ["i", "phi[deg]", "R[N]", "D_least_squares[N]"]
    sizes, left = (column(document, f"{name}[N]") for name in ("R", "D_least_squares"))
    phi = [round(p / 15) % 24 for p in column(document, "phi[deg]")]
    assert sizes == pytest.approx([case["R_modulus"][k] for k in phi], rel=1e-5)
    assert left == pytest.approx([case["D_modulus"][k] for k in phi], rel=1e-5)
    whole = balance_document(result, "t", everything=True)
    assert whole.table is not None
    assert whole.table.headers[2:5] == ["R[N]", "R_x[N]", "R_y[N]"]
    few = balance_document(result, "t", patterns=["phi", "R_x"], rows=[0, 3])
    assert few.table is not None
    assert few.table.headers == ["i", "phi[deg]", "R_x[N]"]
    assert len(few.table.columns[0]) == 2


GEAR = Gear(0.04, 0.14, 0.6, 0.4)
SPEED = 100 * math.pi


def engine(cylinders: Any, order: tuple[int, ...] | None = None, strokes: Any = 4) -> Balances:
    return Balances(None, solve_engine(EngineTask(cylinders, SPEED, (1, 2, 4, 6), strokes, order)), None)


def harmonic(k: int) -> float:
    """Amplitude of order k of a piston's acceleration over the crank radius times the squared speed."""
    count = 4096
    alpha = np.arange(count) * (TURN / count)
    s = GEAR.crank_radius * np.cos(alpha) + np.sqrt(GEAR.rod_length**2 - (GEAR.crank_radius * np.sin(alpha)) ** 2)
    return float(2 * k * k * abs(np.fft.fft(s)[k]) / count / GEAR.crank_radius)


def test_the_in_line_four_keeps_its_secondary_force() -> None:
    document = balance_summary(engine(in_line(4, 0.09, GEAR), (1, 3, 4, 2)), "Four: balance")
    found = values(document)
    unit = 4 * GEAR.reciprocating_mass * GEAR.crank_radius * SPEED**2
    assert document.title == "Four: balance"
    assert column(document, "order") == [1, 2, 4, 6]
    assert column(document, "balanced") == ["forces and couples", "couples", "couples", "couples"]
    assert column(document, "F[N]")[1:] == [pytest.approx(unit * harmonic(k), rel=1e-6) for k in (2, 4, 6)]
    assert column(document, "F_alone[N]")[1:] == [pytest.approx(unit * harmonic(k), rel=1e-6) for k in (2, 4, 6)]
    assert text(document, "balanced").startswith("primary forces and couples, secondary couples")
    assert text(document, "left").startswith("secondary forces 2764.6 N")
    assert text(document, "couple of the engine").startswith("0 N*m")
    assert text(document, "firing order") == "1-3-4-2, every 180 deg"
    assert text(document, "crankshaft weights").startswith("none")
    # two shafts of order 2 and -2 take the secondary force: half of it each, half of that in each plane
    half = unit * harmonic(2) / 2 / (4 * SPEED**2)
    weights = found["weights_shafts"]
    assert [weight["order"] for weight in weights] == [2, 2, -2, -2]
    assert [weight["moment[kg*m]"] for weight in weights] == [pytest.approx(half / 2, rel=1e-6)] * 4
    assert found["F_shafts_rms[N]"] == pytest.approx(
        unit * math.hypot(harmonic(4), harmonic(6)) / math.sqrt(2), rel=1e-3
    )


def test_one_cylinder_with_half_its_reciprocating_mass_balanced() -> None:
    document = balance_summary(engine(in_line(1, 0.0, GEAR)), "t")
    found = values(document)
    moment = (GEAR.rotating_mass + GEAR.reciprocating_mass / 2) * GEAR.crank_radius
    assert [weight["moment[kg*m]"] for weight in found["weights_crankshaft"]] == [pytest.approx(moment / 2)] * 2
    assert {round(weight["angle[deg]"]) for weight in found["weights_crankshaft"]} == {-90}
    assert text(document, "engine").startswith("1 cylinder at 314.1593 rad/s")


def test_uneven_firing_is_told_angle_by_angle() -> None:
    """A V-twin of 90 deg on one pin fires after 270 and 450 deg."""
    document = balance_summary(engine(vee(2, math.pi / 2, 0.1, GEAR), (1, 2)), "t")
    first, second = values(document)["firing_intervals[deg]"]
    assert {round(first), round(second)} == {270, 450}
    assert values(document)["firing_even"] is False
    assert text(document, "firing order").startswith("1-2, unevenly: after ")


UNBALANCES = (Unbalance(0.02, 0.1, math.pi / 6, 0.12), Unbalance(0.018, 0.1, 2.4, 0.33))


def rotor(*unbalances: Unbalance, grade: float | None = 6.3, radius: float | None = 0.12) -> Balances:
    body = Rotor(40.0, 0.18, (0.0, 0.4), 50 * math.pi, unbalances or UNBALANCES)
    return Balances(None, None, solve_rotor(RotorTask(body, (0.1, 0.3), None, grade, radius)))


def test_a_rotor_by_the_moments_about_its_bearings() -> None:
    document = balance_summary(rotor(), "t")
    found = values(document)
    u = [w.mass * w.radius * np.exp(1j * w.angle) for w in UNBALANCES]
    z = [w.position for w in UNBALANCES]
    b = sum(one * at for one, at in zip(u, z, strict=True)) / 0.4
    a = sum(u) - b
    square = (50 * math.pi) ** 2
    assert column(document, "A[N]") == pytest.approx([abs(a) * square, column(document, "A[N]")[1], 0], abs=1e-9)
    assert column(document, "B[N]")[0] == pytest.approx(abs(b) * square)
    # with the resultant gone only a couple is left: equal loads
    pair = abs(sum(one * (at - 0.18) for one, at in zip(u, z, strict=True))) / 0.4 * square
    assert (column(document, "A[N]")[1], column(document, "B[N]")[1]) == (pytest.approx(pair), pytest.approx(pair))
    assert found["eccentricity[m]"] == pytest.approx(abs(sum(u)) / 40)
    assert column(document, "e[m]") == [pytest.approx(abs(sum(u)) / 40), 0, 0]
    assert column(balance_document(rotor(), "t"), "e[um]") == pytest.approx([1e6 * e for e in column(document, "e[m]")])
    (one,) = found["correction_static"]
    assert (one["mass[kg]"], one["z[m]"]) == (pytest.approx(abs(sum(u)) / 0.12), 0.18)
    assert one["moment_angle[deg]"] == pytest.approx(math.degrees(np.angle(-sum(u))))
    first, second = found["correction_dynamic"]
    made = [w["moment[kg*m]"] * np.exp(1j * math.radians(w["moment_angle[deg]"])) for w in (first, second)]
    assert abs(sum(made) + sum(u)) < 1e-15
    assert abs(made[0] * 0.1 + made[1] * 0.3 + b * 0.4) < 1e-15


def test_the_grade_of_a_rotor() -> None:
    document = balance_summary(rotor(), "t")
    found = values(document)
    allowed = 6.3e-3 / (50 * math.pi) * 40
    assert found["U_per[kg*m]"] == pytest.approx(allowed)
    assert (found["U_per_A[kg*m]"], found["U_per_B[kg*m]"]) == (
        pytest.approx(allowed * 0.22 / 0.4),
        pytest.approx(allowed * 0.18 / 0.4),
    )
    square = (50 * math.pi) ** 2
    parts = [100 * load / square / found["U_per_A[kg*m]"] for load in column(document, "A[N]")]
    assert column(document, "A_part[%]") == pytest.approx(parts, abs=1e-9)
    assert text(document, "is it kept") == "as it is: no, one plane: no, two planes: yes"
    assert (found["grade_kept_one_plane"], found["grade_kept_two_planes"]) == (False, True)
    assert document.notes == ("note: balancing in one plane is not enough for G 6.3, it takes two",)
    alone = Unbalance(0.05, 0.1, 1.0, 0.18)
    assert balance_summary(rotor(alone), "t").notes == ("note: balancing in one plane is enough for G 6.3",)
    assert balance_summary(rotor(grade=40.0), "t").notes == ("note: the rotor keeps G 40 as it is",)


def test_a_rotor_without_grade_and_radius() -> None:
    document = balance_summary(rotor(grade=None, radius=None), "t")
    assert document.notes == ()
    assert [fact.label for fact in document.facts] == [
        "unbalance",
        "unbalance couple",
        "one-plane weight",
        "two-plane weights",
        "columns",
    ]
    assert "mass[kg]" not in values(document)["correction_static"][0]


def test_what_is_balanced_already_shows_no_noise() -> None:
    twins = Unbalance(0.015, 0.1, 0.0, 0.13), Unbalance(0.015, 0.1, math.pi, 0.33)
    document = balance_summary(rotor(*twins), "t")
    assert text(document, "unbalance") == "0 g*mm"
    assert text(document, "one-plane weight") == "z = 180 mm: 0 g*mm"
    assert not re.search(r"\de-\d", "\n".join(lines(document)))


def every() -> Balances:
    return Balances(
        press(places=(Place(1, radius=0.06),)).linkage, engine(in_line(4, 0.09, GEAR)).engine, rotor().rotor
    )


def test_linkage_engine_and_rotor_together() -> None:
    document = balance_document(every(), "All: balance")
    assert [part.title for part in document.parts] == ["engine", "rotor"]
    found = json.loads(printed(document, "json"))
    assert found["engine"]["cylinders"] == 4
    assert found["rotor"]["grade[mm/s]"] == 6.3
    assert found["columns"]["R[N]"][0] == pytest.approx(
        CASES["dyn-balance-press"]["expected"]["R_modulus"][0], rel=1e-5
    )
    both = balance_document(Balances(None, every().engine, every().rotor), "t")
    assert (both.facts, [part.title for part in both.parts]) == ((), ["engine", "rotor"])
    assert printed(document, "csv").startswith("i,phi[deg],R[N],D_least_squares[N]")
    assert printed(document, "toml")


@pytest.mark.parametrize("asked", [{"patterns": ["R"]}, {"rows": [0]}])
def test_without_a_linkage_there_are_no_positions(asked: dict[str, Any]) -> None:
    with pytest.raises(UsageError, match="no table of positions"):
        balance_document(rotor(), "t", **asked)


def test_it_reads_well_in_80_columns() -> None:
    shown = list(lines(balance_document(every(), "All: balance", where="p.out/balance.csv")))
    assert max(map(len, shown)) <= 80
    assert not [line for line in shown if "e-1" in line and not line.startswith("error")]
    assert "see p.out/balance.csv" in " ".join(shown)


class TestPicture:
    def figure(self, result: Balances) -> Any:
        from tmmcalc.machine.pictures.balance import balance_drawing

        return balance_drawing(result)

    def test_hodographs_and_levels_of_the_press(self) -> None:
        from tmmcalc.machine.pictures.balance import WEIGHT

        case = CASES["dyn-balance-press"]["expected"]
        fixed, turning, crank, pairs, _ = self.figure(press()).fields
        (ring,) = [line for line in curves(fixed, WEIGHT) if len(line) > 100]
        assert np.abs(ring) == pytest.approx(np.full(len(ring), case["centroid_X1"]), rel=1e-5)
        heads = [shape for shape in turning.drawing.shapes if isinstance(shape, Area) and len(shape.points) == 3]
        tips = [turning.data(complex(head.points[0])) for head in heads]
        assert any(tip == pytest.approx(complex(case["centroid_X1"], 0), rel=1e-5) for tip in tips)
        levels = [
            line.imag[0]
            for forces in (crank, pairs)
            for line in curves(forces)
            if len(line) == 2 and line[0].imag == line[1].imag
        ]
        for level in (case["rms_before"], case["rms_after"], case["rms_after_counterrotating_pair"]):
            assert any(found == pytest.approx(level, rel=1e-5) for found in levels)
        (curve,) = curves(crank, CURVES[0])
        assert curve.imag[::30] == pytest.approx([*case["R_modulus"], case["R_modulus"][0]], rel=1e-5)

    @pytest.mark.slow
    def test_the_smallest_circle_touches_the_hodograph(self) -> None:
        """In the axes of the crank the smallest circle passes through the outermost places and holds all others."""
        from tmmcalc.machine.pictures.balance import CIRCLE, FORCE

        _, turning, *_ = self.figure(press()).fields
        (z,) = [line for line in curves(turning, CIRCLE) if len(line) > 100]
        (path,) = curves(turning, FORCE)
        centre = complex(np.mean(z[:-1]))
        radius = abs(z[0] - centre)
        assert np.abs(path - centre).max() == pytest.approx(radius, rel=1e-4)

    def test_no_diagram_has_more_than_four_curves(self) -> None:
        """Of four schemes those of one weight on the crank stand apart from the pairs, each beside R."""
        drawing = self.figure(press())
        names = [text.partition(":")[0] for text in written(drawing) if ": rms" in text]
        assert names[:3] == ["$R$", "least squares", "least maximum"]
        assert names[3:6] == ["$R$", "Lanchester's pair", "Lanchester's pairs, 1st and 2nd order"]
        assert names[6:] == ["$M_R$"]  # what turns about the crank's pivot leaves its moment as it is

    @pytest.mark.slow
    def test_a_clockwise_crank_runs_to_negative_angles(self) -> None:
        forces = self.figure(press(-5.0, 0.7)).fields[2]
        assert (forces.x.low, forces.x.high) == (0.0, -360.0)

    @pytest.mark.slow
    def test_an_engine_shows_what_weights_leave(self) -> None:
        result = engine(in_line(4, 0.09, GEAR))
        drawing = self.figure(result)
        assert len(drawing.fields) == 2  # the couple is nothing
        assert "$F_x$, N" in written(drawing)
        assert result.engine is not None
        names = [text for text in written(drawing) if ": rms" in text]
        assert names[0] == f"as it is: rms {result.engine.balance.force_size.rms:.4g}"
        assert names[1].startswith("balance shafts: rms 41.6")
        assert len(self.figure(engine(vee(6, math.pi / 3, 0.1, GEAR))).fields) == 4

    @pytest.mark.slow
    def test_sheets_and_what_is_refused(self, tmp_path: Path) -> None:
        from drawing import drawn

        result = Balances(press().linkage, engine(in_line(4, 0.09, GEAR)).engine, None)
        drawn("balance", "machine", tmp_path / "a.svg", result)
        assert (tmp_path / "a.svg").read_bytes().startswith(b"<?xml")
        with pytest.raises(UsageError, match="no picture of a rotor"):
            drawn("balance", "machine", tmp_path / "c.svg", rotor())
        with pytest.raises(UsageError, match="suffix"):
            drawn("balance", "machine", tmp_path / "c.gif", result)
        assert sorted(file.name for file in tmp_path.iterdir()) == ["a.svg"]
