"""Derivatives of the results of the forces stage by its inputs: of the columns of its table, and of its extremes.

Extremes inside the cycle change as the force at their place does (the envelope theorem); those at the beginning or at a
dead centre, where friction and loads jump, go with it. Others are not given, nor is the mean power.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import numpy as np

from tmmcalc.core.derivatives import Derivative
from tmmcalc.core.headers import key_and_unit
from tmmcalc.core.plane import Real
from tmmcalc.core.records import record
from tmmcalc.linkage.derivatives.along import along_of
from tmmcalc.linkage.derivatives.closure import EPS, Slopes
from tmmcalc.linkage.derivatives.equilibrium import Equilibrium
from tmmcalc.linkage.derivatives.force_extremes import ForceExtremes, extremes_of
from tmmcalc.linkage.derivatives.loads import exact
from tmmcalc.linkage.derivatives.rows import Placing
from tmmcalc.linkage.forces.columns import columns
from tmmcalc.linkage.forces.kinetostatics import Statics
from tmmcalc.linkage.forces.results import Forces
from tmmcalc.linkage.forces.rows import Rows
from tmmcalc.linkage.loading import GearDrive, Loading
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.results import Kinematics


@record
class ForcesDerivatives:
    """Derivatives along K directions of the columns of the forces table by ``name[unit]``, those given exactly."""

    columns: dict[str, Derivative]
    extremes: ForceExtremes | None  # None: not asked for


def differentiate_forces(
    mechanism: Mechanism,
    loading: Loading,
    kinematics: Kinematics,
    result: Forces,
    slopes: Slopes,
    *,
    extremes: bool = False,
) -> ForcesDerivatives | None:
    """Derivatives of a result along K directions: ``slopes`` (K, L) of the numbers of mechanism and loading.

    The numbers are those of the pair, mechanism first, in the order of `core.numerics.alike.numbers`. None where a load
    is not given exactly, see `loads`; ``extremes``: whether they are asked for. Rows keep their labels; where friction
    jumps at a row it stays on its side.
    """
    solved = Rows(mechanism, loading, kinematics, result)
    statics = solved.statics
    if not exact(statics.scene):
        return None
    position, begin = _positions(statics, kinematics, result)
    made = along_of(mechanism, loading, kinematics, statics, slopes, begin, result.theta)
    dx = (made.placed.start + made.shifts)[:, position]
    found = made.equilibrium(result.theta, solved.side, result, dx, result.error)
    told = dict(_columns(found, result, made.shifts[:, position], made.placed))
    if not extremes:
        return ForcesDerivatives(told, None)
    still = np.zeros((1, slopes.shape[1]), slopes.dtype)
    both = along_of(mechanism, loading, kinematics, statics, np.concatenate((slopes, still)), begin, result.theta)
    return ForcesDerivatives(told, extremes_of(both, result))


def _positions(statics: Statics, kinematics: Kinematics, result: Forces) -> tuple[Any, int]:
    """The position of the kinematics of every row, and that at which the motion begins."""
    _, labels = statics.scene.travel.rows(kinematics)
    n = len(kinematics.labels)
    numbered = {label: i if i < n else 1 + (i - n) % (n - 1) for i, label in enumerate(labels)}
    begin = int(np.argmin(kinematics.phi * math.copysign(1.0, kinematics.speed)))
    return np.array([numbered[label.removesuffix("-")] for label in result.labels]), begin


def _columns(found: Equilibrium, result: Forces, shifts: Real, placed: Placing) -> Iterator[tuple[str, Derivative]]:
    """Derivatives by name of the columns that are given exactly."""
    changes = found.changes
    of_force, of_moment = found.errors
    told: dict[str, tuple[Real, Real]] = {}
    factor = 180 / math.pi if result.turns else 1.0
    phi = columns(result)[0].header
    yield phi, Derivative(factor * shifts, factor * (placed.error + EPS * np.max(np.abs(shifts), axis=1)))
    letter, drive = ("M_drive", of_moment) if result.turns else ("F_drive", of_force)
    speed, dspeed = result.speed, found.given.moved.changes.input.speed
    told[letter] = changes[-1], drive
    told["P_drive"] = changes[-1] * speed + result.drive * dspeed, drive * abs(speed)
    for j, pair in enumerate(result.pairs):
        told |= _pair(found, result, j, pair.joint, of_force, of_moment)
    gear = found.given.scene.loading.drive
    if result.mesh is not None and isinstance(gear, GearDrive):
        mesh, dmesh = found.mesh_of(gear)
        whole = mesh * changes[-1] + dmesh * result.drive
        told["F_mesh_x"], told["F_mesh_y"] = (whole.real, of_force), (whole.imag, of_force)
    for each in columns(result):
        name, _ = key_and_unit(each.header)
        if name in told:
            yield each.header, Derivative(*told[name])


def _pair(
    found: Equilibrium, result: Forces, j: int, name: str, of_force: Real, of_moment: Real
) -> dict[str, tuple[Real, Real]]:
    """Changes of the columns of a pair with their errors."""
    seat, rub = found.seats[j], found.rubs[j]
    one, two = found.changes[2 * j], found.changes[2 * j + 1]
    force = result.reaction[j]
    told: dict[str, tuple[Real, Real]] = {}
    if seat.e is None:
        whole = found.reaction(j)
        if rub is not None:
            size = (np.conj(force) * whole).real / np.maximum(np.abs(force), 1e-300)
            told[f"M_fr_{name}"] = -rub.dkappa * np.abs(force) - rub.kappa * size, of_moment
    else:
        by_normal, by_couple, own = found.guide(j)
        friction = by_normal * one + by_couple * two + own
        whole = found.reaction(j)
        told[f"N_{name}"], told[f"M_{name}"] = (one, of_force), (two, of_moment)
        told[f"F_fr_{name}"] = friction + np.zeros_like(one), of_force
        told |= _edges(found, j, name, one, two, of_force)
    told[f"R_{name}_x"], told[f"R_{name}_y"] = (whole.real, of_force), (whole.imag, of_force)
    size = np.abs(force)
    if np.all(size > 1e-12 * np.max(np.abs(result.reaction))):  # a force that vanishes has no direction to change along
        told[f"R_{name}"] = (np.conj(force) * whole).real / size, of_force
    return told


def _edges(
    found: Equilibrium, j: int, name: str, normal: Real, couple: Real, error: Real
) -> dict[str, tuple[Real, Real]]:
    """Changes of the edge reactions N/2 +- M/l of a slider of given length."""
    pairs, changes = found.given.scene.loading.pairs, found.given.changes.pairs
    own = [(p.length, dp.length) for p, dp in zip(pairs, changes, strict=True) if p.joint == name and p.length]
    if not own:
        return {}
    length, dlength = own[0]
    arm = couple / length - found.rows.couple[j] * dlength / length**2
    size = error * (1 + found.reach / length)
    return {f"N'_{name}": (normal / 2 + arm, size), f"N''_{name}": (normal / 2 - arm, size)}
