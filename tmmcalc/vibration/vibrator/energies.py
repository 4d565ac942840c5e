"""Mass, stiffness and excitation of the device, each from its energy or its virtual work.

    T = 1/2 sum (m v' v + w' J w),  v = V q', w = W q'      ->  M = sum (V' m V + W' J W)
    P = 1/2 sum c s' s,  s = S q                            ->  C = sum c S' S
    the unbalance at its centre, velocity V_c q'            ->  force V_c' (m r) (psi'^2 u - psi'' du/dpsi)

u(psi) is the unit vector to the unbalance: cos(psi) along the direction that climbs by 45 deg over the bisector,
sin(psi) along the hinge. The rotor's own moment of momentum adds -J_r psi'' cos 45 deg to the equation of phi.
"""

from __future__ import annotations

from math import cos, sin, sqrt

import numpy as np

from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.records import record
from tmmcalc.vibration.vibrator.springs import Stiffness
from tmmcalc.vibration.vibrator.task import COORDINATES, Unbalance, VibratorTask

COUNT = len(COORDINATES)
X, Y, PHI, TILT_X, TILT_Y, Z, GAMMA = range(COUNT)
HALF = 1 / sqrt(2)  # cos 45 deg
BISECTOR, ACROSS, UP = np.array([HALF, HALF, 0.0]), np.array([-HALF, HALF, 0.0]), np.array([0.0, 0.0, 1.0])
TO_COSINE, TO_SINE = HALF * (BISECTOR + UP), ACROSS  # of the unbalance
AXIS = HALF * (UP - BISECTOR)  # of the rotor
RODS = 4
SPRINGS = 4


@record
class Body:
    """A body: its mass with the velocity of its centre, its inertias with the turning that each belongs to."""

    mass: float
    velocity: Values  # V (3, 7)
    inertias: tuple[float, ...]
    turning: Values  # W (k, 7)


def bodies(task: VibratorTask) -> tuple[Body, ...]:
    """Ring, gripper and exciter with their velocity Jacobians."""
    gripper, exciter = task.gripper, task.exciter
    return (
        Body(task.ring.mass, _ring(), (task.ring.inertia,), _rows(PHI)),
        Body(
            gripper.mass,
            gripper_jacobian(np.array([[0.0, 0.0, -gripper.drop]]))[0],
            (gripper.inertia_x, gripper.inertia_y, gripper.inertia_z),
            _rows(TILT_X, TILT_Y, PHI),
        ),
        Body(
            exciter.mass,
            exciter_jacobian(exciter.radius, exciter.arm, exciter.arm_angle),
            (exciter.inertia_z, exciter.inertia_hinge),
            _rows(PHI, GAMMA),
        ),
    )


def mass_matrix(task: VibratorTask) -> Values:
    """M (7, 7) from the kinetic energy."""
    total = np.zeros((COUNT, COUNT))
    for body in bodies(task):
        total += body.mass * body.velocity.T @ body.velocity
        total += body.turning.T @ np.diag(body.inertias) @ body.turning
    return total


def stiffness_matrix(task: VibratorTask, springs: Stiffness) -> Values:
    """C (7, 7) from the potential energy: rods across themselves, flat springs, the plate."""
    total = np.zeros((COUNT, COUNT))
    for k in range(RODS):
        end = task.rods.radius * np.array([(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)][k])
        shift = _ring()[:2]
        shift[:, PHI] = (-end[1], end[0])
        total += springs.rod * shift.T @ shift
    total[Z, Z] += SPRINGS * springs.vertical
    total[TILT_X, TILT_X] += springs.tilt
    total[TILT_Y, TILT_Y] += springs.tilt
    total[GAMMA, GAMMA] += springs.plate
    return total


def gripper_jacobian(points: Values) -> Values:
    """Displacement (k, 3, 7) of points (k, 3) of the gripper over the coordinates: translation and small turns."""
    found = np.zeros((len(points), 3, COUNT))
    found[:, 0, X] = found[:, 1, Y] = found[:, 2, Z] = 1.0
    for axis, coordinate in enumerate((TILT_X, TILT_Y, PHI)):
        found[:, :, coordinate] = np.cross(np.eye(3)[axis], points)
    return found


def exciter_jacobian(radius: float, arm: float, angle: float) -> Values:
    """Displacement (3, 7) of a point of the exciter: at ``radius`` from the vertical, on an arm from the hinge."""
    found = _ring()
    found[:, PHI] = radius * ACROSS
    found[:, GAMMA] = arm * (cos(angle) * UP - sin(angle) * BISECTOR)
    return found


@record
class Excitation:
    """Generalised forces of the unbalance over m r psi'^2, and the coupling of the rotor."""

    moment: float  # m r [kg*m]
    cosine: Values  # (7,) V_c' u = cosine cos(psi) + sine sin(psi)
    sine: Values  # (7,)
    spin: Values  # (7,) moment of momentum of the rotor over psi' [kg*m^2]
    rotor: float  # J_r [kg*m^2]
    rise: float  # vertical part of u over cos(psi)

    def force(self, psi: Values, omega: Values, epsilon: Values, *, tangential: bool) -> Values:
        """P (..., 7) at the angle, speed and acceleration (...) of the rotor."""
        c, s = np.cos(psi), np.sin(psi)
        square, turn = self.moment * omega**2, self.moment * epsilon * tangential
        along, over = square * c + turn * s, square * s - turn * c
        found: Values = along[..., None] * self.cosine + over[..., None] * self.sine - epsilon[..., None] * self.spin
        return found

    def amplitude(self, omega: Values) -> Values:
        """P (..., 7) complex at a constant speed: the real part of P e^(i psi)."""
        found: Values = self.moment * (omega**2)[..., None] * (self.cosine - 1j * self.sine)
        return found


def excitation_of(unbalance: Unbalance) -> Excitation:
    """The virtual work of the unbalance in every coordinate."""
    centre = exciter_jacobian(unbalance.radius, unbalance.arm, unbalance.arm_angle)
    spin = np.zeros(COUNT)
    spin[PHI] = unbalance.rotor * AXIS[2]
    return Excitation(
        unbalance.moment, centre.T @ TO_COSINE, centre.T @ TO_SINE, spin, unbalance.rotor, float(TO_COSINE[2])
    )


def _ring() -> Values:
    """Velocity (3, 7) of a point on the vertical axis of the ring."""
    found = np.zeros((3, COUNT))
    found[0, X] = found[1, Y] = 1.0
    return found


def _rows(*coordinates: int) -> Values:
    found: Values = np.eye(COUNT)[list(coordinates)]
    return found
