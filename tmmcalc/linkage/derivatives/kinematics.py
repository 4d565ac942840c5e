"""Derivatives of the results of the kinematics stage by its inputs, exact: of every column, of strokes and extremes.

A column is followed at its row: dq/dp = q_p + q_x dx/dp, where x of the row moves with position 0.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmmcalc.core.derivatives import Derivative
from tmmcalc.core.plane import Real
from tmmcalc.core.records import record
from tmmcalc.linkage.chain import chain_of
from tmmcalc.linkage.columns import columns
from tmmcalc.linkage.derivatives.closure import EPS, Moved, Slopes
from tmmcalc.linkage.derivatives.rates import Rates, size_of
from tmmcalc.linkage.derivatives.rows import directions_of, placing, row_shifts
from tmmcalc.linkage.derivatives.summaries import OutputDerivatives, summary_of
from tmmcalc.linkage.derivatives.transmission import transmissions_of
from tmmcalc.linkage.model import Mechanism, Output
from tmmcalc.linkage.outputs import default_outputs
from tmmcalc.linkage.results import Kinematics


@record
class KinematicsDerivatives:
    """Derivatives along K directions of the inputs.

    ``columns`` by ``name[unit]``; ``transmission`` by group: of its smallest angle [rad], None where it is a right
    angle. ``x`` (K, n): how the input coordinates of the rows move. Where two places have the same extreme, it is
    followed at the one that the result names, which is one side of a kink.
    """

    columns: dict[str, Derivative]
    outputs: tuple[OutputDerivatives, ...]
    transmission: dict[str, Derivative | None]
    x: Real
    speed: Real  # (K,) of the input, and its acceleration
    acceleration: Real


def differentiate_kinematics(mechanism: Mechanism, kinematics: Kinematics, slopes: Slopes) -> KinematicsDerivatives:
    """Derivatives of a result along K directions: ``slopes`` (K, L) of the numbers of the mechanism.

    The numbers stand in the order of `core.numerics.alike.numbers`. The error of a derivative is the rounding of the
    linear systems: their condition times the last digit of the largest change, with the error of what they stand on.
    """
    chain = chain_of(mechanism, kinematics)
    directions = directions_of(mechanism, chain, kinematics, slopes, kinematics.x)
    outputs = default_outputs(chain)
    placed = placing(directions, outputs)
    shifts = row_shifts(directions, placed)
    dx = placed.start + shifts
    moved, along = directions.at(kinematics.x)
    whole = moved.along(along, dx)
    drive = directions.changes.input
    rates = Rates(kinematics.speed, kinematics.acceleration, drive.speed, drive.acceleration)
    size = size_of(kinematics, moved, along, dx, placed)
    found = [Derivative(shifts, placed.error + EPS * np.max(np.abs(shifts), axis=1))]
    found += _columns(whole, outputs, rates, size)
    told = columns(kinematics)
    scaled = {
        each.header: Derivative(np.degrees(one.value), np.degrees(one.error)) if each.unit == "deg" else one
        for each, one in zip(told, found, strict=True)
    }
    summaries = zip(outputs, kinematics.summaries, strict=True)
    return KinematicsDerivatives(
        columns=scaled,
        outputs=tuple(
            summary_of(directions, placed, rates, k, output, summary) for k, (output, summary) in enumerate(summaries)
        ),
        transmission=dict(transmissions_of(directions, placed)),
        x=dx,
        speed=np.asarray(drive.speed)[:, 0],
        acceleration=np.asarray(drive.acceleration)[:, 0],
    )


def _columns(whole: Moved, outputs: tuple[Output, ...], rates: Rates, size: Real) -> Iterator[Derivative]:
    """Derivatives of all columns after phi in their order."""
    chain = whole.chain
    for number, output in enumerate(outputs):
        jet, change = whole.output(output, number)
        change = np.concatenate((change[:1] - change[:1, :, :1], change[1:]))
        yield from _five(jet, change, rates, 2 * size / (whole.reach if output.link is not None else 1.0))
    for link in chain.layout.links:
        u = whole.bodies[link].u
        omega, eps = (u[1] / u[0]).imag, (u[2] / u[0]).imag
        yield from _five(np.stack([omega, omega, eps]), whole.links[link].angle, rates, size / whole.reach)
    for name, link, _ in chain.layout.points:
        r, dr = whole.named(link, name)
        yield from _five(r.real, dr.real, rates, size)
        yield from _five(r.imag, dr.imag, rates, size)
    for joint in chain.layout.joints:
        yield from _five(*whole.slide(chain.mechanism.joint(joint)), rates, size)


def _five(jet: Real, change: Real, rates: Rates, size: Real) -> Iterator[Derivative]:
    """Derivatives of a value, its velocity and acceleration, its first and second transfer function."""
    values = (change[0], rates.velocity(jet, change), rates.in_time(jet, change), change[1], change[2])
    for value, error in zip(values, rates.sizes(size), strict=True):
        yield Derivative(value, error)
