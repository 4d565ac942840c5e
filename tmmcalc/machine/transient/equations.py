"""Equations of motion of the reduced chain, and the layout of the state.

With n groups of masses on the crank's shaft (textbook (3.61), (3.62) for n = 1)

    J_i dw_i/dt = T_(i-1) - T_i,   T_i = c_i phi_i + k_i (w_i - w_(i+1)),   dphi_i/dt = w_i - w_(i+1)
    (J_n + J(theta)) dw_n/dt = T_(n-1) + M(theta, w_n) - w_n^2/2 dJ/dtheta
    tau_e dM_d/dt = M_static(w_1) - M_d

where T_0 is the driving moment M_d; brakes take their moment from any of them. The state holds the crank angle, the
twists of the shafts (angles of the masses would lose their difference to rounding), the speeds, with lag M_d, and
last the works of motor, load, brake and dampers: their sum is the change of energy, which checks the solution.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

from tmmcalc.core.numerics.steps import Derivative, State
from tmmcalc.machine.transient.model import Reduced
from tmmcalc.machine.transient.pointwise import Stretch, reader

Curve = Callable[[float], float]
WORKS = 4


class Layout(NamedTuple):
    """Where the parts of the state stand: theta, n - 1 twists, n speeds, the motor moment with lag, four works."""

    groups: int
    lag: bool

    @property
    def speed(self) -> int:
        """Index of the speed of the first group, that of the motor."""
        return self.groups

    @property
    def crank(self) -> int:
        """Index of the speed of the crank."""
        return 2 * self.groups - 1

    @property
    def works(self) -> int:
        """Index of the first work, and number of unknowns before it."""
        return 2 * self.groups + self.lag

    @property
    def size(self) -> int:
        """Number of all components."""
        return self.works + WORKS


class System(NamedTuple):
    """The reduced drive with its motor and brake, all on the crank's shaft."""

    chain: Reduced
    moment: Curve | None  # static moment of the motor at a speed of its group [N*m]; None: no motor
    slope: Curve | None  # and its derivative [N*m*s]
    time_constant: float  # [s]
    brake: int  # the group with the brake
    grip: float  # its constant moment [N*m]
    drag: float  # its viscous part [N*m*s/rad]

    @property
    def layout(self) -> Layout:
        """Layout of the state."""
        return Layout(len(self.chain.inertia), self.time_constant > 0 and self.moment is not None)


class Regime(NamedTuple):
    """What is in force while no event changes it."""

    motor: bool  # the motor is on
    braked: bool  # the brake acts
    slip: float  # direction of motion that the constant braking moment opposes: 1, -1; 0 at rest
    held: frozenset[int]  # groups at rest that are held there
    factor: float  # load factor
    stretch: int  # in which the crank turns
    base: float  # whole turns to take off the crank angle [rad]
    way: float = 1.0  # direction of the crank that friction and quadratic resistances are taken for: 1, -1


def derivative(system: System, regime: Regime, stretch: Stretch) -> Derivative:
    """The right-hand side f(t, y) of one regime, on plain floats."""
    build = _one_mass if len(system.chain.inertia) == 1 else _several
    return build(system, regime, stretch)


def _one_mass(system: System, regime: Regime, stretch: Stretch) -> Derivative:
    read = reader(stretch, regime.base)
    constant = system.chain.inertia[0]
    curve = system.moment if regime.motor else None
    lag, tau = system.layout.lag, system.time_constant
    grip, drag = (regime.slip * system.grip, system.drag) if regime.braked else (0.0, 0.0)
    held = bool(regime.held)

    def f(_: float, y: State) -> State:
        w = y[1]
        inertia, slope, load = read(y[0], w)
        drive = 0.0 if curve is None else y[2] if lag else curve(w)
        brake = grip + drag * w
        a = 0.0 if held else (drive + load - brake - 0.5 * slope * w * w) / (constant + inertia)
        if lag:
            rise = 0.0 if curve is None else (curve(w) - drive) / tau
            return w, a, rise, drive * w, load * w, -brake * w, 0.0
        return w, a, drive * w, load * w, -brake * w, 0.0

    return f


def _several(system: System, regime: Regime, stretch: Stretch) -> Derivative:
    read = reader(stretch, regime.base)
    chain, held = system.chain, regime.held
    curve = system.moment if regime.motor else None
    lag, tau = system.layout.lag, system.time_constant
    n = len(chain.inertia)
    *own, constant = chain.inertia
    shafts = list(zip(range(1, n), chain.stiffness, chain.damping, own, strict=True))
    grip, drag = (regime.slip * system.grip, system.drag) if regime.braked else (0.0, 0.0)
    braked, stops = system.brake, regime.braked

    def f(_: float, y: State) -> State:
        first = w = y[n]
        inertia, slope, load = read(y[0], y[2 * n - 1])
        drive = 0.0 if curve is None else y[2 * n] if lag else curve(w)
        carried, lost, power = drive, 0.0, 0.0
        result, rates = [y[2 * n - 1]], []
        for i, c, k, j in shafts:
            after = y[n + i]
            slide = w - after
            drag_moment = k * slide
            moment = c * y[i] + drag_moment
            lost -= drag_moment * slide
            result.append(slide)
            rates.append((carried - moment) / j)
            carried, w = moment, after
        total = constant + inertia
        rates.append((carried + load - 0.5 * slope * w * w) / total)
        if stops:
            brake = grip + drag * y[n + braked]
            rates[braked] -= brake / (total if braked == n - 1 else own[braked])
            power = -brake * y[n + braked]
        for i in held:
            rates[i] = 0.0
        result += rates
        if lag:
            result.append(0.0 if curve is None else (curve(first) - drive) / tau)
        result += drive * first, load * w, power, lost
        return result

    return f


def surplus(system: System, regime: Regime, stretch: Stretch, group: int) -> Callable[[State], float]:
    """The moment [N*m] on a ``group`` at rest from everything but what holds it."""
    free = derivative(system, regime._replace(slip=0.0, held=frozenset()), stretch)
    read, at = reader(stretch, regime.base), system.layout.speed + group
    own, last = system.chain.inertia[group], group == len(system.chain.inertia) - 1

    def net(y: State) -> float:
        return free(0.0, y)[at] * (own + (read(y[0], 0.0)[0] if last else 0.0))

    return net
