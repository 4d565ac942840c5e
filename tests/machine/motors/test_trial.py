"""The motor that the machine chooses: against a loop over the catalogue, and a moment found by plain integration."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from machines import spec_text
from scipy.integrate import solve_ivp

import tmmcalc
from tmmcalc.core.errors import SpecError, TmmError
from tmmcalc.machine.facts.power import document as power_document
from tmmcalc.machine.judged import kept
from tmmcalc.machine.motors.catalogue import load_catalogue
from tmmcalc.pipeline.outcome import RunResult
from tmmcalc.pipeline.runner import run

CHOOSE = '[motor]\nname = "choose"\nsynchronous_speed = "1500 rpm"\ncharacteristic = "{}"\n'
LIGHT = "0.3 kg*m^2"  # of a flywheel that leaves much of the peak to the motor


@cache
def machine(motor: str = CHOOSE.format("parabolic"), more: str = "", existing: str = LIGHT) -> RunResult:
    return run(tmmcalc.parse_spec(spec_text(motor=motor, existing=existing, more=more)))


@pytest.mark.slow
def test_the_least_of_a_loop_over_the_catalogue() -> None:
    """Every motor of the speed is given by its name, and read off its own motion."""
    duty = machine().results["power"].duty
    assert duty.judged[-1].motor is duty.motor or duty.judged[-1].name == duty.motor.name
    judged = {each.name: each for each in duty.judged}
    works = []
    for motor in load_catalogue():
        if (
            motor.synchronous is None
            or abs(motor.rated_rpm / 1500 - 0.95) > 0.049
            or motor.power > 2 * duty.motor.power
        ):
            continue
        given = CHOOSE.format("parabolic").replace("choose", motor.name)
        given = given.replace('synchronous_speed = "1500 rpm"\n', "")
        try:
            found = machine(given).results
        except TmmError:
            continue
        side, power = found["motion"].motor, found["power"].motor_power
        start = found["power"].start_moment / found["power"].duty.ratio
        enough = motor.power >= power and side.heating <= 1 and motor.start is not None
        if enough and side.largest <= motor.overload * side.rated_moment and start <= motor.start * side.rated_moment:
            works.append(motor.power)
        if motor.name in judged and judged[motor.name].heating is not None:
            assert judged[motor.name].heating == pytest.approx(side.heating, rel=1e-9)
            assert judged[motor.name].peak == pytest.approx(side.largest / side.rated_moment, rel=1e-9)
    assert duty.motor.power == min(works)
    by_mean = next(each for each in duty.taken if each.rule == "mean power")
    assert by_mean.power < duty.motor.power, "a scene in which the mean power alone would not do"
    assert all("overheats" in each.reason for each in duty.judged if by_mean.power == each.power and each.heating)


@pytest.mark.slow
def test_the_rms_moment_by_plain_integration() -> None:
    """E' = M_d + M_c, t' = 1/omega from turn to turn until it repeats; the parabola is written out anew."""
    found = machine().results
    duty, cycle, line = found["power"].duty, found["reduction"].cycle, found["power"].line
    motor, u = duty.motor, duty.ratio
    total = found["motion"].inertia.total
    w_n, w_c = motor.speed / u, motor.synchronous / u
    b = motor.power / motor.speed * u / (w_c**2 - w_n**2)

    def rates(theta: float, y: np.ndarray) -> list[float]:
        at = np.array([theta])
        inertia = total + float(cycle.panels.at(cycle.inertia, at)[0])
        omega = np.sqrt(2 * y[0] / inertia)
        drive = b * (w_c**2 - omega**2)
        load = float(cycle.panels.at(cycle.moment, at)[0])
        own = drive / u * (1 / line.efficiency if drive > 0 else line.efficiency)
        return [drive + load, 1 / omega, own**2 / omega]

    energy = total * w_n**2 / 2
    for _ in range(30):
        turn = solve_ivp(rates, (0, cycle.period), [energy, 0.0, 0.0], rtol=1e-7, atol=1e-9)
        moved, energy = abs(turn.y[0, -1] / energy - 1), turn.y[0, -1]
        if moved < 1e-7:
            break
    rms = np.sqrt(turn.y[2, -1] / turn.y[1, -1])
    assert duty.judged[-1].heating == pytest.approx(rms / motor.nominal_moment, rel=1e-4)


def test_the_motor_that_is_chosen_is_not_warned_of() -> None:
    assert not any(
        "heating" in each.message or "pull-out" in each.message for each in machine().results["motion"].verdicts
    )
    weak = CHOOSE.format("parabolic") + "reserve = 0.8\n"
    larger = machine(weak).results["power"].duty
    assert larger.motor.power > machine().results["power"].duty.motor.power
    assert larger.judged[-1].heating * 1.8 <= 1
    assert "reserve" in next(each.reason for each in larger.judged if each.load < 1 < 1.8 * each.load)


@pytest.mark.slow
def test_a_start_under_load_asks_for_more() -> None:
    """A start against the whole load from the worst place."""
    start = '[[transients]]\nname = "under load"\nduration = "6 s"\nstart_angle = "200 deg"\n'
    heavy = start + 'brake = { moment = "%s N*m" }\n'
    plain = machine(CHOOSE.format("kloss"), start).results
    assert plain["power"].duty.judged[-1].starts is True
    moment = 3 * plain["power"].rated_moment
    braked = machine(CHOOSE.format("kloss"), heavy % f"{moment:.0f}").results
    duty = braked["power"].duty
    assert duty.motor.power > plain["power"].duty.motor.power
    refused = [each for each in duty.judged if each.starts is False]
    assert refused
    assert all(each.reason.startswith("under load: it stalls") for each in refused if kept(each.heating))
    assert braked["transient"].motions[0].end != "stall"


def test_with_an_asked_flywheel_the_motor_has_that_of_its_own_size() -> None:
    text = spec_text(motor=CHOOSE.format("parabolic")).replace('inertia = "3 kg*m^2"\n', "")
    found = run(tmmcalc.parse_spec(text)).results
    assert found["power"].duty.judged[-1].heating == pytest.approx(found["motion"].motor.heating, rel=1e-6)


def test_reserve_is_for_a_motor_that_is_chosen() -> None:
    with pytest.raises(SpecError, match="reserve beside a motor that is given"):
        tmmcalc.parse_spec(spec_text(more="") + "\nreserve = 0.2\n")


def test_every_rule_and_refusal_is_told() -> None:
    document = power_document(machine().results["power"], "power")
    told: dict[str, Any] = {key: value for fact in document.facts for key, value in fact.values.items()}
    assert {"mean power", "rms moment", "break-down moment"} <= {each["rule"] for each in told["rules"]}
    judged = {each["motor"]: each for each in told["judged"]}
    assert judged[told["motor"]]["refused"] == ""
    assert all(each["refused"] for name, each in judged.items() if name != told["motor"])
    texts = {fact.label: fact.text for fact in document.facts}
    assert "overheats" in texts["smaller ones"]
    assert "mean power" in texts["by each rule alone"]
    assert document.table is not None
    assert told["motor"] in document.table.columns[0]


@pytest.mark.parametrize("form", ["parabolic", "kloss"])
def test_a_motor_without_overload_ratio_is_refused_where_others_have_one(tmp_path: Path, form: str) -> None:
    """It comes first by its power; its datum is missing, which is no fault of the spec."""
    rows = ["name,power_kW,synchronous_rpm,speed_rpm,overload,start", "bare,2.2,1500,1420,,2", "full,3,1500,1420,2.2,2"]
    (tmp_path / "own.csv").write_text("\n".join(rows) + "\n", encoding="utf-8")
    motor = CHOOSE.format(form) + 'catalogue = "own.csv"\n'
    spec = tmmcalc.parse_spec(spec_text(motor=motor, existing="3 kg*m^2"), folder=tmp_path)
    duty = run(spec, target="power").results["power"].duty
    assert duty.motor.name == "full"
    (reason,) = (each.reason for each in duty.judged if each.name == "bare")
    assert "overload ratio" in reason
    assert "not known" in reason or "not given" in reason
