"""The documents and pictures of motions in time, against closed forms, energy, and the regime found by collocation."""

from __future__ import annotations

import csv
import io
import json
import math
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from machines import MOTOR, TURN, spec_text
from paper import curves, written

from machine.transient.scenes import constant, cycle
from tmmcalc.api import run
from tmmcalc.core.errors import UsageError
from tmmcalc.machine.driver import ConstantInertia
from tmmcalc.machine.facts.transient import document as transient_document
from tmmcalc.machine.facts.transient import mean_of
from tmmcalc.machine.facts.transient import summary as transient_summary
from tmmcalc.machine.model import DriveShaft, TransientTask
from tmmcalc.machine.transient.methods import Method
from tmmcalc.machine.transient.model import Shaft
from tmmcalc.machine.transient.scenario import Brake, Scenario
from tmmcalc.machine.transient.solve import Machine, solve_transients
from tmmcalc.machine.transient.timed import TimedMotions
from tmmcalc.machine.verdicts import Verdict
from tmmcalc.pipeline.summary import run_document
from tmmcalc.project import parse_spec
from tmmcalc.report.document import Document
from tmmcalc.report.drawing.pens import CURVES
from tmmcalc.report.errors import with_errors
from tmmcalc.report.plaintext import lines
from tmmcalc.report.render import render

J = 2.0
CASES = {c["id"]: c for c in json.loads((Path(__file__).parents[2] / "cases" / "dynamics.json").read_text())}


def values(document: Document) -> dict[str, Any]:
    return {key: value for fact in document.facts for key, value in fact.values.items()}


def text(document: Document, label: str) -> str:
    (fact,) = [fact for fact in document.facts if fact.label == label]
    return fact.text


def column(document: Document, header: str) -> list[Any]:
    assert document.table is not None
    return list(document.table.columns[list(document.table.headers).index(header)])


def moved(*scenarios: Scenario, motor: float = 50.0, load: float = -20.0) -> TimedMotions:
    """One mass of 2 kg*m^2 under a constant motor and a constant load."""
    machine = Machine(cycle(load), None, ConstantInertia(further=J), None, constant(motor), 0.0, 1.0)
    return solve_transients(machine, [TransientTask(one, Method(), False) for one in scenarios], None)


START = Scenario("start", 10.0, targets=(15.0,), end_speed=30.0)
STOP = Scenario("stop", 10.0, speed=10.0, motor=(), brake=Brake(moment=40.0, start=0.25))


@pytest.fixture(scope="module")
def start() -> TimedMotions:
    """30 N*m are left for 2 kg*m^2: 15 rad/s^2."""
    return moved(START)


def test_a_start_with_constant_moments(start: TimedMotions) -> None:
    document = transient_summary(start, "t")
    found = values(document)
    assert found["end"] == "speed"
    assert found["end_time[s]"] == pytest.approx(2.0)
    assert found["turns"] == pytest.approx(30 / TURN)
    assert found["end_angle[deg]"] == pytest.approx(math.degrees(30.0))
    assert found["end_omega[rad/s]"] == found["omega_largest[rad/s]"] == 30.0
    assert (found["work_motor[J]"], found["work_load[J]"]) == (pytest.approx(1500), pytest.approx(-600))
    assert (found["energy_begin[J]"], found["energy_end[J]"]) == (0.0, pytest.approx(J * 900 / 2))
    assert found["M_motor_largest[N*m]"] == found["M_motor_rms[N*m]"] == pytest.approx(50)
    half, whole = found["reached"]
    assert (half["omega[rad/s]"], half["t[s]"], half["turns"]) == (
        pytest.approx(15),
        pytest.approx(1),
        pytest.approx(7.5 / TURN),
    )
    assert (whole["omega[rad/s]"], whole["t[s]"], whole["turns"]) == (30, pytest.approx(2), pytest.approx(30 / TURN))
    assert text(document, "ends").startswith("at t = 2 s: it has reached the speed asked for\nafter 4.7746 turns")
    assert text(document, "reaches").splitlines()[0] == "15 rad/s (143.24 rpm) after 1 s, 1.194 turns"
    assert "motor 1500 J, load -600 J" in text(document, "energy and work")
    assert "brake" not in text(document, "energy and work")


def test_events_stand_in_a_table_with_turns_and_angles(start: TimedMotions) -> None:
    document = transient_summary(start, "t")
    assert column(document, "t[s]") == [pytest.approx(1), pytest.approx(2)]
    assert column(document, "turns") == [1, 4]
    assert column(document, "angle[deg]") == [pytest.approx(math.degrees(a) % 360) for a in (7.5, 30.0)]
    assert column(document, "omega[rad/s]") == [pytest.approx(15), pytest.approx(30)]
    assert [event["kind"] for event in values(document)["events"]] == ["target", "target"]


def test_an_angle_of_whole_turns_is_no_turn_less() -> None:
    """Thirds of a turn add up to a little less than turns in floating point."""
    document = transient_summary(moved(Scenario("turn", 10.0, speed=1.0, end_angle=3 * TURN)), "t")
    assert column(document, "turns") == [3]
    assert column(document, "angle[deg]") == [pytest.approx(0.0, abs=1e-6)]
    assert values(document)["turns"] == pytest.approx(3.0)


def test_a_brake_takes_the_energy() -> None:
    """10 rad/s for a quarter of a second against 20 N*m, then against 60 N*m."""
    document = transient_summary(moved(STOP), "t")
    found = values(document)
    after = 10 - 10 * 0.25
    end = 0.25 + after / 30
    turned = 10 * 0.25 - 10 * 0.25**2 / 2, after**2 / 60
    assert found["end"] == "standstill"
    assert found["end_time[s]"] == pytest.approx(end)
    assert found["turns"] == pytest.approx(sum(turned) / TURN)
    assert found["work_brake[J]"] == pytest.approx(-40 * turned[1])
    assert found["work_load[J]"] == pytest.approx(-20 * sum(turned))
    assert found["work_motor[J]"] == 0
    assert "M_motor_rms[N*m]" not in found
    assert "reached" not in found
    assert text(document, "speed of the crank") == "at first 10 rad/s (95.493 rpm)"
    assert column(document, "event")[0] == "the brake is put on"


def test_a_motor_that_stalls_says_so() -> None:
    """10 N*m against 20 N*m: 5 rad/s^2 from 5 rad/s."""
    document = transient_summary(moved(Scenario("stall", 9.0, speed=5.0), motor=10.0), "t")
    assert values(document)["end"] == "stall"
    assert values(document)["end_time[s]"] == pytest.approx(1.0)
    assert "the motor stalls" in text(document, "ends")
    assert [note for note in document.notes if note.startswith("warning: ") and "stall" in note]


def test_what_never_moves_is_told_as_well() -> None:
    (motion,) = moved(Scenario("nothing", 1.0, motor=())).motions
    document = transient_document(TimedMotions((motion,)), "t")
    assert values(document)["turns"] == 0
    assert text(document.parts[0], "rows") == "all 1"
    assert text(document, "energy and work").splitlines()[1] == "work: none"


def two_mass(periods: int, behind: float = 2.0) -> TimedMotions:
    """dyn-ext-two-mass: a constant motor twists the shaft to 40 (1 - cos(w t)) N*m."""
    case = CASES["dyn-ext-two-mass"]["inputs"]
    shaft = DriveShaft("s", Shaft(case["c"]), behind)
    machine = Machine(
        cycle(0.0), None, ConstantInertia(rotor=case["J1"]), constant(case["M_d"]), None, 0.0, 1.0, (shaft,)
    )
    rate = CASES["dyn-ext-two-mass"]["expected"]["omega_natural"]
    scenario = Scenario("twist", periods * TURN / rate)
    return solve_transients(machine, [TransientTask(scenario, Method("DOP853"), False)], None)


def test_a_moment_that_comes_suddenly_twists_the_shaft_twice_as_much() -> None:
    document = transient_document(two_mass(20), "t")
    found = values(document)
    expected = CASES["dyn-ext-two-mass"]["expected"]["M12_max"]
    assert found["M_1_2_largest[N*m]"] == pytest.approx(expected, rel=2e-2)  # at the nearest step
    assert found["M_1_2_mean[N*m]"] == pytest.approx(expected / 2, rel=2e-2)
    assert found["M_1_2_rigid[N*m]"] == pytest.approx(expected / 2, rel=1e-9)
    assert found["M_1_2_dynamic_factor"] == pytest.approx(found["M_1_2_largest[N*m]"] / found["M_1_2_rigid[N*m]"])
    assert "dynamic factor" in text(document, "shaft M_1_2")
    assert text(document, "shaft M_1_2").startswith("rotor to crank\nlargest ")
    (course,) = document.parts
    assert text(course, "masses") == "1 rotor, 2 crank"
    assert course.table is not None
    assert course.table.headers[:5] == ["t[s]", "theta_2[deg]", "omega_2[rad/s]", "omega_1[rad/s]", "M_1_2[N*m]"]


def test_a_shaft_taken_as_rigid_is_named() -> None:
    (motion,) = two_mass(3).motions
    document = transient_summary(TimedMotions((replace(motion, rigid=(0,)),)), "t")
    assert text(document, "shaft M_1_2").startswith("rotor to crank, taken as rigid\n")


def test_the_mean_over_uneven_times() -> None:
    t = np.sort(np.random.default_rng(3).uniform(0, 2, 4000))
    t[0], t[-1] = 0.0, 2.0
    assert mean_of(t, 3 * t**2) == pytest.approx(4.0, rel=1e-5)
    assert mean_of(t[:1], t[:1] + 7) == 7.0


def test_the_short_table_has_the_rows_nearest_to_equal_times(start: TimedMotions) -> None:
    (motion,) = start.motions
    fine = np.sort(np.concatenate((np.linspace(0, 2, 97), 2 * np.linspace(0, 1, 60) ** 5)))
    many = replace(motion, **{name: getattr(motion, name)[..., [0] * len(fine)] for name in ARRAYS}, t=fine)
    document = transient_document(TimedMotions((many,)), "t")
    (course,) = document.parts
    shown = column(course, "t[s]")
    assert shown == sorted({min(fine, key=lambda t: abs(t - k / 12)) for k in range(25)})
    assert text(course, "rows").startswith("25 of 157, near equal times; all: --format csv")
    (course,) = transient_document(TimedMotions((many,)), "t", where="p.out/transient.csv").parts
    assert text(course, "rows") == "25 of 157, near equal times; all: p.out/transient.csv"


ARRAYS = ("theta", "omega", "alpha", "motor_moment", "load_moment", "load_factor", "kinetic", "elastic", "step_error")


def test_several_motions_are_parts() -> None:
    result = moved(START, STOP)
    document = transient_document(result, "Machine: transient")
    assert [part.title for part in document.parts] == ["start", "stop"]
    assert [part.parts[0].title for part in document.parts] == ["course of start", "course of stop"]
    assert (document.facts, document.table) == ((), None)
    assert [part.parts for part in transient_summary(result, "t").parts] == [(), ()]


def printed(document: Document, form: Any) -> str:
    stream = io.StringIO()
    render(document, form, stream)
    return stream.getvalue()


def test_csv_holds_every_row_of_every_motion() -> None:
    result = moved(START, STOP)
    document = transient_document(result, "t", everything=True)
    header, *rows = csv.reader(io.StringIO(printed(document, "csv")))
    assert header[:4] == ["motion", "t[s]", "theta[deg]", "omega[rad/s]"]
    assert [row[0] for row in rows] == ["start"] * len(result.motions[0].t) + ["stop"] * len(result.motions[1].t)
    omega = np.concatenate([motion.omega[0] for motion in result.motions])
    assert [float(row[3]) for row in rows] == omega.tolist()
    found = json.loads(printed(document, "json"))
    assert found["start"]["end_time[s]"] == pytest.approx(2.0)
    assert found["stop"]["events"][0]["kind"] == "brake on"
    assert found["columns"]["omega[rad/s]"] == omega.tolist()


def test_columns_are_chosen_by_name(start: TimedMotions) -> None:
    wanted = ["t", "omega[rad/s]", "M_*"]
    whole = transient_document(start, "t", patterns=["motion", *wanted], everything=True)
    assert whole.table is not None
    assert whole.table.headers == ["motion", "t[s]", "omega[rad/s]", "M_motor[N*m]", "M_load[N*m]"]
    (course,) = transient_document(start, "t", patterns=wanted).parts
    assert course.table is not None
    assert course.table.headers == ["t[s]", "omega[rad/s]", "M_motor[N*m]", "M_load[N*m]"]
    assert not course.wide
    with pytest.raises(UsageError, match="no column is called 'speed'"):
        transient_document(start, "t", patterns=["speed"])


def test_verdicts_are_notes(start: TimedMotions) -> None:
    (motion,) = start.motions
    marked = replace(motion, verdicts=(Verdict("warning", "pull-out"), Verdict("note", "slow")))
    assert transient_summary(TimedMotions((marked,)), "t").notes == ("warning: pull-out", "note: slow")


TRANSIENT = """
[[transients]]
name = "start"
duration = "6 s"
load = 0
load_steps = [{ factor = 1, speed = "80 rpm", quiet = true }]
targets = ["60 rpm"]
"""


@pytest.fixture(scope="module")
def whole() -> Any:
    spec = spec_text(motor=MOTOR, more=TRANSIENT).replace("[motor]", '[motor]\ncharacteristic = "kloss"')
    return run(parse_spec(spec))


@pytest.mark.slow
def test_the_last_turn_is_that_of_the_steady_regime(whole: Any) -> None:
    """The regime comes from a boundary problem over the cycle, the turn from steps in time."""
    found = values(transient_summary(whole.results["transient"], "t"))
    regime = whole.results["motion"].regime
    assert found["swing_low[rad/s]"] == pytest.approx(regime.omega_min, rel=1e-6)
    assert found["swing_high[rad/s]"] == pytest.approx(regime.omega_max, rel=1e-6)
    assert found["swing_delta"] == pytest.approx(regime.delta, rel=1e-3)
    assert found["residual"]["energy"] < 1e-9


def test_no_fact_is_lost_in_a_whole_run(whole: Any) -> None:
    document = run_document(whole, "t")
    (part,) = [part for part in document.parts if part.title == "transient"]
    alone = with_errors(transient_summary(whole.results["transient"], "transient"), whole.record("transient").error)
    assert [fact.label for fact in part.facts] == [fact.label for fact in alone.facts]


def test_it_reads_well_in_80_columns(whole: Any) -> None:
    for result in (whole.results["transient"], two_mass(5), moved(START, STOP)):
        shown = list(lines(transient_document(result, "Press: transient")))
        assert max(map(len, shown)) <= 80
        assert not [line for line in shown if "nan" in line or "inf" in line]


class TestPicture:
    def panels(self, result: TimedMotions) -> list[Any]:
        from tmmcalc.machine.pictures.transient import transient_drawing

        return list(transient_drawing(result).fields)

    def test_the_speed_with_its_events(self, start: TimedMotions) -> None:
        from tmmcalc.machine.pictures.transient import EVENT

        (motion,) = start.motions
        speed, moments = self.panels(start)
        (curve,) = curves(speed, CURVES[0])
        np.testing.assert_allclose(curve.real, motion.t, atol=1e-9)
        np.testing.assert_allclose(curve.imag, motion.omega[0], atol=1e-9)
        marks = sorted(float(line.real[0]) for line in curves(speed, EVENT))
        assert marks == [pytest.approx(time) for time in sorted(event.time for event in motion.events)]
        assert {"1", "2"} <= set(written(speed.drawing, speed.box))
        assert moments.x.name == "$t$, s"
        assert [curves(moments, pen)[0].imag[0] for pen in CURVES[:2]] == pytest.approx([50.0, -20.0])

    def test_a_flat_tail_is_magnified(self, whole: Any) -> None:
        result = whole.results["transient"]
        _, tail, _ = self.panels(result)
        low, high = tail.y.low, tail.y.high
        regime = whole.results["motion"].regime
        assert regime.omega_min - 0.3 * (regime.omega_max - regime.omega_min) < low < regime.omega_min
        assert regime.omega_max < high < regime.omega_max + 0.3 * (regime.omega_max - regime.omega_min)

    def test_masses_and_shafts_of_an_elastic_drive(self) -> None:
        result = two_mass(5)
        (motion,) = result.motions
        panels = self.panels(result)
        (shaft,) = curves(panels[-1], CURVES[0])
        np.testing.assert_allclose(shaft.imag, motion.shaft_moment[0], atol=1e-9)
        assert [text for text in written(panels[0].drawing) if text in ("crank", "rotor")] == ["crank", "rotor"]

    @pytest.mark.slow
    def test_every_motion_has_a_sheet(self, tmp_path: Path) -> None:
        from drawing import drawn

        result = moved(START, STOP, Scenario("nothing", 1.0, motor=()))
        assert len(self.panels(result)) == 6
        drawn("transient", "machine", tmp_path / "a.svg", result)
        assert (tmp_path / "a.svg").read_bytes().startswith(b"<?xml")
        with pytest.raises(UsageError, match="suffix"):
            drawn("transient", "machine", tmp_path / "a.jpg", result)
