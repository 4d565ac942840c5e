"""The ready specs solved beside the package: closure equations, Newton and Euler, scipy on the equation of motion.

Of the package only the translated spec (links, joints, loads) and what an earlier stage hands on are used.
"""

from __future__ import annotations

import math
from functools import cache, cached_property
from typing import Any

import numpy as np
from linkage.forces.newton_euler import Motions, Solved, Values, dot, given_loads, motions, newton_euler, placements
from numpy.typing import NDArray
from scipy.integrate import solve_ivp
from scipy.interpolate import CubicSpline

import tmmcalc
from tmmcalc.linkage.loading import GearDrive, Load, Loading
from tmmcalc.linkage.loadlaws.constant import Constant
from tmmcalc.linkage.loadlaws.indicator import Indicator
from tmmcalc.linkage.loadlaws.polynomial import Polynomial
from tmmcalc.linkage.loadlaws.tabulated import Tabulated
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.tables.tasks.loading import to_loading
from tmmcalc.linkage.tables.tasks.mechanism import to_linkage
from tmmcalc.pipeline.outcome import RunResult
from tmmcalc.project import templates

Array = NDArray[Any]
TURN = 2 * math.pi


class Project:
    """A ready spec: its run, and the same from elsewhere."""

    def __init__(self, name: str) -> None:
        folder = templates.folder()
        text = (folder / f"{name}.toml").read_text(encoding="utf-8")
        # what a cam loads the crank with has checks of its own; these are of links alone
        self.spec = tmmcalc.parse_spec(text.replace('\nshaft = "crank"', ""), folder=folder)
        self.run: RunResult = tmmcalc.run(self.spec)

    @cached_property
    def mechanism(self) -> Mechanism:
        return to_linkage(self.spec.linkage)

    @cached_property
    def loading(self) -> Loading:
        return to_loading(self.spec)

    def moving(self, phi: Array) -> Motions:
        """The motion at input coordinates counted from position 0."""
        kinematics = self.run.results["kinematics"]
        return motions(self.mechanism, placements(self.mechanism, kinematics), kinematics.x[0] + phi)

    @cached_property
    def positions(self) -> Motions:
        """The motion in the positions of the kinematics."""
        return self.moving(np.asarray(self.run.results["kinematics"].phi))

    @cached_property
    def rows(self) -> Motions:
        """The motion in the rows of the forces, two of which may be one position."""
        return self.moving(np.asarray(self.run.results["forces"].phi))

    @cached_property
    def statics(self) -> Solved:
        """Newton's and Euler's equations of all links at once, friction as the package found it."""
        forces = self.run.results["forces"]
        names = [joint.name for joint in self.mechanism.joints]
        friction = {pair.joint: forces.friction[names.index(pair.joint)] for pair in self.loading.pairs}
        gear = self.loading.drive if isinstance(self.loading.drive, GearDrive) else None
        given = given_loads(self.rows, self.loading, forces.theta, self.values(self.rows))
        return newton_euler(self.rows, given, friction, gear, np.sign(forces.drive))

    def values(self, at: Motions) -> Values:
        """Laws that act on a part of the cycle alone."""
        along = (Indicator, Tabulated)
        windowed = (load for load in self.loading.loads if load.window is not None or isinstance(load.law, along))
        return {load.name: lambda theta, load=load: acting(load, theta, at) for load in windowed}

    @cached_property
    def smooth(self) -> Array:
        """Rows without a jump of a load: away from the angles of windows, and from the dead centres of strokes."""
        theta, clear = self.run.results["forces"].theta, 1e-6
        edges = [edge for load in self.loading.loads if load.window for edge in load.window.angles or ()]
        apart = [np.abs(theta - edge) > clear for edge in edges]
        if any(load.window and load.window.stroke for load in self.loading.loads):
            rate = np.abs(self.rows.point(3, 0j).v)
            apart.append(rate > 1e-6 * rate.max())
        return np.logical_and.reduce([np.ones(len(theta), bool), *apart])

    def power_of_inertia(self, at: Motions) -> Array:
        """Power of all inertia forces [W]."""
        total = np.zeros(len(at.reference.coordinate))
        for body in self.loading.bodies:
            place, (_, w, e) = at.point(body.link, body.center), at.angle(body.link)
            total -= body.mass * dot(place.a, place.v) + body.inertia * e * w
        return total

    def inertia(self, at: Motions) -> Array:
        """Reduced inertia of the links [kg*m^2] (3.39)."""
        parts = ((body, at.point(body.link, body.center).v, at.angle(body.link)[1]) for body in self.loading.bodies)
        return sum(body.mass * np.abs(v) ** 2 + body.inertia * w**2 for body, v, w in parts) / at.speed**2


@cache
def project(name: str) -> Project:
    return Project(name)


def acting(load: Load, theta: Array, at: Motions) -> Array:
    """The size of a load: in its window, on its stroke, by its indicator diagram, by its table over the whole cycle."""
    law, slider = load.law, at.point(load.link, load.point)
    if isinstance(law, Indicator):
        return indicated(law, dot(np.full(len(theta), load.direction), slider.r), theta)
    if isinstance(law, Tabulated):
        return np.interp(theta, law.x, law.values)
    assert load.window is not None
    if load.window.angles is None:  # the pump: delivery on the way out
        assert isinstance(law, Constant)
        return law.value * ((slider.v.real > 0) == (load.window.stroke == "working"))
    first, last = load.window.angles
    inside = (theta >= first) & (theta <= last)
    if isinstance(law, Constant):
        return law.value * inside
    assert isinstance(law, Polynomial)
    return np.polynomial.polynomial.polyval(theta - first, law.coefficients) * inside


def indicated(law: Indicator, along: Array, theta: Array) -> Array:
    """Force by the pressures of the strokes, each half a turn from a dead centre on."""
    part = (along - along.min()) / np.ptp(along)
    stroke = np.floor(theta / math.pi + 1e-9).astype(int) % len(law.strokes)
    pressure = np.zeros(len(theta))
    for k, (x, p) in enumerate(law.strokes):
        order = np.argsort(x)
        pressure = np.where(stroke == k, np.interp(part, np.array(x)[order], np.array(p)[order]), pressure)
    return (pressure - law.back) * law.area


def motor_moment(power: Any, characteristic: str, efficiency: float, w: float) -> float:
    """Moment at the crank of the motor of a power stage, by the formulas of the textbook."""
    motor, ratio = power.duty.motor, power.duty.ratio
    own, rated, free = w * ratio, motor.speed, motor.synchronous
    nominal = motor.power / rated
    if characteristic == "parabolic":
        moment = nominal * (free**2 - own**2) / (free**2 - rated**2)
    else:
        slip, full = 1 - own / free, 1 - rated / free
        critical = full * (motor.overload + math.sqrt(motor.overload**2 - 1))
        moment = 2 * motor.overload * nominal * slip * critical / (slip**2 + critical**2)
    return moment * ratio * (efficiency if moment > 0 else 1 / efficiency)


def turned(found: Project, constant: float, start: float) -> tuple[float, float]:
    """Unevenness of one cycle from the speed ``start`` at its beginning, and how far it comes from closing (scipy)."""
    cycle, power, motion = (found.run.results[name] for name in ("reduction", "power", "motion"))
    cycle = cycle.cycle
    theta = np.linspace(0, cycle.period, 2881)
    inertia, load, viscous, quadratic = (
        CubicSpline(theta, values)
        for values in cycle.panels.at(np.stack((cycle.inertia, cycle.moment, cycle.viscous, cycle.quadratic)), theta)
    )
    given = found.spec.transmission.efficiency if found.spec.transmission is not None else None
    best = found.run.results["criteria"].winner if "criteria" in found.run.outcomes else None
    efficiency = given or (1.0 if best is None else best.values["efficiency"])
    on_crank = found.spec.open_pair
    efficiency *= 1.0 if on_crank is None or on_crank.efficiency is None else on_crank.efficiency

    def rate(phi: float, energy: Array) -> Array:
        w = math.sqrt(2 * energy[0] / (constant + inertia(phi)))
        drive = (
            power.mean_moment
            if motion.kind == "positional"
            else motor_moment(power, motion.characteristic, efficiency, w)
        )
        return np.array([drive + load(phi) + (viscous(phi) + quadratic(phi) * w) * w])

    energy = (constant + inertia(0.0)) * start**2 / 2
    span = (0.0, cycle.period)
    done = solve_ivp(rate, span, [energy], "LSODA", theta, rtol=1e-9, atol=1e-9 * energy, max_step=0.02)
    assert done.success
    w = np.sqrt(2 * done.y[0] / (constant + inertia(theta)))
    return float(2 * np.ptp(w) / (w.max() + w.min())), float(w[-1] / w[0] - 1)


def braked_angle(found: Project, name: str, brake: float) -> float:
    """Angle of the crank [rad] from the beginning of a motion of the elastic drive to where the brake stops it (scipy).

    Rotor, wheel and crank by their own angles: the shafts, c = 850 and 24 000 N*m/rad with their damping, stand before
    the gears u = 5 and 5.56.
    """
    motion = next(m for m in found.run.results["transient"].motions if m.name == name)
    cycle, parts = found.run.results["reduction"].idle, found.run.results["motion"].inertia
    theta = np.linspace(0, cycle.period, 2881)
    inertia, slope, load = (
        CubicSpline(theta, v) for v in cycle.panels.at(np.stack((cycle.inertia, cycle.slope, cycle.moment)), theta)
    )
    shafts = ((850.0, 0.15, 5.0), (24000.0, 1.5, 5.56))

    def rate(_: float, y: Array) -> Array:
        angles, w = y[:3], y[3:]
        carried = [
            c * (angles[k] - u * angles[k + 1]) + d * (w[k] - u * w[k + 1]) for k, (c, d, u) in enumerate(shafts)
        ]
        at = angles[2] % cycle.period
        whole = parts.further + parts.flywheel + inertia(at)
        crank = (5.56 * carried[1] + load(at) - brake - slope(at) * w[2] ** 2 / 2) / whole
        return np.array([*w, -carried[0] / 0.0014, (5 * carried[0] - carried[1]) / 0.004, crank])

    def still(_: float, y: Array) -> float:
        return float(y[5])

    still.terminal = True
    begin = np.concatenate((motion.theta[:, 0], motion.omega[:, 0]))
    done = solve_ivp(rate, (0, 3), begin, "DOP853", events=still, rtol=1e-10, atol=1e-11)
    return float(done.y_events[0][0][2] - begin[2])
