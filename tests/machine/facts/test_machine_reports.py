"""The documents of power, flywheel and motion, against closed forms and the worked cases of the course."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Callable
from dataclasses import replace
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from loaded import press
from machines import TURN, positions, sine, spec_text, steps

from machine.flywheel.scenes import parabola, upsetter, upsetter_cycle
from machine.motion import shaper
from tmmcalc.api import run
from tmmcalc.core.errors import UsageError
from tmmcalc.machine.driveline import DriveLine
from tmmcalc.machine.driver import ConstantInertia, Driver, driver_of
from tmmcalc.machine.facts.flywheel import document as flywheel_document
from tmmcalc.machine.facts.flywheel import summary as flywheel_summary
from tmmcalc.machine.facts.motion import document as motion_document
from tmmcalc.machine.facts.motion import summary as motion_summary
from tmmcalc.machine.facts.power import document as power_document
from tmmcalc.machine.facts.power import summary as power_summary
from tmmcalc.machine.flywheel.results import Flywheel
from tmmcalc.machine.flywheel.solve import Machine, solve_flywheel
from tmmcalc.machine.model import FlywheelTask
from tmmcalc.machine.motion import Motion, solve_motion
from tmmcalc.machine.motors.characteristics import Parabolic
from tmmcalc.machine.motors.model import Motor
from tmmcalc.machine.power import Power, WorkPart, chosen_motor, duty_of, solve_power
from tmmcalc.machine.reduction.solve import solve_reduction
from tmmcalc.machine.verdicts import Verdict
from tmmcalc.pipeline.outcome import Event
from tmmcalc.pipeline.summary import run_document
from tmmcalc.project import load_spec
from tmmcalc.project.loader import parse_spec
from tmmcalc.report.document import Document
from tmmcalc.report.errors import with_errors
from tmmcalc.report.plaintext import lines

CASES = {c["id"]: c for c in json.loads((Path(__file__).parents[2] / "cases" / "dynamics.json").read_text())}
RPM = math.pi / 30


def values(document: Document) -> dict[str, Any]:
    return {key: value for fact in document.facts for key, value in fact.values.items()}


def text(document: Document, label: str) -> str:
    (fact,) = [fact for fact in document.facts if fact.label == label]
    return fact.text


def column(document: Document, header: str) -> list[Any]:
    assert document.table is not None
    return list(document.table.columns[list(document.table.headers).index(header)])


class TestPower:
    def stepped(self, **more: Any) -> Power:
        """-90 N*m on the way out, -10 N*m back, of which friction is 10 throughout."""
        parts = (WorkPart("Q", "load", -80 * math.pi), WorkPart("friction", "friction", -20 * math.pi))
        return solve_power(steps((-90.0, -10.0)), parts, **more)

    def motor(self, **more: Any) -> Motor:
        return Motor("M", 600.0, 955 * RPM, 1000 * RPM, **more)

    def duty(self, motor: Motor, ratio: float = 10.0) -> Power:
        power = self.stepped(line=DriveLine(efficiency=0.8))
        return replace(power, duty=duty_of(power, motor, ratio, (), False))

    def test_the_press_of_the_textbook(self) -> None:
        case = CASES["dyn-press-reduced"]["expected"]
        reduction = solve_reduction(*press())
        parts = tuple(WorkPart(c.name, c.kind, c.work) for c in reduction.contributions)
        found = values(power_document(solve_power(reduction.cycle, parts), "t"))
        assert found["A_c[J]"] == pytest.approx(case["A_C_exact"], abs=1e-4)
        assert found["work_Q3[J]"] == found["A_c[J]"]
        assert found["A_F[J]"] == pytest.approx(case["A_F_fine"], abs=1e-3)
        assert found["A_d[J]"] == 0
        assert found["eta"] == pytest.approx(case["eta_fine"], abs=1e-5)
        assert found["cycle_time[s]"] == pytest.approx(TURN / 5)
        assert found["P_mean[W]"] == pytest.approx(-(case["A_C_exact"] + case["A_F_fine"]) * 5 / TURN, abs=1e-3)
        assert found["P_required[W]"] == found["P_mean[W]"]

    def test_two_steps_of_load(self) -> None:
        document = power_summary(self.stepped(line=DriveLine(efficiency=0.8)), "t")
        found = values(document)
        assert found["eta"] == pytest.approx(0.8)
        assert text(document, "efficiency") == "0.8 = A_c/(A_c + A_F)"
        assert (found["P_mean[W]"], found["M_d_mean[N*m]"]) == (pytest.approx(500), pytest.approx(50))
        assert found["M_peak[N*m]"] == pytest.approx(90)
        assert (found["P_load_min[W]"], found["P_load_max[W]"]) == (pytest.approx(-900), pytest.approx(-100))
        assert (found["P_required[W]"], found["eta_gears"]) == (pytest.approx(625), 0.8)
        assert text(document, "required motor power") == "625 W, through gears of the efficiency 0.8"

    def test_the_place_of_the_peak(self) -> None:
        document = power_summary(solve_power(sine(100.0), (WorkPart("Q", "load", -1.0),)), "t")
        assert text(document, "peak resisting moment") == "100 N*m, resisting at phi = 270 deg"
        assert values(document)["M_peak_at_phi[deg]"] == pytest.approx(270)
        clockwise = power_summary(solve_power(sine(100.0), (WorkPart("Q", "load", -1.0),), sense=-1.0), "t")
        assert text(clockwise, "peak resisting moment") == "100 N*m, resisting at phi = -270 deg"
        assert values(clockwise)["M_peak_at_phi[deg]"] == pytest.approx(-270)
        nothing = power_summary(solve_power(steps((5.0, 1.0)), (WorkPart("gas", "load", 6 * math.pi),)), "t")
        assert text(nothing, "peak resisting moment") == "0 N*m: nothing ever resists"

    def test_an_engine(self) -> None:
        parts = (WorkPart("gas", "load", 100.0), WorkPart("damper", "damper", -20.0))
        document = power_summary(solve_power(steps((40 / math.pi, 40 / math.pi)), parts), "t")
        assert text(document, "machine").startswith("engine")
        assert text(document, "efficiency") == "0.8 = (A_d + A_F)/A_d"
        assert text(document, "resisting work A_c") == "0 J, no load resists"
        assert "left for the machine that it drives" in text(document, "mean power")
        assert "P_required[W]" not in values(document)

    @pytest.mark.parametrize(
        ("works", "machine", "eta", "formula"),
        [
            ((20.0, -100.0, -20.0), "working", 100 / 120, "A_c/(A_c + A_F)"),  # the drive puts in 100 J beside the 20
            ((320.0, -355.0, -6.0), "engine", 355 / 361, "A_c/(A_c + A_F)"),  # a drive gives the 41 J that are lacking
            ((320.0, -300.0, -6.0), "engine", 314 / 320, "(A_d + A_F)/A_d"),  # 14 J are left beside the 300
            ((320.0, -314.0, -6.0), "engine", 314 / 320, "A_c/(A_c + A_F)"),  # nothing is left or lacking
        ],
    )
    def test_loads_that_drive_and_loads_that_resist(
        self, works: tuple[float, float, float], machine: str, eta: float, formula: str
    ) -> None:
        """Efficiency is useful work over work put in, and the loads that put more in than a drive make an engine."""
        names = (("gas", "load"), ("Q", "load"), ("k", "friction"))
        parts = tuple(WorkPart(*name, work) for name, work in zip(names, works, strict=True))
        result = solve_power(steps((sum(works) / TURN,)), parts)
        found = values(power_summary(result, "t"))
        assert (found["machine"], found["eta"]) == (machine, pytest.approx(eta, rel=1e-14))
        assert text(power_summary(result, "t"), "efficiency").endswith(f"= {formula}")
        assert (result.motor_power is None) == (sum(works) > 0)

    def test_a_diagram_and_the_moment_that_balances_it(self) -> None:
        """M = 140 + 100 sin(theta) N*m at 10 rad/s: 1400 W that the load of the engine takes."""
        law = "[torque]\nname = 'gas'\nspeed = 10\nformula = '140 + 100*sin(theta)'\ninertia = 5\nbalanced = true\n"
        results = run(parse_spec(law + "[motion]\n")).results
        document = power_document(results["power"], "t")
        found = values(document)
        assert found["work_gas[J]"] == pytest.approx(140 * TURN)
        assert found["work_balancing_moment[J]"] == pytest.approx(-140 * TURN)
        assert (found["machine"], found["P_mean[W]"]) == ("engine", pytest.approx(1400))
        assert found["M_balancing[N*m]"] == pytest.approx(-140)
        assert "the load of the engine" in text(document, "balancing moment")
        assert "P_required[W]" not in found
        reduction = results["reduction"]
        assert np.allclose(reduction.total, 100 * np.sin(reduction.phi), atol=1e-11)
        driven = motion_summary(results["motion"], "t")
        assert values(driven)["M_d_mean[N*m]"] == 0
        assert "balancing moment of -140 N*m: nothing is left to drive" in text(driven, "driven by")

    def test_a_motor_that_misses_the_speed_of_the_spec(self) -> None:
        motor = "[motor]\npower = '1 kW'\nspeed = '955 rpm'\nsynchronous_speed = '1000 rpm'\ninertia = 0.01\n"
        law = "[torque]\nspeed = '50 rpm'\nformula = '-10'\ninertia = 5\n"
        fine, off = (
            power_summary(run(parse_spec(f"{law}{motor}[transmission]\nratio = {ratio}\n")).results["power"], "t")
            for ratio in (19.1, 10)
        )
        assert fine.notes == ()
        assert off.notes[0].startswith("warning: at its rated speed the motor turns the input with 95.5 rpm")

    def test_the_name_plate_and_the_duty(self) -> None:
        motor = self.motor(overload=2.5, start=1.9, inertia=0.02, source="a catalogue, p. 6")
        document = power_summary(self.duty(motor), "t")
        found = values(document)
        rated = 600 / (955 * RPM)
        assert (found["P_N[W]"], found["n_N[rpm]"]) == (600, pytest.approx(955))
        assert (found["n_sync[rpm]"], found["M_N[N*m]"]) == (pytest.approx(1000), pytest.approx(rated))
        assert (found["u"], found["J_rotor[kg*m^2]"]) == (10, pytest.approx(2))
        assert found["M_N_input[N*m]"] == pytest.approx(8 * rated)
        assert (found["mean_load"], found["peak_load"]) == (
            pytest.approx(50 / (8 * rated)),
            pytest.approx(90 / (8 * rated)),
        )
        assert text(document, "motor").splitlines() == [
            "M",
            f"600 W, 955 rpm, no load 1000 rpm, M_N = {rated:.7g} N*m",
            "largest moment 2.5 M_N, starting moment 1.9 M_N",
            "rotor J_R = 0.02 kg*m^2",
            "data: a catalogue, p. 6",
        ]

    def test_what_the_notes_say(self) -> None:
        good = self.motor(overload=2.5, inertia=0.02)
        weak, strong = (power_summary(self.duty(good, ratio), "t").notes for ratio in (10.0, 20.0))
        assert [note.split(":")[0] for note in weak] == ["warning"]
        assert "the mean load is 1.042 of the rated moment" in weak[0]
        assert strong == ()
        (unknown,) = power_summary(self.duty(self.motor(overload=2.5), 20.0), "t").notes
        assert unknown.startswith("warning: the inertia of the motor's rotor is not known")
        (peak,) = power_summary(self.duty(self.motor(overload=1.5, inertia=0.02), 11.0), "t").notes
        assert peak.startswith("note: the peak load, 1.705 of the rated moment")

    def test_a_shunt_motor_shows_both_ends_of_its_curve(self) -> None:
        """220 V, 0.5 ohm, 1.375 V*s/rad: 160 rad/s without load, k U/R = 605 N*m at standstill."""
        circuit = {"kind": "shunt", "voltage": 220.0, "resistance": 0.5, "constant": 1.375, "inertia": 0.1}
        rated = 1.375 * (220 - 1.375 * 150) / 0.5  # at 150 rad/s
        power, good = self.stepped(), Motor("M", rated * 150, 150.0, **circuit)
        fine = power_summary(replace(power, duty=duty_of(power, good, 10.0, (), False, "shunt")), "t")
        assert text(fine, "its characteristic") == f"no load at {160 / RPM:.7g} rpm, 605 N*m at standstill"
        assert (values(fine)["n_no_load[rpm]"], values(fine)["M_stall[N*m]"]) == (pytest.approx(160 / RPM), 605)
        assert not any("contradict" in note for note in fine.notes)
        off = power_summary(
            replace(power, duty=duty_of(power, replace(good, power=1.1 * good.power), 10.0, (), False, "shunt")), "t"
        )
        assert off.notes[0].startswith("warning: the data of the motor contradict each other: at the rated speed")
        assert "(-9.09 %)" in off.notes[0]

    def test_a_series_motor_runs_away(self) -> None:
        motor = Motor("M", 4e3, 100.0, kind="series", efficiency=0.8, inertia=0.1)
        power = self.stepped()
        document = power_summary(replace(power, duty=duty_of(power, motor, 10.0, (), False, "series")), "t")
        assert text(document, "its characteristic") == "runs away without load, 1000 N*m at standstill"
        assert "n_no_load[rpm]" not in values(document)

    def test_a_chosen_motor_comes_with_the_reasons(self) -> None:
        catalogue = (replace(self.motor(), name="small", power=400.0), replace(self.motor(), name="large"))
        power = self.stepped()
        choice = chosen_motor(power, catalogue, 10.0, None, None)
        duty = duty_of(power, choice.motor, 955 * RPM / 10, choice.reasons, True)
        document = power_summary(replace(power, duty=duty), "t")
        assert text(document, "motor").startswith("large\n")
        assert text(document, "chosen because").splitlines()[0] == (
            "0.6 kW cover the required 0.5 kW with 20% in reserve"
        )
        assert values(document)["motor_chosen"] is True

    def test_the_work_of_causes_is_left_to_the_reduction(self) -> None:
        twins = (WorkPart("k", "spring", 0.0), WorkPart("k", "damper", -5.0), WorkPart("an arm", "weight", 1e-15))
        power = solve_power(steps((-5 / TURN,)), twins)
        document = power_document(power, "t")
        assert values(document)["work_k_damper[J]"] == -5
        assert text(document, "work of k (damping)") == f"-5 J a cycle, {-50 / TURN:.7g} W"
        assert text(document, "work of an arm") == "0 J a cycle, 0 W"
        assert values(document)["work_an_arm[J]"] == 1e-15
        assert not any(key.startswith("work_") for key in values(power_summary(power, "t")))


def task(delta: float, **more: Any) -> FlywheelTask:
    nothing = dict.fromkeys(("ratio", "diameter", "width", "thickness", "density", "speed_limit"))
    return FlywheelTask(**{**nothing, "delta": delta, "inertia": 0.0, "shaft": "input", "material": "steel", **more})


def upset() -> Flywheel:
    """The cold-heading machine of the textbook with the parabola of its motor."""
    given = CASES["dyn-upsetter-flywheel-motor"]["inputs"]
    motor = Parabolic(*parabola(), given["omega_sync"], given["omega_N"])
    at_hand = ConstantInertia(further=given["J_const_initial"])
    wanted = task(given["delta_allowed"], diameter=0.5, width=0.05)
    return solve_flywheel(Machine(upsetter_cycle(), at_hand, wanted, Driver(motor, 0.0), 10.0, 1.0))


@pytest.fixture(scope="module")
def upsetting() -> Document:
    return flywheel_document(upset(), "t")


class TestFlywheel:
    M1, DELTA, MEAN = 100.0, 0.02, 20.0

    def swinging(self, at_hand: float = 0.0, ratio: float = 1.0, **more: Any) -> Flywheel:
        """A load M1 sin(phi): A = M1 (1 - cos phi), and J_F = 2 M1/(delta omega^2) = 25 kg*m^2."""
        inertia = ConstantInertia(rotor=at_hand)
        return solve_flywheel(
            Machine(sine(self.M1), inertia, task(**{"delta": self.DELTA, **more}), None, self.MEAN, ratio)
        )

    def test_a_sine_of_load(self) -> None:
        case = CASES["dyn-flywheel-sine"]["expected"]
        document = flywheel_document(self.swinging(at_hand=4.0), "t")
        found = values(document)
        assert found["J_F[kg*m^2]"] == pytest.approx(case["J_F"])
        assert (found["J_at_hand[kg*m^2]"], found["J_add[kg*m^2]"]) == (4, pytest.approx(21))
        assert (found["G[J]"], found["H[J]"]) == (pytest.approx(case["A_max_minus_A_min"]), pytest.approx(0, abs=1e-9))
        assert found["slope_max[rad^2/s^2]"] == pytest.approx((self.MEAN * 1.01) ** 2 / 2)
        assert found["T_0[J]"] == pytest.approx(25 * (self.MEAN * 0.99) ** 2 / 2)
        assert column(document, "max_at[deg]") == [pytest.approx(180)] * 5
        assert column(document, "min_at[deg]") == [pytest.approx(0, abs=1e-6)] * 5
        assert column(document, "J_F[kg*m^2]") == [pytest.approx(25)] * 5
        assert column(document, "J_add[kg*m^2]") == [pytest.approx(21)] * 5
        assert column(document, "delta") == [pytest.approx(0.02)] * 5
        assert column(document, "error[%]") == [pytest.approx(0, abs=1e-9)] * 5
        assert "delta_motor" not in list(document.table.headers if document.table else ())
        assert "21 kg*m^2 at the input shaft\nJ_F = 25 kg*m^2 with what is at hand" in text(document, "flywheel needed")

    def test_a_fast_shaft_and_the_sizes_of_the_rim(self) -> None:
        document = flywheel_summary(self.swinging(ratio=5.0, diameter=0.6, width=0.05, density=7800.0), "t")
        found = values(document)
        assert found["J_own[kg*m^2]"] == pytest.approx(1)
        assert "1 kg*m^2 on its own shaft, turning 5 times as fast" in text(document, "flywheel needed")
        d, b, h = (found[f"rim_{name}[m]"] for name in ("mean_diameter", "width", "thickness"))
        assert (d, b) == (0.6, 0.05)
        assert found["rim_outer_diameter[m]"] == pytest.approx(d + h)
        mass = 7800 * math.pi * d * h * b
        assert mass * (d**2 + h**2) / 4 == pytest.approx(0.9)  # the rim's share of the inertia
        assert found["rim_mass[kg]"] == pytest.approx(mass)
        assert found["rim_total_mass[kg]"] == pytest.approx(mass / 0.85)
        assert found["rim_thin_mass[kg]"] == pytest.approx(4 / d**2)
        fast = 5 * self.MEAN * 1.01
        assert found["omega_flywheel_max[rad/s]"] == pytest.approx(fast)
        assert found["rim_speed[m/s]"] == pytest.approx(fast * (d + h) / 2)
        assert found["rim_stress[Pa]"] == pytest.approx(7800 * (fast * d / 2) ** 2)
        assert found["rim_safety"] == pytest.approx(found["rim_strength[Pa]"] / found["rim_peak_stress[Pa]"])
        assert f"width 50 mm, thickness {1000 * h:.5g} mm" in text(document, "its rim")

    def test_the_other_shafts_beside_it(self) -> None:
        """25 kg*m^2 on the input shaft are 1 on a motor 5 times as fast; sizes are those of the asked shaft alone."""
        found = solve_flywheel(
            Machine(
                sine(self.M1),
                ConstantInertia(),
                task(self.DELTA, diameter=1.2, width=0.1),
                None,
                self.MEAN,
                1.0,
                motor_ratio=5.0,
            )
        )
        document = flywheel_summary(found, "t")
        assert values(document)["J_motor_shaft[kg*m^2]"] == pytest.approx(1)
        d = values(document)["motor_shaft_rim_mean_diameter[m]"]
        mass = values(document)["motor_shaft_rim_mass[kg]"]
        assert mass * (d**2 + (0.1 * d) ** 2) / 4 == pytest.approx(0.9)  # thickness a tenth of the diameter
        back = flywheel_summary(self.swinging(ratio=5.0, shaft="other"), "t")
        assert text(back, "or on the input shaft").startswith("25 kg*m^2\nrim: mean diameter ")
        assert text(document, "or on the motor shaft").startswith("1 kg*m^2, turning 5 times as fast as the input\n")
        rim = values(document)
        assert text(document, "inertia of the rim").startswith("22.5 kg*m^2, 90 % of the wheel's")
        h, b = rim["rim_thickness[m]"], rim["rim_width[m]"]
        ring = math.pi * rim["rim_density[kg/m^3]"] * b * ((1.2 + h) ** 4 - (1.2 - h) ** 4) / 32
        assert rim["rim_inertia[kg*m^2]"] == pytest.approx(ring)

    def test_the_textbook_by_its_table(self) -> None:
        """On 4 positions the trapezoid rule gives A = 0, M h/2, M h, M h/2: J_F = M1 h/(delta omega^2), h = pi/2."""
        found = solve_flywheel(
            Machine(sine(self.M1), ConstantInertia(), task(self.DELTA), None, self.MEAN, 1.0, steps=4)
        )
        document = flywheel_document(found, "t")
        by_table = self.M1 * math.pi / 2 / (self.DELTA * self.MEAN**2)
        assert values(document)["J_F_by_table[kg*m^2]"] == pytest.approx(by_table)
        assert f"{100 * (math.pi / 4 - 1):+.3g} % against the exact tangents" in text(document, "textbook by its table")
        unequal = flywheel_document(self.swinging(), "t")
        assert "textbook by its table" not in [fact.label for fact in unequal.facts]

    def test_places_follow_the_sense_of_the_input(self) -> None:
        document = flywheel_document(replace(self.swinging(), sense=-1.0), "t")
        assert column(document, "max_at[deg]") == [pytest.approx(-180)] * 5
        assert math.copysign(1.0, column(document, "min_at[deg]")[0]) == 1.0
        assert "tangents touch at phi = -180 and 0 deg" in text(document, "energy-mass curve")

    def test_the_flywheel_that_is_there(self) -> None:
        light, heavy = (flywheel_summary(self.swinging(inertia=value, ratio=2.0), "t") for value in (6.0, 7.0))
        assert values(light)["J_existing[kg*m^2]"] == 24
        assert text(light, "flywheel there") == (
            "24 kg*m^2 at the input shaft, 6 kg*m^2 on its own shaft: too light by 1 kg*m^2"
        )
        assert any(note.startswith("warning") for note in light.notes)
        assert text(heavy, "flywheel there").endswith(": it does")
        assert values(heavy)["existing_suffices"] is True

    def test_none_is_needed(self) -> None:
        document = flywheel_document(self.swinging(at_hand=30.0), "t")
        assert text(document, "flywheel needed").startswith("none: with what is at hand delta is 0.01666")
        assert values(document)["delta_reached"] == pytest.approx(0.02 * 25 / 30)
        assert list(document.table.headers if document.table else ()) == [
            "method",
            "J_F[kg*m^2]",
            "max_at[deg]",
            "min_at[deg]",
        ]
        assert document.notes == ()
        assert not any("no flywheel needed" in fact.text for fact in document.facts)
        assert "its rim" not in [fact.label for fact in document.facts]
        assert values(document)["J_add[kg*m^2]"] == 0

    @pytest.mark.parametrize(
        ("delta", "said"),
        [
            (1 / 20, "0.05 = 1/20, customary for pumps, presses, crushers"),
            (1 / 30, "pumps, presses, crushers; metal-cutting machine tools"),
            (1 / 1000, "0.001 = 1/1000, not customary for any kind of machine"),
        ],
    )
    def test_the_allowed_unevenness(self, delta: float, said: str) -> None:
        assert said in text(flywheel_summary(self.swinging(delta=delta), "t"), "allowed delta")

    def test_the_inertia_that_the_motor_needs_keeps_delta(self, upsetting: Document) -> None:
        """Marched in energy over the angle until a turn repeats the one before."""
        given, found = CASES["dyn-upsetter-flywheel-motor"]["inputs"], values(upsetting)
        speed = marched(found["J_F[kg*m^2]"], *parabola())
        delta = 2 * (speed.max() - speed.min()) / (speed.max() + speed.min())
        assert delta == pytest.approx(given["delta_allowed"], rel=1e-5)
        assert found["omega_mean[rad/s]"] == pytest.approx((speed.max() + speed.min()) / 2, rel=1e-6)
        assert found["J_add[kg*m^2]"] == pytest.approx(found["J_F[kg*m^2]"] - given["J_const_initial"])

    def test_the_methods_under_the_motor(self, upsetting: Document) -> None:
        found = values(upsetting)
        whole, reached = column(upsetting, "J_F[kg*m^2]"), column(upsetting, "delta_motor")
        for inertia, delta, error in zip(whole, reached, column(upsetting, "error[%]"), strict=True):
            speed = marched(inertia, *parabola())
            assert delta == pytest.approx(2 * (speed.max() - speed.min()) / (speed.max() + speed.min()), rel=1e-5)
            assert error == pytest.approx(100 * (inertia / found["J_F[kg*m^2]"] - 1))

    def test_bounds_and_correction(self, upsetting: Document) -> None:
        found = values(upsetting)
        history = found["correction"]
        assert history[0]["J[kg*m^2]"] == 10.6
        for now, after in pairwise(history):
            assert after["J[kg*m^2]"] == pytest.approx(now["J[kg*m^2]"] * now["delta"] / 0.08)
        assert history[-1]["J[kg*m^2]"] < found["J_F[kg*m^2]"]  # it comes near from below, delta from above
        steps_said = text(upsetting, "correction (3.60)")
        assert all(
            f"{step['J[kg*m^2]']:.4g} ({step['delta']:.4g})" in steps_said.replace("\n", " ") for step in history
        )
        low, high = text(upsetting, "bounds of J_F").splitlines()[1:]
        assert low.endswith("too little")
        assert high.startswith(f"{found['J_F[kg*m^2]']:.7g} kg*m^2: delta = 0.08")
        assert found["monotone"] is True

    def test_a_machine_that_stalls_shows_it_in_the_table(self) -> None:
        result = upset()
        rows = (*result.rows[:-1], replace(result.rows[-1], delta=None))
        document = flywheel_summary(replace(result, rows=rows), "t")
        assert column(document, "delta_motor")[-1] == "stalls"
        (last,) = [line for line in lines(document) if line.startswith("excess work")]
        assert "stalls" in last
        assert max(map(len, lines(document))) <= 80


def marched(constant: float, a: float, b: float, count: int = 1200) -> np.ndarray:
    """Speeds of the upsetter in its eighth turn, by Runge-Kutta in E = J omega^2/2; its load falls off on a node."""
    h, energy, speeds = TURN / count, constant * 10.3**2 / 2, np.empty(count + 1)
    ends = (np.arange(count) * h + 1e-9, (np.arange(count) + 0.5) * h, (np.arange(count) + 1) * h)
    stages = np.moveaxis(np.array([upsetter(phi) for phi in ends]), 2, 0).tolist()  # a step begins behind the jump
    for _ in range(8):
        start = energy
        for k, ((j1, m1), (j2, m2), (j3, m3)) in enumerate(stages):
            speeds[k] = math.sqrt(2 * energy / (constant + j1))
            k1 = a + m1 - 2 * b * energy / (constant + j1)
            k2 = a + m2 - 2 * b * (energy + h / 2 * k1) / (constant + j2)
            k3 = a + m2 - 2 * b * (energy + h / 2 * k2) / (constant + j2)
            k4 = a + m3 - 2 * b * (energy + h * k3) / (constant + j3)
            energy += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
        speeds[-1] = math.sqrt(2 * energy / (constant + stages[-1][2][0]))
    assert energy == pytest.approx(start, rel=1e-7)
    return speeds


class TestMotion:
    def swinging(self, sense: float = 1.0) -> Motion:
        """A load M1 sin(phi) on 25 kg*m^2 at 20 rad/s: omega^2 = omega_min^2 + 2 M1 (1 - cos phi)/J."""
        inertia = ConstantInertia(flywheel=25.0)
        return solve_motion(sine(100.0), None, inertia, None, 20.0, positions(24, sense))

    def steady(self, load: float = -30.0) -> Motion:
        """A constant load on 4 kg*m^2 under M = 500 - 2 omega^2, and nothing when idle."""
        motor = Parabolic(500.0, 2.0, math.sqrt(250.0), 15.0)
        inertia = ConstantInertia(rotor=1.0, gears=3.0)
        given = steps((load, load)), steps((0.0, 0.0))
        return solve_motion(*given, replace(inertia, further=-1.0), Driver(motor, 0.0), 15.0, positions(12))

    def test_a_sine_of_load(self) -> None:
        document = motion_summary(self.swinging(), "t")
        found = values(document)
        assert found["delta"] == pytest.approx(0.02)
        assert text(document, "delta") == "0.02 = 1/50, coefficient of speed fluctuation"
        assert text(document, "speed") == "min 19.8 rad/s at phi = 0 deg\nmax 20.2 rad/s at phi = 180 deg"
        phi = np.arange(4096) * TURN / 4096
        omega = np.sqrt(19.8**2 + 8 * (1 - np.cos(phi)))
        assert found["cycle_time[s]"] == pytest.approx(np.mean(1 / omega) * TURN)
        assert found["omega_time_mean[rad/s]"] == pytest.approx(1 / np.mean(1 / omega))
        assert found["omega_mean[rad/s]"] == pytest.approx(20)
        assert (found["drive"], found["J_c[kg*m^2]"]) == ("positional", 25)
        assert text(document, "stability").startswith("indifferent")
        assert "recurrence (3.57)" not in [fact.label for fact in document.facts]

    def test_places_follow_the_sense_of_the_input(self) -> None:
        document = motion_summary(self.swinging(-1.0), "t")
        assert text(document, "speed").endswith("max 20.2 rad/s at phi = -180 deg")
        assert values(document)["omega_max_at_phi[deg]"] == pytest.approx(-180)

    def test_a_constant_load_under_a_parabola(self) -> None:
        document = motion_summary(self.steady(), "t")
        found, omega = values(document), math.sqrt(470 / 2)
        assert text(document, "delta").splitlines()[0] == "0, coefficient of speed fluctuation"
        assert found["omega_mean[rad/s]"] == pytest.approx(omega)
        assert found["cycle_time[s]"] == pytest.approx(TURN / omega)
        assert (found["M_d_mean[N*m]"], found["M_d_rms[N*m]"]) == (pytest.approx(30), pytest.approx(30))
        assert text(document, "driving moment") == "30 N*m everywhere"
        assert found["P_mean[W]"] == pytest.approx(30 * omega)
        assert (found["J_c[kg*m^2]"], found["J_rotor[kg*m^2]"], found["J_gears[kg*m^2]"]) == (3, 1, 3)
        left = math.exp(-2 * 2 * TURN / 4)  # of E, for dE/dphi = ... - (2 B/J) E
        assert found["multipliers"] == [[pytest.approx(left), 0]]
        assert text(document, "stability") == f"stable: {100 * left:.3g} % of a deviation is left after a cycle"
        assert found["omega_idle_max[rad/s]"] == pytest.approx(math.sqrt(250))
        assert found["P_idle_mean[W]"] == pytest.approx(0, abs=1e-9)
        assert found["error"]["speed"] < 1e-12

    def test_the_shaper_of_the_textbook(self) -> None:
        """Idle run: the exact regime, and the recurrence (3.57) on 24 positions with its history."""
        case = CASES["dyn-shaper-motion-idle"]
        given, expected = case["inputs"], case["expected"]
        motor = Motor("4A132S4", given["P_N_W"], given["n_N_rpm"] * RPM, given["n_sync_rpm"] * RPM)
        driver = driver_of(motor, "parabolic", given["u_R"])
        inertia = ConstantInertia(further=given["J_const"])
        document = motion_summary(solve_motion(shaper(), None, inertia, driver, 5.76, positions(24)), "t")
        found, exact = values(document), expected["continuous_reference"]
        assert found["delta"] == pytest.approx(exact["delta"], abs=2e-6)
        assert found["omega_min[rad/s]"] == pytest.approx(exact["omega_min"], abs=1e-5)
        assert found["omega_max[rad/s]"] == pytest.approx(exact["omega_max"], abs=1e-5)
        assert math.radians(found["omega_max_at_phi[deg]"]) == pytest.approx(exact["phi_max_rad"], abs=2e-3)
        assert found["cycle_time[s]"] == pytest.approx(exact["T_s"], rel=1e-6)
        assert (found["A[N*m]"], found["B[N*m*s^2/rad^2]"]) == (
            pytest.approx(expected["A"], rel=1e-6),
            pytest.approx(expected["B"], rel=1e-6),
        )
        assert found["delta_textbook"] == pytest.approx(expected["delta_n24"], abs=1e-6)
        assert found["textbook_first[rad/s]"][0] == pytest.approx(expected["omega_N"], abs=1e-6)
        assert found["textbook_last[rad/s]"][0] == pytest.approx(expected["omega_first_rev_from_omega_N"][-1], abs=1e-5)
        nodes = np.array(expected["omega_periodic_n24"]), np.array(exact["omega_at_nodes"])
        worst = np.max(np.abs(nodes[0] - nodes[1])) / np.mean(nodes[1])
        assert found["omega_textbook_error"] == pytest.approx(worst, rel=1e-3)
        said = text(document, "recurrence (3.57)")
        assert f"speed least in position {expected['i_min']}, largest in {expected['i_max']}" in said
        (off,) = re.findall(r"([+-][0-9.]+) % against the exact one", said)
        assert float(off) == pytest.approx(100 * (expected["delta_n24"] / exact["delta"] - 1), abs=5e-3)
        assert "settles within 0.0001 rad/s in 2 turns" in said

    def test_a_long_history_is_cut(self) -> None:
        motion = self.steady()
        assert motion.textbook is not None
        turns = motion.textbook.turns[:1] * 9
        document = motion_summary(replace(motion, textbook=replace(motion.textbook, turns=turns)), "t")
        assert "in 9 turns" in text(document, "recurrence (3.57)")
        assert text(document, "recurrence (3.57)").count("->") == 6
        assert len(values(document)["textbook_first[rad/s]"]) == 9

    def test_a_coarse_step_of_the_recurrence_is_told(self) -> None:
        said = text(motion_summary(self.steady(), "t"), "recurrence (3.57)")
        ratio = 2 * TURN / 12 / 4
        assert f"largest B dphi/J = {ratio:.4g}" in said
        assert ("take more positions" in said) == (ratio > 1)

    def test_the_table(self) -> None:
        document = motion_document(self.swinging(), "t", rows=[0, 12])
        assert document.table is not None
        headers = ["i", "phi[deg]", "omega[rad/s]", "eps[rad/s^2]", "t[s]", "M_d[N*m]", "M_load[N*m]"]
        assert list(document.table.headers) == [*headers, "omega_textbook[rad/s]"]
        assert column(document, "omega[rad/s]") == [pytest.approx(19.8), pytest.approx(20.2)]
        assert column(document, "i") == ["0", "12"]
        idle = motion_document(self.steady(), "t", patterns=["phi", "omega_*"])
        assert list(idle.table.headers if idle.table else ()) == [
            "i",
            "phi[deg]",
            "omega_idle[rad/s]",
            "omega_textbook[rad/s]",
        ]
        with pytest.raises(UsageError):
            motion_document(self.steady(), "t", patterns=["nothing"])

    def test_verdicts_are_notes(self) -> None:
        motion = replace(self.steady(), verdicts=(Verdict("warning", "overload"), Verdict("note", "well")))
        assert motion_summary(motion, "t").notes == ("warning: overload", "note: well")


def test_a_run_says_everything_once(tmp_path: Path) -> None:
    """Facts of a run that share a label say the same: nothing of a later stage is lost."""
    file = tmp_path / "machine.toml"
    file.write_text(spec_text())
    found = run(load_spec(file))
    documents = {
        "power": power_summary(found.results["power"], "power"),
        "flywheel": flywheel_summary(found.results["flywheel"], "flywheel"),
        "motion": motion_summary(found.results["motion"], "motion"),
    }
    parts = {part.title: part for part in run_document(found, "t").parts}
    for stage, document in documents.items():
        assert parts[stage].facts == with_errors(document, found.record(stage).error).facts
        assert parts[stage].notes == document.notes
    assert max(map(len, lines(run_document(found, "t")))) <= 80


def test_a_stored_run_reads_the_same(tmp_path: Path) -> None:
    file = tmp_path / "machine.toml"
    file.write_text(spec_text())
    out, events = tmp_path / "out", list[Event]()
    first = run(load_spec(file), out=out)
    second = run(load_spec(file), out=out, on_event=events.append)
    assert [event.kind for event in events if event.stage in ("power", "flywheel", "motion")] == ["loaded"] * 3
    made: dict[str, Callable[..., Document]] = {
        "power": power_document,
        "flywheel": flywheel_document,
        "motion": motion_document,
    }
    for stage, make in made.items():
        assert list(lines(make(first.results[stage], "t"))) == list(lines(make(second.results[stage], "t")))
