"""What the requirements are made of at points: curvature, what makes the roller slip, stresses, moment of the shaft."""

from __future__ import annotations

from dataclasses import fields

import numpy as np

from tmmcalc.cams.forces.formulas import Mask
from tmmcalc.cams.forces.state import State
from tmmcalc.cams.forces.turn import Points
from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.strength.case import Case, contact_curvature, roller_acceleration
from tmmcalc.cams.strength.formulas import contact_stress, flat_stress, reduced_moment, slip
from tmmcalc.cams.strength.results import Rolling
from tmmcalc.cams.strength.shaftstem import bending_of, pressure_of
from tmmcalc.core.records import record


@record
class RequirementRows:
    """At m points, each (m,); what has no data is None."""

    curvature: Values  # kappa [1/m] of the pitch curve, or of the profile under a flat face
    run: Values | None  # A [m] of the roller
    slip: Values | None  # D; 0 where nothing presses
    stress: Values | None  # sigma_H [Pa]
    reduced: Values | None  # M_E [N*m]
    bending: Values | None  # stress of the stem [Pa]
    pressure: Values | None  # larger pressure of the two edges of the guide [Pa]
    touching: Mask  # a wall presses on the roller

    def named(self) -> dict[str, Values]:
        """What there is, by its name."""
        every = {each.name: getattr(self, each.name) for each in fields(self) if each.name != "touching"}
        return {name: values for name, values in every.items() if values is not None}


def rows_of(case: Case, rolling: Rolling | None, at: Points, now: State) -> RequirementRows:
    """The rows at points with the forces there."""
    kappa = contact_curvature(case.follower, at.motion)
    run = roller_acceleration(case.task, case.loads, case.follower, at, now.contact)
    span = case.task.requirements.span
    touching = np.abs(now.contact) > 0 if case.grooved else now.contact > 0
    return RequirementRows(
        curvature=kappa,
        run=None if case.flat else run,
        slip=_slip(case, rolling, now, run),
        stress=_stress(case, now, kappa, touching),
        reduced=None if span is None else reduced_moment(now.contact, now.torque, span, case.task.requirements.torsion),
        bending=bending_of(case, now, at.motion),
        pressure=pressure_of(case, now),
        touching=touching,
    )


def _slip(case: Case, rolling: Rolling | None, now: State, run: Values) -> Values | None:
    if rolling is None:
        return None
    friction = case.task.requirements.roller_friction or 1.0
    grown, works = slip(
        now.contact, run, rolling.resisting, rolling.inertia, case.loads.speed, friction, case.follower.roller
    )
    return np.where(works, np.abs(grown), 0.0)


def _stress(case: Case, now: State, kappa: Values, touching: Mask) -> Values | None:
    """sigma_H at the rows; None without its data or with a cusp."""
    width, modulus = case.task.requirements.width, case.task.requirements.modulus
    if width is None or case.cusped or not (case.flat or case.follower.roller):
        return None
    if case.flat:
        found, _ = flat_stress(now.contact, 1 / kappa, width, modulus)
    else:
        found, _ = contact_stress(now.contact, kappa, case.follower.roller, width, modulus)
    return np.where(touching, found, 0.0)
