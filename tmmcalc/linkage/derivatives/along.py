"""Directions along which a solved linkage with what acts on it changes, and how the places of its cycle move."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from typing import Any, NamedTuple

import numpy as np

from tmmcalc.core.numerics.alike import numbers
from tmmcalc.core.plane import Real
from tmmcalc.linkage.chain import chain_of
from tmmcalc.linkage.derivatives.closure import Slopes, changes_of
from tmmcalc.linkage.derivatives.equilibrium import Equilibrium, Rows, seat_of
from tmmcalc.linkage.derivatives.loads import Given
from tmmcalc.linkage.derivatives.rows import Directions, Placing, directions_of, placing, row_shifts
from tmmcalc.linkage.forces.kinetostatics import Statics
from tmmcalc.linkage.loading import Loading
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.outputs import default_outputs
from tmmcalc.linkage.results import DeadCentre, Kinematics


class Along(NamedTuple):
    """Directions along which a solved linkage and what acts on it change, and how its places move."""

    statics: Statics
    directions: Directions
    placed: Placing
    shifts: Real  # (K, n) of the positions
    slopes: Slopes
    changes: Any  # of the loading
    begin: Real  # (K,) change of the input coordinate at which the motion begins

    def equilibrium(self, theta: Real, side: Real, rows: Rows, dx: Real, error: float) -> Equilibrium:
        """The changes at theta (n,) from its sides, where the input coordinates move by dx (K, n)."""
        travel, mechanism = self.statics.scene.travel, self.statics.scene.chain.mechanism
        moved, along = self.directions.at(travel.x(theta))
        whole = moved.along(along, dx)
        given = Given(
            scene=self.statics.scene,
            place=self.statics.scene.place(theta, side),
            moved=whole,
            changes=self.changes,
            dtheta=travel.sense * (dx - self.begin[:, None]),
            slopes=self.slopes,
            kinematics=self.directions.kinematics,
            stepped=partial(_stepped, self.directions, self.placed, self.shifts),
            pole=complex(seat_of(whole, mechanism.joint(mechanism.input.joint)).r[0]),
        )
        shift = np.max(np.abs(dx), axis=1)
        gross = (moved.largest() + along.largest() * shift)[2] / moved.reach
        return Equilibrium(self.statics, given, rows, side, gross, error)


def along_of(
    mechanism: Mechanism,
    loading: Loading,
    kinematics: Kinematics,
    statics: Statics,
    slopes: Slopes,
    begin: int,
    theta: Real,
) -> Along:
    """Along slopes (K, L) of the numbers of mechanism and loading, with all that is known at ``theta`` (n,).

    ``begin`` is the position at which the motion begins.
    """
    x = statics.scene.travel.x(theta)
    count = len(numbers(mechanism))
    directions = directions_of(mechanism, chain_of(mechanism, kinematics), kinematics, slopes[:, :count], x)
    placed = placing(directions, default_outputs(directions.chain))
    shifts = row_shifts(directions, placed)
    _, changes = changes_of((mechanism, loading), slopes)
    return Along(statics, directions, placed, shifts, slopes, changes, (placed.start + shifts)[:, begin])


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
