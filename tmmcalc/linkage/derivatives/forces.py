"""Derivatives of reactions and drive by the inputs: the equations of equilibrium of all links, differentiated.

Three equations a link, moments about one fixed point, unknown the two components of the reaction of every joint and the
drive: A R = b. Along a change of the inputs A dR = db - dA R, where dA R is what the reactions that are there do with
the joints moved. Friction joins as what it is made of, a couple -c |R| in a pin, a force -c max(|N|, |M| / half) along
a guide, with its slope by the components in A: the friction that the stage has solved is differentiated implicitly.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from functools import partial
from typing import Any, NamedTuple

import numpy as np

from tmmcalc.core.derivatives import Derivative
from tmmcalc.core.numerics.alike import numbers
from tmmcalc.core.plane import Plane, Real, cross
from tmmcalc.core.records import record
from tmmcalc.linkage.chain import chain_of
from tmmcalc.linkage.derivatives.closure import EPS, Moved, Slopes, changes_of
from tmmcalc.linkage.derivatives.kinematics import MARGIN
from tmmcalc.linkage.derivatives.loads import Given, exact, given_loads
from tmmcalc.linkage.derivatives.rows import Directions, Placing, directions_of, placing, row_shifts
from tmmcalc.linkage.forces.columns import columns
from tmmcalc.linkage.forces.kinetostatics import Statics
from tmmcalc.linkage.forces.results import Forces
from tmmcalc.linkage.forces.rows import Rows
from tmmcalc.linkage.loading import GearDrive, Loading
from tmmcalc.linkage.loadlaws.constant import Constant
from tmmcalc.linkage.loadlaws.placed import Placed
from tmmcalc.linkage.model import FRAME, Joint, Mechanism
from tmmcalc.linkage.outputs import default_outputs
from tmmcalc.linkage.results import DeadCentre, Kinematics

DIFFERENCE = 1e-12  # error of the difference of a law, against its largest value


@record
class ForcesDerivatives:
    """Derivatives along K directions of the columns of the forces table by ``name[unit]``, those given exactly."""

    columns: dict[str, Derivative]


class _Seat(NamedTuple):
    """A joint in place: its point (n,), the direction of its line (a prismatic one), and their changes (K, n)."""

    joint: Joint
    r: Plane
    dr: Plane
    e: Plane | None
    de: Plane


class _Rub(NamedTuple):
    """Friction of a joint: kappa (n,), coefficient times the sense of sliding of the higher-numbered link; changes."""

    kappa: Real
    dkappa: Real  # (K, n)
    half: float | None
    dhalf: Real  # (K, 1)


def differentiate_forces(
    mechanism: Mechanism, loading: Loading, kinematics: Kinematics, result: Forces, slopes: Slopes
) -> ForcesDerivatives | None:
    """Derivatives of a result along K directions: ``slopes`` (K, L) of the numbers of mechanism and loading.

    The numbers are those of the pair, mechanism first, in the order of `core.numerics.alike.numbers`. None where a load
    is not given exactly, see `loads`. Rows keep their labels; where friction jumps at a row it stays on its side.
    """
    statics = Rows(mechanism, loading, kinematics, result).statics
    if not exact(statics.scene):
        return None
    count = len(numbers(mechanism))
    travel = statics.scene.travel
    x = travel.x(result.theta)
    directions = directions_of(mechanism, chain_of(mechanism, kinematics), kinematics, slopes[:, :count], x)
    placed = placing(directions, default_outputs(directions.chain))
    shifts = row_shifts(directions, placed)
    position, begin = _positions(statics, kinematics, result)
    dx = (placed.start + shifts)[:, position]
    moved, along = directions.at(x)
    whole = moved.along(along, dx)
    side = Rows(mechanism, loading, kinematics, result).side
    _, changes = changes_of((mechanism, loading), slopes)
    given = Given(
        scene=statics.scene,
        place=statics.scene.place(result.theta, side),
        moved=whole,
        changes=changes,
        dtheta=travel.sense * (dx - (placed.start + shifts)[:, begin, None]),
        slopes=slopes,
        kinematics=kinematics,
        stepped=partial(_stepped, directions, placed, shifts),
        pole=0j,
    )
    given = given._replace(pole=complex(_seat(whole, mechanism.joint(mechanism.input.joint)).r[0]))
    shift = np.max(np.abs(dx), axis=1)
    gross = (moved.largest() + along.largest() * shift)[2] / moved.reach
    equilibrium = _Equilibrium(statics, given, result, side, gross)
    return ForcesDerivatives(dict(_columns(equilibrium, shifts[:, position], placed)))


def _positions(statics: Statics, kinematics: Kinematics, result: Forces) -> tuple[Any, int]:
    """The position of the kinematics of every row, and that at which the motion begins."""
    _, labels = statics.scene.travel.rows(kinematics)
    n = len(kinematics.labels)
    numbered = {label: i if i < n else 1 + (i - n) % (n - 1) for i, label in enumerate(labels)}
    begin = int(np.argmin(kinematics.phi * math.copysign(1.0, kinematics.speed)))
    return np.array([numbered[label.removesuffix("-")] for label in result.labels]), begin


def _stepped(directions: Directions, placed: Placing, shifts: Real, k: int, h: float) -> Kinematics:
    """The kinematics a step along a direction, as far as loads of the position read it."""
    own = directions.kinematics
    summaries = tuple(
        replace(
            summary,
            dead_centres=tuple(
                DeadCentre(centre.x + h * float(turns.x[k, i]), centre.value + h * float(turns.value[k, i]))
                for i, centre in enumerate(summary.dead_centres)
            ),
        )
        for summary, turns in zip(own.summaries, placed.turns, strict=True)
    )
    x, phi = own.x + h * (placed.start + shifts)[k], own.phi + h * shifts[k]
    return replace(own, x=x, phi=phi, summaries=summaries)


def _seat(moved: Moved, joint: Joint) -> _Seat:
    r, dr = moved.pin(joint, 0)
    if joint.kind == "revolute":
        return _Seat(joint, r[0, 0], dr[0], None, np.zeros(()) + 0j)
    e, de = moved.line(joint, 0)
    return _Seat(joint, r[0, 0], dr[0], e[0, 0], de[0])


class _Equilibrium:
    """The linear system at all rows, and the changes of all that the table tells."""

    def __init__(self, statics: Statics, given: Given, result: Forces, side: Real, gross: Real) -> None:
        self.result, self.given, self.statics = result, given, statics
        self.gross = gross  # (K,) relative changes of the motion of which those at the rows are made
        mechanism = statics.scene.chain.mechanism
        self.rows = {link.id: 3 * i for i, link in enumerate(mechanism.links)}
        self.seats = [_seat(given.moved, joint) for joint in mechanism.joints]
        self.rubs = [self._rub(seat.joint, side) for seat in self.seats]
        self.reach = given.moved.reach
        n, size = len(result.theta), 3 * len(self.rows)
        self.matrix = np.zeros((n, size, size))
        self.sides = np.zeros((size, *given.dtheta.shape))
        self.acted = given_loads(given)
        self._joints()
        self._drive()
        for acted in self.acted:
            self._add(self.sides, acted.link, acted.dforce, acted.dmoment)
        solved = np.linalg.solve(self.matrix, -np.moveaxis(self.sides, (0, 1), (1, 2)))
        self.changes = np.moveaxis(solved, (0, 1, 2), (2, 0, 1))  # (3 m, K, n)

    def _rub(self, joint: Joint, side: Real) -> _Rub | None:
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
        return _Rub(coefficient * sense, slope * sense, half, change.length / 2 if pair.length else np.zeros((1, 1)))

    def _add(self, place: Real, link: int, force: Any, moment: Any) -> None:
        row = self.rows[link]
        place[row] += np.real(force)
        place[row + 1] += np.imag(force)
        place[row + 2] += moment / self.reach

    def _both(self, place: Real, seat: _Seat, force: Any, moment: Any) -> None:
        """A force with its moment on the higher-numbered link of a joint, and back on the other."""
        low, high = sorted(seat.joint.links)
        self._add(place, high, force, moment)
        if low != FRAME:
            self._add(place, low, -force, -moment)

    def _unit(self, column: int, seat: _Seat, force: Any, couple: Any) -> None:
        """The column of an unknown that is this force at a joint with this couple."""
        place = np.moveaxis(self.matrix[:, :, column], 0, 1)
        self._both(place, seat, force, cross(seat.r - self.given.pole, force + 0j) + couple)

    def _moving(self, seat: _Seat, force: Plane, dforce: Any, dcouple: Any) -> None:
        """What a reaction does with its joint moved."""
        arm = seat.r - self.given.pole
        self._both(self.sides, seat, dforce, cross(seat.dr, force) + cross(arm, dforce + 0j) + dcouple)

    def _joints(self) -> None:
        for j, (seat, rub) in enumerate(zip(self.seats, self.rubs, strict=True)):
            force = self.result.reaction[j]
            if seat.e is None:
                size = np.maximum(np.abs(force), 1e-300)
                kappa = rub.kappa if rub is not None else 0.0
                self._unit(2 * j, seat, np.ones(len(size)) + 0j, -kappa * force.real / size)
                self._unit(2 * j + 1, seat, 1j * np.ones(len(size)), -kappa * force.imag / size)
                self._moving(seat, force, 0j, -rub.dkappa * np.abs(force) if rub is not None else 0.0)
                continue
            normal, friction = self.result.normal[j], self.result.friction[j]
            by_normal, by_couple, own = self._guide(j)
            self._unit(2 * j, seat, 1j * seat.e + by_normal * seat.e, 0.0)
            self._unit(2 * j + 1, seat, by_couple * seat.e, 1.0)
            self._moving(seat, force, (1j * normal + friction) * seat.de + own * seat.e, 0.0)

    def _guide(self, j: int) -> tuple[Any, Any, Any]:
        """Slopes of the friction along a guide by normal force and couple, and its own change (K, n)."""
        rub, normal, couple = self.rubs[j], self.result.normal[j], self.result.couple[j]
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
        chain, drive, last = self.given.scene.chain, self.result.drive, self.matrix.shape[1] - 1
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
        mesh, dmesh = self._mesh(gear)
        force = mesh * drive
        self._add(place, link, mesh, 1.0 + cross(arm, mesh))
        self._add(self.sides, link, dmesh * drive, cross(seat.dr, force) + cross(arm, dmesh * drive))

    def _mesh(self, gear: GearDrive) -> tuple[Plane, Plane]:
        """Force (n,) in the mesh to a unit of the moment, on its flank, and its change (K, n)."""
        change = self.given.changes.drive
        flank = np.sign(self.result.drive) * (1.0 if gear.internal else -1.0)
        beta, tangent = np.exp(1j * gear.pinion), math.tan(gear.mesh_angle)
        mesh = (1j + flank * tangent) * beta / gear.radius
        dmesh = flank * (1 + tangent**2) * change.mesh_angle * beta / gear.radius
        return mesh, dmesh + mesh * (1j * change.pinion - change.radius / gear.radius)

    @property
    def errors(self) -> tuple[Real, Real]:
        """What the changes of forces [N], and of moments, may be off by, (K,) each."""
        condition = float(np.max(np.linalg.cond(self.matrix, 1)))
        scale = np.max(np.abs(self.sides), axis=(0, 2)) + np.max(np.abs(self.changes), axis=(0, 2))
        scale = scale + self.gross * float(np.max(np.abs(self.result.reaction)))
        motion = float(np.max(self.given.moved.condition)) * max(EPS, self.given.kinematics.error.acceleration)
        rounding = MARGIN * (EPS * condition + max(motion, self.result.error)) * scale
        laws = [load for load in self.given.scene.loading.loads if isinstance(load.law, Placed)]
        if any(not isinstance(load.law, Constant) for load in laws):
            rounding = rounding + DIFFERENCE * condition * scale
        return rounding, rounding * self.reach


def _columns(found: _Equilibrium, shifts: Real, placed: Placing) -> Iterator[tuple[str, Derivative]]:
    """Derivatives by name of the columns that are given exactly."""
    result, changes = found.result, found.changes
    of_force, of_moment = found.errors
    told: dict[str, tuple[Real, Real]] = {}
    factor = 180 / math.pi if result.turns else 1.0
    phi = columns(result)[0].header
    yield phi, Derivative(factor * shifts, factor * (placed.error + EPS * np.max(np.abs(shifts), axis=1)))
    letter, drive = ("M_drive[N*m]", of_moment) if result.turns else ("F_drive[N]", of_force)
    speed, dspeed = result.speed, found.given.moved.changes.input.speed
    told[letter] = changes[-1], drive
    told["P_drive[W]"] = changes[-1] * speed + result.drive * dspeed, drive * abs(speed)
    for j, pair in enumerate(result.pairs):
        told |= _pair(found, j, pair.joint, of_force, of_moment)
    gear = found.given.scene.loading.drive
    if result.mesh is not None and isinstance(gear, GearDrive):
        mesh, dmesh = found._mesh(gear)
        whole = mesh * changes[-1] + dmesh * result.drive
        told["F_mesh_x[N]"], told["F_mesh_y[N]"] = (whole.real, of_force), (whole.imag, of_force)
    for each in columns(result):
        if each.header in told:
            yield each.header, Derivative(*told[each.header])


def _pair(found: _Equilibrium, j: int, name: str, of_force: Real, of_moment: Real) -> dict[str, tuple[Real, Real]]:
    """Changes of the columns of a pair with their errors."""
    result, seat, rub = found.result, found.seats[j], found.rubs[j]
    one, two = found.changes[2 * j], found.changes[2 * j + 1]
    force = result.reaction[j]
    told: dict[str, tuple[Real, Real]] = {}
    if seat.e is None:
        whole = one + 1j * two
        if rub is not None:
            size = (np.conj(force) * whole).real / np.maximum(np.abs(force), 1e-300)
            told[f"M_fr_{name}[N*m]"] = -rub.dkappa * np.abs(force) - rub.kappa * size, of_moment
    else:
        by_normal, by_couple, own = found._guide(j)
        friction = by_normal * one + by_couple * two + own
        whole = (1j * one + friction) * seat.e + (1j * result.normal[j] + result.friction[j]) * seat.de
        told[f"N_{name}[N]"], told[f"M_{name}[N*m]"] = (one, of_force), (two, of_moment)
        told[f"F_fr_{name}[N]"] = friction + np.zeros_like(one), of_force
        told |= _edges(found, j, name, one, two, of_force)
    told[f"R_{name}_x[N]"], told[f"R_{name}_y[N]"] = (whole.real, of_force), (whole.imag, of_force)
    size = np.abs(force)
    if np.all(size > 1e-12 * np.max(np.abs(result.reaction))):  # a force that vanishes has no direction to change along
        told[f"R_{name}[N]"] = (np.conj(force) * whole).real / size, of_force
    return told


def _edges(
    found: _Equilibrium, j: int, name: str, normal: Real, couple: Real, error: Real
) -> dict[str, tuple[Real, Real]]:
    """Changes of the edge reactions N/2 +- M/l of a slider of given length."""
    pairs, changes = found.given.scene.loading.pairs, found.given.changes.pairs
    own = [(p.length, dp.length) for p, dp in zip(pairs, changes, strict=True) if p.joint == name and p.length]
    if not own:
        return {}
    length, dlength = own[0]
    arm = couple / length - found.result.couple[j] * dlength / length**2
    size = error * (1 + found.reach / length)
    return {f"N'_{name}[N]": (normal / 2 + arm, size), f"N''_{name}[N]": (normal / 2 - arm, size)}
