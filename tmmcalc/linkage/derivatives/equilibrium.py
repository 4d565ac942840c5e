"""The equilibrium of all links at once, differentiated.

Three equations a link, moments about one fixed point, unknown the two components of the reaction of every joint and the
drive: A R = b. Along a change of the inputs A dR = db - dA R, where dA R is what the reactions that are there do with
the joints moved. Friction joins as what it is made of, a couple -c |R| in a pin, a force -c max(|N|, |M| / half) along
a guide, with its slope by the components in A: the friction that the stage has solved is differentiated implicitly.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple, Protocol

import numpy as np

from tmmcalc.core.plane import Plane, Real, cross
from tmmcalc.linkage.derivatives.closure import EPS, Moved
from tmmcalc.linkage.derivatives.loads import Given, given_loads
from tmmcalc.linkage.derivatives.rates import MARGIN
from tmmcalc.linkage.forces.kinetostatics import Statics
from tmmcalc.linkage.loading import GearDrive
from tmmcalc.linkage.loadlaws.constant import Constant
from tmmcalc.linkage.loadlaws.placed import Placed
from tmmcalc.linkage.model import FRAME, Joint

DIFFERENCE = 1e-12  # error of the difference of a law, against its largest value


class Rows(Protocol):
    """Reactions and drive at n places, as results and stacks of them hold these."""

    @property
    def reaction(self) -> Plane:
        """Of the joints (J, n)."""

    @property
    def normal(self) -> Real:
        """Of prismatic joints (J, n)."""

    @property
    def couple(self) -> Real:
        """About the pin or the slider's point (J, n)."""

    @property
    def friction(self) -> Real:
        """Along the line or about the pin (J, n)."""

    @property
    def drive(self) -> Real:
        """Of the input (n,)."""


class Seat(NamedTuple):
    """A joint in place: its point (n,), the direction of its line (a prismatic one), and their changes (K, n)."""

    joint: Joint
    r: Plane
    dr: Plane
    e: Plane | None
    de: Plane


class Rub(NamedTuple):
    """Friction of a joint: kappa (n,), coefficient times the sense of sliding of the higher-numbered link; changes."""

    kappa: Real
    dkappa: Real  # (K, n)
    half: float | None
    dhalf: Real  # (K, 1)


def seat_of(moved: Moved, joint: Joint) -> Seat:
    """A joint in place, by the point and the line that the first of its links carries."""
    r, dr = moved.pin(joint, 0)
    if joint.kind == "revolute":
        return Seat(joint, r[0, 0], dr[0], None, np.zeros(()) + 0j)
    e, de = moved.line(joint, 0)
    return Seat(joint, r[0, 0], dr[0], e[0, 0], de[0])


class Equilibrium:
    """The linear system at all rows, and the changes of all that the table tells."""

    def __init__(self, statics: Statics, given: Given, rows: Rows, side: Real, gross: Real, error: float) -> None:
        self.rows, self.given, self.statics = rows, given, statics
        self.rounding = error  # relative, of the reactions
        self.gross = gross  # (K,) relative changes of the motion of which those at the rows are made
        mechanism = statics.scene.chain.mechanism
        self.places = {link.id: 3 * i for i, link in enumerate(mechanism.links)}
        self.seats = [seat_of(given.moved, joint) for joint in mechanism.joints]
        self.rubs = [self._rub(seat.joint, side) for seat in self.seats]
        self.reach = given.moved.reach
        n, size = len(rows.drive), 3 * len(self.places)
        self.matrix = np.zeros((n, size, size))
        self.sides = np.zeros((size, *given.dtheta.shape))
        self.acted = given_loads(given)
        self._joints()
        self._drive()
        for acted in self.acted:
            self._add(self.sides, acted.link, acted.dforce, acted.dmoment)
        solved = np.linalg.solve(self.matrix, -np.moveaxis(self.sides, (0, 1), (1, 2)))
        self.changes = np.moveaxis(solved, (0, 1, 2), (2, 0, 1))  # (3 m, K, n)

    def _rub(self, joint: Joint, side: Real) -> Rub | None:
        """Friction of a joint; None where there is none."""
        loading, own = self.given.scene.loading, self.given.changes
        found = ((p, dp) for p, dp in zip(loading.pairs, own.pairs, strict=True) if p.joint == joint.name)
        pair, change = next(found, (None, None))
        if pair is None or change is None:
            return None
        revolute = joint.kind == "revolute"
        coefficient = pair.friction * (pair.radius if revolute else 1.0)
        if not coefficient:
            return None
        slope = change.friction * pair.radius + pair.friction * change.radius if revolute else change.friction
        sense = self.statics.sense(joint, self.given.place.configuration, side)
        half = pair.length / 2 if pair.length else None
        return Rub(coefficient * sense, slope * sense, half, change.length / 2 if pair.length else np.zeros((1, 1)))

    def _add(self, place: Real, link: int, force: Any, moment: Any) -> None:
        row = self.places[link]
        place[row] += np.real(force)
        place[row + 1] += np.imag(force)
        place[row + 2] += moment / self.reach

    def _both(self, place: Real, seat: Seat, force: Any, moment: Any) -> None:
        """A force with its moment on the higher-numbered link of a joint, and back on the other."""
        low, high = sorted(seat.joint.links)
        self._add(place, high, force, moment)
        if low != FRAME:
            self._add(place, low, -force, -moment)

    def _unit(self, column: int, seat: Seat, force: Any, couple: Any) -> None:
        """The column of an unknown that is this force at a joint with this couple."""
        place = np.moveaxis(self.matrix[:, :, column], 0, 1)
        self._both(place, seat, force, cross(seat.r - self.given.pole, force + 0j) + couple)

    def _moving(self, seat: Seat, force: Plane, dforce: Any, dcouple: Any) -> None:
        """What a reaction does with its joint moved."""
        arm = seat.r - self.given.pole
        self._both(self.sides, seat, dforce, cross(seat.dr, force) + cross(arm, dforce + 0j) + dcouple)

    def _joints(self) -> None:
        for j, (seat, rub) in enumerate(zip(self.seats, self.rubs, strict=True)):
            force = self.rows.reaction[j]
            if seat.e is None:
                size = np.maximum(np.abs(force), 1e-300)
                kappa = rub.kappa if rub is not None else 0.0
                self._unit(2 * j, seat, np.ones(len(size)) + 0j, -kappa * force.real / size)
                self._unit(2 * j + 1, seat, 1j * np.ones(len(size)), -kappa * force.imag / size)
                self._moving(seat, force, 0j, -rub.dkappa * np.abs(force) if rub is not None else 0.0)
                continue
            normal, friction = self.rows.normal[j], self.rows.friction[j]
            by_normal, by_couple, own = self.guide(j)
            self._unit(2 * j, seat, 1j * seat.e + by_normal * seat.e, 0.0)
            self._unit(2 * j + 1, seat, by_couple * seat.e, 1.0)
            self._moving(seat, force, (1j * normal + friction) * seat.de + own * seat.e, 0.0)

    def guide(self, j: int) -> tuple[Any, Any, Any]:
        """Slopes of the friction along a guide by normal force and couple, and its own change (K, n)."""
        rub, normal, couple = self.rubs[j], self.rows.normal[j], self.rows.couple[j]
        if rub is None:
            return 0.0, 0.0, 0.0
        tips = np.zeros(len(normal), bool) if rub.half is None else np.abs(couple) > np.abs(normal) * rub.half
        half = rub.half or 1.0
        size = np.where(tips, np.abs(couple) / half, np.abs(normal))
        own = -rub.dkappa * size + rub.kappa * np.where(tips, np.abs(couple) / half**2, 0.0) * rub.dhalf
        by_normal = np.where(tips, 0.0, -rub.kappa * np.sign(normal))
        return by_normal, np.where(tips, -rub.kappa * np.sign(couple) / half, 0.0), own

    def _drive(self) -> None:
        """The column of the drive, and what it does moved."""
        chain, drive, last = self.given.scene.chain, self.rows.drive, self.matrix.shape[1] - 1
        joint = chain.input_joint
        seat = next(each for each in self.seats if each.joint.name == joint.name)
        if seat.e is not None:
            sense = 1.0 if joint.links[0] == max(joint.links) else -1.0
            self._unit(last, seat, sense * seat.e, 0.0)
            self._moving(seat, sense * drive * seat.e, sense * drive * seat.de, 0.0)
            return
        link, place = chain.structure.input_link, np.moveaxis(self.matrix[:, :, last], 0, 1)
        gear, arm = self.given.scene.loading.drive, seat.r - self.given.pole
        if not isinstance(gear, GearDrive):
            self._add(place, link, 0j, np.ones(len(drive)))
            return
        mesh, dmesh = self.mesh_of(gear)
        force = mesh * drive
        self._add(place, link, mesh, 1.0 + cross(arm, mesh))
        self._add(self.sides, link, dmesh * drive, cross(seat.dr, force) + cross(arm, dmesh * drive))

    def reaction(self, j: int) -> Plane:
        """Change (K, n) of the whole force in a joint."""
        seat, one, two = self.seats[j], self.changes[2 * j], self.changes[2 * j + 1]
        if seat.e is None:
            return np.asarray(one + 1j * two)
        by_normal, by_couple, own = self.guide(j)
        friction = by_normal * one + by_couple * two + own
        return np.asarray((1j * one + friction) * seat.e + (1j * self.rows.normal[j] + self.rows.friction[j]) * seat.de)

    def length_change(self, j: int) -> Real:
        """Change (K,) of the given length of the slider of a joint."""
        pairs, changes = self.given.scene.loading.pairs, self.given.changes.pairs
        name = self.seats[j].joint.name
        found = [change.length for p, change in zip(pairs, changes, strict=True) if p.joint == name and p.length]
        return np.asarray(found[0])[:, 0] if found else np.zeros(self.changes.shape[1])

    def mesh_of(self, gear: GearDrive) -> tuple[Plane, Plane]:
        """Force (n,) in the mesh to a unit of the moment, on its flank, and its change (K, n)."""
        change = self.given.changes.drive
        flank = np.sign(self.rows.drive) * (1.0 if gear.internal else -1.0)
        beta, tangent = np.exp(1j * gear.pinion), math.tan(gear.mesh_angle)
        mesh = (1j + flank * tangent) * beta / gear.radius
        dmesh = flank * (1 + tangent**2) * change.mesh_angle * beta / gear.radius
        return mesh, dmesh + mesh * (1j * change.pinion - change.radius / gear.radius)

    @property
    def errors(self) -> tuple[Real, Real]:
        """What the changes of forces [N], and of moments, may be off by, (K,) each."""
        condition = float(np.max(np.linalg.cond(self.matrix, 1)))
        scale = np.max(np.abs(self.sides), axis=(0, 2)) + np.max(np.abs(self.changes), axis=(0, 2))
        scale = scale + self.gross * float(np.max(np.abs(self.rows.reaction)))
        motion = float(np.max(self.given.moved.condition)) * max(EPS, self.given.kinematics.error.acceleration)
        rounding = MARGIN * (EPS * condition + max(motion, self.rounding)) * scale
        laws = [load for load in self.given.scene.loading.loads if isinstance(load.law, Placed)]
        if any(not isinstance(load.law, Constant) for load in laws):
            rounding = rounding + DIFFERENCE * condition * scale
        return rounding, rounding * self.reach
