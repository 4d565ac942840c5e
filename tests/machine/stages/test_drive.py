"""A train without a ratio: that of motor and crank; a motor that is chosen with it, in rounds."""

from __future__ import annotations

import math
from dataclasses import replace
from fractions import Fraction
from functools import cache
from types import SimpleNamespace
from typing import Any

import pytest
from gears.stages.trains import STEEL
from machines import MOTOR, spec_text

import tmmcalc
from tmmcalc.core.errors import NoSolutionError, SpecError
from tmmcalc.core.plan import plan
from tmmcalc.machine.driveline import DriveLine
from tmmcalc.machine.facts.drive import summary
from tmmcalc.machine.model import Gears
from tmmcalc.machine.motors.model import Motor
from tmmcalc.machine.settled import Settled, settled
from tmmcalc.pipeline.outcome import RunResult
from tmmcalc.pipeline.runner import run

TRAIN = 'layout = "AIbar"\nplanets = 2'
NO_GEARS = ("[transmission]\nefficiency = 1.0\ninertia = 0.4\n", "")
CHOOSE = '[motor]\nname = "choose"\nsynchronous_speed = "1500 rpm"\n'
RPM = math.pi / 30


def text(train: str = TRAIN, motor: str = MOTOR, more: str = "") -> str:
    gears = f"[train]\n{train}\nsum_max = 160\n[strength]\n{STEEL}\n"
    return spec_text(motor=motor, existing="1 kg*m^2", more=gears + more).replace(*NO_GEARS)


@cache
def done(train: str = TRAIN, motor: str = MOTOR, more: str = "", target: str = "power") -> RunResult:
    return run(tmmcalc.parse_spec(text(train, motor, more)), target=target)


def test_the_ratio_is_that_of_the_speeds() -> None:
    results = done().results
    request = results["train"].variants[0].request
    assert request.nominal == Fraction(1420, 90).limit_denominator(10**6)
    assert request.origin == "1420 rpm of motor motor over 90 rpm of the crank"
    given = run(tmmcalc.parse_spec(text(TRAIN + '\nratio = "1420/90"')), target="power").results
    assert given["criteria"].winner == results["criteria"].winner
    assert results["power"].duty.ratio == float(results["criteria"].winner.ratio)


def test_a_ratio_that_is_given_wins() -> None:
    spec = tmmcalc.parse_spec(text(TRAIN + '\nratio = "15"'))
    assert plan(spec).step("drive").reason == "the ratio of the train is given"
    drive = done(more="[transmission]\nratio = 14\n").results
    assert drive["train"].variants[0].request.nominal == 14
    assert drive["power"].duty.ratio == 14
    shafts = "[[shafts]]\nratio = 12\nstiffness = 1e4\n"
    assert done(more=shafts).results["train"].variants[0].request.nominal == 12


@pytest.mark.parametrize(("layout", "kind", "sign"), [("unfolded2", "u", 1), ("AI", "i_1H", 1), ("AII", "i_14", 1)])
def test_every_layout_takes_the_sign_that_it_can_have(layout: str, kind: str, sign: int) -> None:
    request = done(f'layout = "{layout}"\ntolerance = "2 %"', target="train").results["train"].variants[0].request
    assert (request.kind, request.nominal) == (kind, sign * Fraction(1420, 90).limit_denominator(10**6))


def test_a_layout_that_turns_back() -> None:
    request = done('layout = "AA"\ntolerance = "2 %"', target="train").results["train"].variants[0].request
    assert request.nominal == -Fraction(1420, 90).limit_denominator(10**6)


def test_a_layout_that_cannot() -> None:
    with pytest.raises(NoSolutionError, match="layout AI cannot have the ratio"):
        done('layout = "AI"\nratio_kind = "i_H1"')


def test_a_chosen_motor_and_its_train_ask_for_each_other() -> None:
    """The motor by its name leads to the train; the efficiency and the inertia of the train lead to the motor."""
    results = done(motor=CHOOSE).results
    duty, winner, drive = results["power"].duty, results["criteria"].winner, results["drive"]
    assert duty.motor.name == drive.found.motor.name
    assert drive.rounds[-1].train == winner.name
    assert duty.judged[-1].reason == ""
    assert f"settled in {len(drive.rounds)} round" in summary(drive, "drive").facts[1].text
    by_name = done(motor=CHOOSE.replace("choose", duty.motor.name).replace('synchronous_speed = "1500 rpm"\n', ""))
    assert by_name.results["criteria"].winner == winner
    assert by_name.results["power"].motor_power == results["power"].motor_power
    gears = f"[transmission]\nefficiency = {winner.values['efficiency']!r}\ninertia = {winner.on_crank!r}\n"
    alone = run(tmmcalc.parse_spec(text(motor=CHOOSE).split("[train]")[0] + gears), target="power").results
    assert alone["power"].duty.motor.name == duty.motor.name


class Fake:
    """A motor that was chosen, for trials of the rounds alone."""

    def __init__(self, motor: Motor) -> None:
        self.motor = motor

    def told(self) -> Any:
        return SimpleNamespace(motor=self.motor)


WEAK, STRONG = Motor("weak", 1000.0, 100.0), Motor("strong", 2000.0, 150.0)


def trained(speed_of: dict[float, float]) -> Any:
    """Trains by the ratio: of each efficiency."""
    return lambda ratio, whose: SimpleNamespace(
        name=f"u {ratio:g}", values={"efficiency": speed_of[ratio]}, on_crank=0.1, to_crank=ratio
    )


def test_rounds_end_when_the_motor_comes_again() -> None:
    """Without losses the weak one does; the train of the weak one asks for the strong one, and its own for it too."""

    def choose(line: DriveLine) -> Any:
        return Fake(WEAK if line.efficiency == 1 else STRONG)

    found: Settled = settled(Gears(), 10.0, choose, trained({10.0: 0.9, 15.0: 0.95}))
    assert [each.motor for each in found.rounds] == ["weak", "strong"]
    assert (found.ratio, found.alternating) == (15.0, ())


def test_motors_that_come_in_turn_end_with_the_strongest() -> None:
    def choose(line: DriveLine) -> Any:
        return Fake(WEAK if line.efficiency > 0.92 else STRONG)

    found = settled(Gears(), 10.0, choose, trained({10.0: 0.9, 15.0: 0.95}))
    assert found.alternating == ("weak", "strong")
    assert found.found is not None
    assert (found.ratio, found.found.motor.name) == (15.0, "strong")
    plain = replace(found, found=None)
    assert any("come in turn" in note for note in summary(plain, "drive").notes)


@pytest.mark.parametrize(
    ("train", "more", "words"),
    [
        ('layout = "AI"\nratio_kind = "u"', "", "is not the ratio of the speeds of motor and crank"),
        ('layout = "AI"', "moment_ratio = 30\n", "what is left of the drive for the train is not known"),
    ],
)
def test_faults(train: str, more: str, words: str) -> None:
    with pytest.raises(SpecError, match=words):
        tmmcalc.parse_spec(text(train).replace("[strength]\n", f"[strength]\n{more}"))


def test_without_a_motor_the_train_needs_its_ratio() -> None:
    with pytest.raises(SpecError, match=r"a train has its ratio[\s\S]*\[motor\] beside \[mechanism\]"):
        tmmcalc.parse_spec(text(motor=""))
