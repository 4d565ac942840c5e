"""What is asked of a cam: its motion, its sizes where they are given, limits, loads, requirements. All in SI."""

from __future__ import annotations

from dataclasses import field, replace
from functools import cached_property
from math import radians
from typing import TYPE_CHECKING, Literal

import numpy as np

from tmmcalc.cams.follower import Closure, FollowerKind
from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.overshoot import Backward, backward
from tmmcalc.cams.program import SAME, Positions, Program, of_step, of_steps
from tmmcalc.cams.speed import TURN, Speed
from tmmcalc.core.numerics.panels import Panels
from tmmcalc.core.records import record

if TYPE_CHECKING:
    from tmmcalc.machine.motion import Motion

PRESSURE_ANGLES = {"translating": radians(30), "oscillating": radians(45), "flat": radians(90)}  # usual limits


@record
class Asked:
    """The cam and its follower; None: to be found by the synthesis."""

    kind: FollowerKind
    sense: int = 1  # sigma: +1 clockwise, -1 counter-clockwise
    closure: Closure = "force"
    start: float | None = None  # S0 [m] or psi0 [rad]
    base: float | None = None  # or R0 [m], of the pitch curve (flat face: of the profile)
    offset: float | None = 0.0  # e [m] in the user's sense: positive to the right of O; RT
    roller: float | None = None  # r2 [m]; 0: knife edge
    centres: float | None = None  # l0 [m]; RK
    rocker: float | None = None  # l2 [m]; RK
    assembly: int = 1  # delta; RK
    tool: float | None = None  # r_t [m], radius of the cutter or grinding wheel of a tool path
    tolerance: float = 1e-6  # [m] chord of exported curves
    margin: float = 0.0  # [m] by which a flat face is longer than the contact needs, on both sides
    report_faults: bool = False  # a profile that is undercut or crosses itself is reported, not refused


@record
class AngleLimits:
    """Largest pressure angles and least radii."""

    rise: float  # [theta] [rad]
    back: float | None  # of the return; None: not limited
    convex: float = 0.0025  # r_m [m], least radius of curvature of convex parts of the working profile
    concave: float = 0.075  # r_i [m], least radius of the tool for concave parts
    allow_concave: bool = True
    shaft: float = 0.0  # r1 [m], radius of the shaft that the base circle has to clear


@record
class Force:
    """A technological force [N] or moment [N*m] on the follower, positive along the lift; constant or by phi."""

    rise: float = 0.0  # during rise and high dwell
    back: float = 0.0  # during return and low dwell
    phi: Values | None = None  # (n,) [rad]; then ``values`` in place of the constants, linear between, periodic
    values: Values | None = None

    def tabulated(self, phi: Values) -> Values:
        """The values of the table at angles (n,) of a turn; where it jumps those after the jump.

        >>> Force(phi=np.array([0.0, 1.0, 1.0]), values=np.array([2.0, 2.0, 5.0])).tabulated(np.array([0.5, 1.0]))
        array([2., 5.])
        """
        assert self.phi is not None
        assert self.values is not None
        x = np.concatenate((self.phi[-1:] - TURN, self.phi, self.phi[:1] + TURN))
        y = np.concatenate((self.values[-1:], self.values, self.values[:1]))
        k = np.clip(np.searchsorted(x, phi, "right") - 1, 0, len(x) - 2)  # np.interp takes no extended precision
        width = x[k + 1] - x[k]
        slope = np.where(width > 0, (y[k + 1] - y[k]) / np.where(width > 0, width, 1.0), 0.0)
        found: Values = slope * (phi - x[k]) + y[k]
        return found


@record
class Spring:
    """How the return spring is found."""

    method: Literal["none", "given", "safety", "preload"] = "safety"
    safety: float = 1.25  # K1
    stiffness: float = 0.0  # c [N/m] or [N*m/rad], given
    preload: float = 0.0  # Q0 [N] or M0 [N*m] at the lowest position, given
    deflection: float | None = None  # f1 [m] or [rad] of the preload; None: 0.4 of the stroke
    least: float = 5.0  # F_min [N] or [N*m] of contact with the method preload
    exact: bool = False  # stiffness that keeps the safety over the whole turn, in place of the textbook's rule
    wire: float | None = None  # d [m]; with coil and shear: the coils and stresses of the spring itself
    coil: float | None = None  # D [m]
    shear: float = 80e9  # G [Pa]
    allowed: float | None = None  # shear stress [Pa] for which springs are sized by D/d
    dead: float = 2.0  # coils at the ends that do not work


@record
class Loads:
    """Masses, forces, friction."""

    speed: float  # omega [rad/s], positive
    mass: float = 0.0  # m2 [kg] or J2 [kg*m^2]
    force: Force = Force()
    gravity: float = 0.0  # [m/s^2] component along the lift, negative if the weight presses on the cam; RT, PT
    spring: Spring = Spring()
    friction: float = 0.0  # f of stem and guide
    pivot_friction: float = 0.0  # f of the rocker's pivot
    pivot_radius: float = 0.0  # [m]


@record
class Guide:
    """Guide of a stem; heights above O."""

    top: float | None = None  # H2 [m]
    length: float | None = None  # or l [m]
    gap: float = 0.0  # [m] between the roller at its highest and the lower edge
    stem: float | None = None  # r_T [m], radius of the stem
    land: float | None = None  # l_H [m], length of each ground land


@record
class Requirements:
    """Data of slip, shaft, stem, pin and contact; what is None is not judged."""

    width: float | None = None  # b [m], of the contact line
    modulus: float = 2e11  # E_n [Pa], reduced
    contact: float | None = None  # [sigma_H] [Pa]
    rolling_arm: float | None = None  # k [m]
    roller_friction: float | None = None  # f, roller on cam
    pin_friction: float | None = None  # f0
    pin: float | None = None  # r0 [m]; None: by the pressure on it
    pin_pressure: float | None = None  # [sigma_0] [Pa]
    pin_ratio: float = 1.4  # alpha2 = b/(2 r0)
    roller_ratio: float = 2.5  # alpha0 = r2*/r0
    roller_density: float = 7820.0  # [kg/m^3]
    roller_inertia: float | None = None  # [kg*m^2]; None: a hollow cylinder
    span: float | None = None  # l_s [m], between the supports of the camshaft
    bending: float | None = None  # [sigma_F] [Pa], shaft and stem
    deflection: float | None = None  # [Delta] [m]
    young: float = 2e11  # E [Pa] of the shaft
    torsion: float = 0.75  # alpha_e
    guide_pressure: float | None = None  # [sigma_cm] [Pa]
    contact_source: str = ""  # what the contact stress is made of where it is that of a steel


@record
class Optimum:
    """The search for the lowest mechanism."""

    step: float = 1e-3  # [m] of S0 and r2
    height_step: float = 1e-3  # [m] of H2
    heights: tuple[float, float] | None = None  # [m] of H2; None: from the least that can be
    centre_distances: tuple[float, float] | None = None  # [m] of l0 of a rocker; None: from the least that can be
    rocker_lengths: tuple[float, float] | None = None  # [m] of l2; None: any
    phases: Literal["turn", "rise"] = "turn"  # what of the turn is examined; "rise" is the textbook's way
    laws: tuple[str, ...] = ()  # options of the design game, beside what the task asks for
    safeties: tuple[float, ...] = ()  # K1 of the spring
    contacts: tuple[tuple[str, float], ...] = ()  # materials: name (may be empty), [sigma_H] [Pa]
    roller_ratios: tuple[tuple[str, float], ...] = ()  # kinds of roller: name (may be empty), alpha0
    combine: bool = False  # all combinations of the options; else one change at a time


@record
class Elastic:
    """A follower as one mass on a spring."""

    stiffness: float  # [N/m] or [N*m/rad] of the train between cam and mass
    damping: float = 0.0  # part of critical
    mass: float | None = None  # None: that of the loads


@record
class CamTask:
    """Everything about one cam."""

    program: Program
    asked: Asked
    limits: AngleLimits
    steps: int | None = None  # rows of the tables: equal steps of every moving phase; None: equal steps of phi
    step: float = radians(1)  # [rad]
    loads: Loads | None = None
    guide: Guide = Guide()
    requirements: Requirements = Requirements()
    optimum: Optimum | None = None
    elastic: Elastic | None = None
    begin: float = 0.0  # [rad] angle of the crank from position 0 at which the rise begins
    ratio: float = 1.0  # speed of the cam over that of the crank
    turns: int = 0  # of the crank after which the cam repeats, where it loads the machine; 0: it does not
    turning: Speed | None = None  # of the machine over the turn; None: constant
    remarks: tuple[str, ...] = field(default=())

    @cached_property
    def positions(self) -> Positions:
        """The rows of all tables."""
        return of_step(self.program, self.step) if self.steps is None else of_steps(self.program, self.steps)

    @cached_property
    def motion(self) -> Values:
        """y and its derivatives (4, n) at the rows."""
        return self.program.at(self.positions.phi, self.positions.piece)

    @cached_property
    def backward(self) -> tuple[Backward, ...]:
        """The parts of rise and return in which the follower turns back."""
        return backward(self.program)

    def at_speed(self, motion: Motion | None) -> CamTask:
        """The same at the speed that the machine has over its cycle, if that is known and one turn of the cam."""
        if motion is None:
            return self
        regime, ratio = motion.regime, self.ratio
        if abs(regime.panels.edges[-1] * ratio - TURN) > SAME * TURN:
            return self
        on = regime.panels if ratio == 1 else Panels(regime.panels.edges * ratio, regime.panels.order)
        return replace(self, turning=Speed(on, regime.omega * ratio, regime.acceleration * ratio, self.begin * ratio))

    @property
    def sprung(self) -> CamTask:
        """The task at the speed for which its spring is found.

        A machine that the cam loads moves with that spring, which therefore is the one of the mean speed.
        """
        return replace(self, turning=None) if self.turns else self
