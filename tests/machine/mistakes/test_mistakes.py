"""Mistakes in works, power and flywheel, worked out again from the reduced moments and inertias of the positions."""

from __future__ import annotations

import math

import numpy as np
import pytest
from mistakes import CONFIGS, right, wrong

from tmmcalc.core.numerics.simpson import simpson
from tmmcalc.pipeline.runner import run
from tmmcalc.project import load_spec

FINE = ("mechanism.grid.positions=3600",)


def moments(name: str, sets: tuple[str, ...] = ()) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Angle from position 0, sum of the reduced moments [N*m], reduced inertia of a machine."""
    found = run(load_spec(CONFIGS / f"{name}.toml", sets), target="reduction").results["reduction"]
    return found.phi, found.total, found.inertia


def loads(name: str, sets: tuple[str, ...] = ()) -> tuple[np.ndarray, np.ndarray]:
    """Angle and the reduced moment of the technological loads alone."""
    found = run(load_spec(CONFIGS / f"{name}.toml", sets), target="reduction").results["reduction"]
    kinds = [each.kind == "load" for each in found.contributions]
    return found.phi, found.moment[kinds].sum(axis=0)


def test_works_by_trapezoids() -> None:
    phi, moment = loads("shaper")
    own = float(np.sum(moment[1:] + moment[:-1]) * (phi[1] - phi[0]) / 2)
    (got,) = wrong("shaper", "machine.trapezoid_rule", "power.A_c J")
    assert got == pytest.approx(own, rel=1e-10)
    assert got != pytest.approx(right("shaper", "power.A_c J")[0], rel=1e-3)
    assert simpson(phi, moment) is not None


def test_work_of_half_a_cycle() -> None:
    phi, moment = loads("press", FINE)
    half = phi <= math.pi + 1e-9
    own = float(np.sum((moment[half][1:] + moment[half][:-1]) * np.diff(phi[half])) / 2)
    assert wrong("press", "machine.half_cycle", "power.A_c J") == pytest.approx([own], rel=2e-3)


@pytest.mark.slow
def test_power_of_the_motor() -> None:
    mean, needed, eta = right("course-project", "power.P_mean W", "power.P_required W", "power.eta_gears ")
    assert needed == pytest.approx(mean / eta)
    asked = "power.P_required W"
    assert wrong("course-project", "machine.gears_efficiency_left_out", asked) == pytest.approx([mean])
    assert wrong("course-project", "machine.gears_efficiency_multiplied", asked) == pytest.approx([mean * eta])
    time, power = right("press", "power.cycle_time s", "power.P_mean W")
    assert wrong("press", "machine.power_per_turn", "power.P_mean W") == pytest.approx([power * time])


@pytest.mark.slow
def test_inertia_of_the_rotor() -> None:
    rotor, ratio, reduced = right("course-project", "power.J_R kg*m^2", "power.u ", "power.J_rotor kg*m^2")
    assert reduced == pytest.approx(rotor * ratio**2)
    asked = "power.J_rotor kg*m^2", "flywheel.J_at_hand kg*m^2"
    for mistake, own in (("rotor_ratio_not_squared", rotor * ratio), ("rotor_not_reduced", rotor)):
        got, at_hand = wrong("course-project", f"machine.{mistake}", *asked)
        gears = right("course-project", "flywheel.J_gears kg*m^2")[0]
        assert (got, at_hand) == pytest.approx((own, own + gears))


@pytest.mark.slow
def test_flywheel_on_its_own_shaft() -> None:
    addition, own, ratio, mass = right(
        "course-project",
        "flywheel.J_add kg*m^2",
        "flywheel.J_own kg*m^2",
        "flywheel.ratio_flywheel ",
        "flywheel.rim_mass kg",
    )
    assert own == pytest.approx(addition / ratio**2)
    asked = "flywheel.J_own kg*m^2", "flywheel.rim_mass kg"
    got, heavier = wrong("course-project", "machine.flywheel_ratio_not_squared", *asked)
    assert got == pytest.approx(addition / ratio)
    assert heavier > 5 * mass
    assert wrong("course-project", "machine.flywheel_not_reduced", asked[0]) == pytest.approx([addition])
    at_hand = right("course-project", "flywheel.J_at_hand kg*m^2")[0]
    total = "flywheel.J_F kg*m^2", "flywheel.J_add kg*m^2"
    assert wrong("course-project", "machine.at_hand_not_taken_off", *total) == pytest.approx(
        [addition + at_hand, addition + at_hand]
    )


def test_flywheel_without_the_links() -> None:
    """J_F = (A_max - A_min)/(delta w^2), A from the moments of all causes and the constant one that drives."""
    phi, moment, _ = moments("press", FINE)
    step = phi[1] - phi[0]
    excess = np.concatenate(([0.0], np.cumsum((moment[1:] + moment[:-1]) * step / 2)))
    excess = excess - excess[-1] * phi / (2 * math.pi)
    speed, delta = right("press", "reduction.speed rad/s", "flywheel.delta_allowed ")
    (got,) = wrong("press", "machine.links_left_out", "flywheel.J_F kg*m^2")
    assert got == pytest.approx(float(np.ptp(excess)) / (delta * speed**2), rel=2e-3)


def test_speed_not_squared_and_half_of_the_range() -> None:
    exact, speed = right("press", "flywheel.J_F kg*m^2", "reduction.speed rad/s")
    assert wrong("press", "machine.mean_speed_not_squared", "flywheel.J_F kg*m^2") == pytest.approx([exact * speed])
    doubled = right(
        "press", "flywheel.J_F kg*m^2", sets=(f"flywheel.delta={2 * right('press', 'flywheel.delta_allowed ')[0]}",)
    )
    assert wrong("press", "machine.delta_of_half_range", "flywheel.J_F kg*m^2") == pytest.approx(doubled)
    least, largest, mean = right(
        "shaper", "motion.omega_min rad/s", "motion.omega_max rad/s", "motion.omega_mean rad/s"
    )
    (got,) = wrong("shaper", "machine.delta_read_halved", "motion.delta ")
    assert got == pytest.approx((largest - least) / 2 / mean)


@pytest.mark.slow
def test_mass_of_the_rim() -> None:
    """The thin rim has J = m D^2/4."""
    inertia, diameter = right("course-project", "flywheel.rim_inertia kg*m^2", "flywheel.rim_mean_diameter m")
    asked = "flywheel.rim_thin_mass kg"
    own = right("course-project", "flywheel.J_own kg*m^2")[0]
    assert right("course-project", asked) == pytest.approx([4 * own / diameter**2], rel=1e-6)
    assert wrong("course-project", "machine.rim_radius_for_diameter", asked) == pytest.approx(
        [own / diameter**2], rel=1e-6
    )
    assert wrong("course-project", "machine.disk_for_rim", asked) == pytest.approx([8 * own / diameter**2], rel=1e-6)
    assert inertia < own


def test_flywheel_of_the_positions_alone() -> None:
    """The extremes between the positions are missed: with many positions nothing is."""
    exact = right("press", "flywheel.J_F kg*m^2")[0]
    coarse, fine = (
        wrong("press", "machine.nodal_flywheel", "flywheel.J_F kg*m^2", sets=(f"mechanism.grid.positions={n}",))[0]
        for n in (12, 720)
    )
    assert abs(fine / exact - 1) < 0.005 < abs(coarse / exact - 1)
