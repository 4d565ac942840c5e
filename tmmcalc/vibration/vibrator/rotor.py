"""Start with the rotor as a degree of freedom of its own, driven by a motor; equations of Lagrange, no terms left out.

    M q'' + k psi'' + B q' + C q = m r psi'^2 V_c' u
    k' q'' + J_r psi'' = M_motor(psi') - d psi' + m r g (-du_z/dpsi),     k = m r V_c' du/dpsi + J_r cos 45 deg e_phi

Energy q' M q'/2 + k' q' psi' + J_r psi'^2/2 + q C q/2 + m r g u_z changes by the work of the motor less what drag and
dampers take; that is integrated beside the motion, and the difference is the check.
"""

from __future__ import annotations

from collections.abc import Callable
from math import cos, isfinite, sin

import numpy as np

from tmmcalc.core.errors import AccuracyError, NoSolutionError
from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.records import record
from tmmcalc.vibration.vibrator.energies import COUNT, Excitation
from tmmcalc.vibration.vibrator.modes import Modes
from tmmcalc.vibration.vibrator.runup import DeviceMotion, steps_of
from tmmcalc.vibration.vibrator.task import Drive

RELATIVE = 1e-9  # tolerance of a step
ABSOLUTE = 1e-14  # of states, whose squares are energies, against the largest static ones
TURN = 2 * np.pi
LEAST = 1e-9  # of the rotor's inertia that the coupling has to leave


@record
class Driven:
    """The start of the rotor by its motor."""

    course: DeviceMotion
    motor: Values  # (n,) moment of the motor [N*m]
    evaluations: int  # of the equations


def driven(modes: Modes, excitation: Excitation, asked: Drive, gravity: float) -> Driven:
    """The motion from rest of the device and its rotor.

    Raises `NoSolutionError` if the rotor's inertia is less than the unbalance needs, `UsageError` where the time is
    too long to follow, `AccuracyError` if the integration fails.
    """
    check_inertia(modes, excitation)
    steps_of(modes, max(asked.characteristic.synchronous or 0.0, asked.initial), asked.duration, "vibrator.drive")
    from scipy.integrate import solve_ivp

    t = np.linspace(0.0, asked.duration, asked.rows + 1)
    start = np.zeros(2 * COUNT + 4)
    start[2 * COUNT + 1] = asked.initial
    weight = excitation.moment * gravity * excitation.rise
    scale = _scale(excitation, asked, weight)
    with np.errstate(over="ignore", invalid="ignore"):  # a motion that runs away ends with a message of its own
        done = solve_ivp(
            _slopes(modes, excitation, asked, weight),
            (0.0, asked.duration),
            start,
            method="DOP853",
            t_eval=t,
            rtol=RELATIVE,
            atol=ABSOLUTE * scale,
        )
    if not done.success:
        raise AccuracyError(
            f"the integration ends at t = {done.t[-1] if len(done.t) else 0.0:.6g} s: {done.message}",
            where="vibrator.drive",
            remedy="check the characteristic of the motor",
        )
    course = _course(modes, excitation, done.t, done.y, weight, asked.initial)
    return Driven(course, motor_moments(asked, course.omega), int(done.nfev))


def _runs_away(asked: Drive) -> AccuracyError:
    """The fault of a rotor whose speed leaves all bounds within a step."""
    return AccuracyError(
        f"with a drag of {asked.drag:.6g} N*m*s/rad the speed of the rotor changes too fast to be followed",
        where="vibrator.drive",
        value=asked.drag,
        remedy="check the drag and the characteristic of the motor, with their units",
    )


def motor_moments(asked: Drive, omega: Values) -> Values:
    """Moments (n,) of the motor at speeds (n,), one by one: a measured characteristic may take a float alone."""
    moment = asked.characteristic.moment
    return np.array([float(moment(float(w))) for w in omega])


def _scale(excitation: Excitation, asked: Drive, weight: float) -> Values:
    """Sizes of the states: of energies those of the rotor at its speed, of the device their roots."""
    fastest = max(asked.characteristic.synchronous or 0.0, asked.initial, 1.0)
    energy = excitation.rotor * fastest**2 / 2 + abs(weight)
    found = np.full(2 * COUNT + 4, np.sqrt(energy))
    found[2 * COUNT :] = (TURN, fastest, energy, energy)
    return found


def check_inertia(modes: Modes, excitation: Excitation) -> None:
    """Raise `NoSolutionError` unless kinetic energy is positive whatever the angle of the rotor."""
    psi = np.linspace(0.0, TURN, 73)
    coupling = _coupling(excitation, psi) @ modes.shapes
    taken = float(np.max(np.sum(coupling**2, axis=-1)))
    if taken > (1 - LEAST) * excitation.rotor:
        raise NoSolutionError(
            f"the rotor's moment of inertia is {excitation.rotor:.6g} kg*m^2, the unbalance couples it with "
            f"{taken:.6g} kg*m^2 of the device: the kinetic energy is not positive",
            where="vibrator.unbalance",
            value=excitation.rotor,
            limit=taken,
            remedy="rotor_inertia is that of the whole rotor; inertia_vertical of the exciter holds half of it as well",
        )


def _coupling(excitation: Excitation, psi: Values) -> Values:
    """k (n, 7) at the angles (n,)."""
    c, s = np.cos(psi)[..., None], np.sin(psi)[..., None]
    found: Values = excitation.moment * (c * excitation.sine - s * excitation.cosine) + excitation.spin
    return found


def _slopes(modes: Modes, excitation: Excitation, asked: Drive, weight: float) -> Callable[[float, Values], Values]:
    """Derivatives of (w eta, eta', psi, psi', work, lost)."""
    w, damping, rotor = modes.frequency, modes.damping, excitation.rotor
    to_cosine = excitation.moment * excitation.cosine @ modes.shapes
    to_sine = excitation.moment * excitation.sine @ modes.shapes
    spin = excitation.spin @ modes.shapes
    moment, drag = asked.characteristic.moment, asked.drag

    def slopes(_: float, y: Values) -> Values:
        displaced, velocity = y[:COUNT], y[COUNT : 2 * COUNT]
        angle, speed = float(y[2 * COUNT]), float(y[2 * COUNT + 1])
        if not (isfinite(angle) and isfinite(speed)):
            raise _runs_away(asked)
        c, s = cos(angle), sin(angle)
        resisted = damping @ velocity
        pull = speed * speed * (c * to_cosine + s * to_sine) - w * displaced - resisted
        coupling = c * to_sine - s * to_cosine + spin
        drive = float(moment(speed))
        torque = drive - drag * speed + weight * s
        epsilon = (torque - float(coupling @ pull)) / (rotor - float(coupling @ coupling))
        found = np.empty_like(y)
        found[:COUNT] = w * velocity
        found[COUNT : 2 * COUNT] = pull - coupling * epsilon
        found[2 * COUNT :] = (speed, epsilon, drive * speed, float(velocity @ resisted) + drag * speed * speed)
        return found

    return slopes


def _course(modes: Modes, excitation: Excitation, t: Values, y: Values, weight: float, initial: float) -> DeviceMotion:
    """The motion at the rows with its energies."""
    displaced, velocity = y[:COUNT], y[COUNT : 2 * COUNT]
    psi, omega, work, lost = y[2 * COUNT :]
    coupling = (_coupling(excitation, psi) @ modes.shapes).T
    energy = np.sum(displaced**2 + velocity**2, axis=0) / 2 + np.sum(coupling * velocity, axis=0) * omega
    energy = energy + excitation.rotor * omega**2 / 2 + weight * (np.cos(psi) - 1)
    open_ = energy - excitation.rotor * initial**2 / 2 + lost - work
    largest = float(np.max(np.abs(energy)))
    error = float(np.max(np.abs(open_))) / largest if largest else 0.0
    q = modes.shapes @ (displaced / modes.frequency[:, None])
    return DeviceMotion(t, psi, omega, q, energy, work, lost, error)


def mean_speed(course: DeviceMotion, part: float = 0.1) -> tuple[float, float]:
    """Mean speed [rad/s] over the last part of the time, and by how much it exceeds that of the part before it."""
    end = float(course.t[-1])
    at = np.interp([end * (1 - 2 * part), end * (1 - part), end], course.t, course.psi)
    before, last = np.diff(at) / (part * end)
    return float(last), float(last - before)
