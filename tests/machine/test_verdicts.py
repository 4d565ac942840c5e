"""Verdicts on a regime: overload, pull-out, heating, generator braking, range of the formula, settling."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from machine.motion import TURN, Constant, Line, Motor, of_pieces, upsetter, upsetter_motor
from tmmcalc.machine.positional import positional
from tmmcalc.machine.steady import driven
from tmmcalc.machine.verdicts import Verdict, verdicts

KLOSS = upsetter_motor("kloss")


def said(found: tuple[Verdict, ...], severity: str) -> str:
    return " | ".join(verdict.message for verdict in found if verdict.severity == severity)


def test_a_sound_regime_has_no_warning() -> None:
    found = verdicts(driven(upsetter(), 300.0, KLOSS), KLOSS)
    assert said(found, "warning") == ""
    assert "largest driving moment" not in said(found, "note")


def test_overload_then_pull_out() -> None:
    mild = verdicts(driven(upsetter(), 30.6, KLOSS), KLOSS)
    assert "overload" in said(mild, "warning")
    assert "9.46749" in said(mild, "warning")
    place = np.degrees(driven(upsetter(), 30.6, KLOSS).theta_min)
    assert f"at phi = {place:.4g} deg is below" in said(mild, "warning")
    clockwise = verdicts(driven(upsetter(), 30.6, KLOSS), KLOSS, -1.0)
    assert f"at phi = -{place:.4g} deg is below" in said(clockwise, "warning")
    assert "pull-out" not in said(mild, "warning")
    assert "largest driving moment" in said(mild, "note")
    bad = verdicts(driven(upsetter(), 4.0, KLOSS), KLOSS)
    assert "pull-out" in said(bad, "warning")
    assert "overload" not in said(bad, "warning")
    assert bad[0].severity == "warning"
    assert str(bad[0]).startswith("warning: ")


def test_a_motor_too_weak_and_one_too_hot() -> None:
    motor = Line(10.7, 10.0, stiffness=100.0)
    weak = verdicts(driven(of_pieces([-80.0], [0.0, TURN]), 5.0, motor), motor)
    assert "too weak" in said(weak, "warning")
    cycle = of_pieces([-180.0, 0.0], [0.0, 2.0, TURN])
    hot = verdicts(driven(cycle, 1.0, motor), motor)
    assert "heating" in said(hot, "warning")
    assert "too weak" not in said(hot, "warning")
    calm = driven(of_pieces([-70.0], [0.0, TURN]), 5.0, motor)  # exactly the rated load: kept
    assert verdicts(calm, motor) == ()


def test_generator_braking_and_the_range_of_a_formula() -> None:
    parabola = upsetter_motor("par")
    found = verdicts(driven(upsetter(0.0), 1.0, parabola), parabola)
    assert "generator" in said(found, "note")
    assert "holds up to" in said(found, "note")
    low = verdicts(driven(upsetter(), 30.6, parabola), parabola)
    assert "holds from 10 rad/s" in said(low, "warning")


def test_settling() -> None:
    slow = verdicts(driven(upsetter(), 1e4, KLOSS), KLOSS)
    assert "settles slowly" in said(slow, "note")
    regime = positional(upsetter(), 30.0, 10.0)
    assert "governor" in said(verdicts(regime, KLOSS), "note")
    unstable = replace(regime, stable=False, multipliers=(1.5 + 0j,))
    assert "grows 1.5 times" in said(verdicts(unstable, KLOSS), "warning")


def test_unknown_speeds_are_left_out() -> None:
    cycle = replace(of_pieces([0.0], [0.0, TURN]), quadratic=np.full((12, 16), -0.5))
    motor = Constant(value=50.0)
    assert verdicts(driven(cycle, 1.0, motor), motor) == ()
    assert isinstance(motor, Motor)
