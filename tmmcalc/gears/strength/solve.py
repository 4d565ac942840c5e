"""Strength of n trains at once: the modules and face widths that they need, or the stresses of those that they have.

Assumptions: spur gears without profile shift, power shared evenly between branches, long life, no losses.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tmmcalc.core.errors import UsageError
from tmmcalc.core.notes import Note, Phrase
from tmmcalc.gears.model import Integers, ToothSets, Values
from tmmcalc.gears.scheme import Layout
from tmmcalc.gears.strength.basis import Basis, basis_of
from tmmcalc.gears.strength.demand import Demand, demand
from tmmcalc.gears.strength.loads import MeshLoads, mesh_loads
from tmmcalc.gears.strength.results import Strength
from tmmcalc.gears.strength.series import EIGHTHS, Flags, Outcome, choose, choose_tied, eighths, tied
from tmmcalc.gears.strength.task import WHERE, Rounding, StrengthTask

NARROWEST, WIDEST = 6.0, 40.0  # usual b/m
SLACK = 1e-9  # relative: a limit that is met exactly counts as kept, a width in whole millimetres stays
PER_MM = 1000  # millimetres in a metre


class _Sizes(NamedTuple):
    """Modules and widths, each (n, stages), and the outcome (n,)."""

    module: Values
    psi: Values
    width: Values
    outcome: Integers


def solve_strength(sets: ToothSets, task: StrengthTask) -> Strength:
    """Modules, face widths, stresses and margins of every train of ``sets``.

    Without modules in the task the standard ones are found; given ones are checked. Raises `UsageError` for what
    the tables do not have and for wheels that cannot mesh. Textbook (4.38) to (4.42), Table D.4.9.
    """
    layout = sets.scheme
    if sets.planets < 1:
        raise UsageError(f"{sets.planets} branches", where=WHERE, value=sets.planets, limit=1, remedy="one or more")
    basis = basis_of(layout, task)
    loads = mesh_loads(sets)
    asked = demand(sets, task.torque, basis, loads)
    sizes = (_checked if task.checks else _designed)(sets, task, basis, asked, loads)
    actual = sizes.width / (sizes.module * loads.reference)
    psi_K = actual if task.checks or task.iterate else np.broadcast_to(basis.of_stages("psi_bd"), actual.shape)
    K_H, K_F = 1 + basis.of_stages("beta_contact") * psi_K, 1 + basis.of_stages("beta_bending") * psi_K
    borne = actual * sizes.module * sizes.module * sizes.module
    share_H, share_F = asked.contact * K_H / borne, asked.bending * K_F / borne
    return Strength(
        layout=sets.layout,
        torque=task.torque,
        checked=task.checks,
        contact_module=asked.contact_module,
        bending_module=asked.bending_module,
        module=sizes.module,
        psi=sizes.psi,
        width=sizes.width,
        contact_spread=K_H,
        bending_spread=K_F,
        contact_stress=asked.permissible_contact * np.sqrt(share_H),
        bending_stress=asked.permissible_bending * share_F,
        permissible_contact=asked.permissible_contact,
        permissible_bending=asked.permissible_bending,
        outcome=_overloaded(sizes.outcome, share_H, share_F) if task.checks else sizes.outcome,
        psi_unusual=_outside(sizes.psi, basis.of_stages("low"), basis.of_stages("high")),
        width_unusual=_outside(sizes.width / sizes.module, NARROWEST, WIDEST),
        least_teeth=_least_teeth(sets, layout),
        coefficients=basis.coefficients,
        warnings=(*basis.warnings, *_not_standard(task)),
    )


def _designed(sets: ToothSets, task: StrengthTask, basis: Basis, asked: Demand, loads: MeshLoads) -> _Sizes:
    """Standard modules, and the widths that bring the governing stress to its limit."""
    required = np.maximum(asked.contact_module, asked.bending_module)
    if tied(sets.scheme):
        scale = task.on_overload == "scale"
        module, outcome = choose_tied(required, _proportion(sets), task.rows, task.underrun, scale=scale)
    else:
        module, outcome = choose(required, task.rows, task.underrun)
    psi = adapted(basis.of_stages("psi_bd"), required, module)
    if task.iterate:
        psi = _iterated(basis, asked, module, psi)
    width = face_width(psi, module if task.width_rule == "consistent" else required, loads.reference, task.rounding)
    return _Sizes(module, psi, width, outcome)


def adapted(psi: Values | float, required: Values, module: Values) -> Values:
    """Coefficient psi* with which ``module`` is as strong as ``required`` is with ``psi``. Textbook (4.42)."""
    return psi * (required / module) ** 3


def face_width(psi: Values | float, module: Values, teeth: Values, rounding: Rounding = "ceil") -> Values:
    """Face width b = psi m Z [m] in whole millimetres; arrays of one shape.

    "ceil" rounds up; "floor1", as the textbook's program, adds a whole millimetre to a whole number too.

    >>> float(face_width(0.6, np.array(2e-3), np.array(20.0))), float(face_width(0.6, 2e-3, 20.0, "floor1"))
    (0.024, 0.025)
    """
    width = psi * module * teeth * PER_MM
    whole = np.ceil(width * (1 - SLACK)) if rounding == "ceil" else np.floor(width * (1 + SLACK)) + 1
    return whole / PER_MM


def _iterated(basis: Basis, asked: Demand, module: Values, psi: Values) -> Values:
    """The fixed point psi = C (1 + beta psi)/m^3 of K_beta at psi*; ``psi`` itself where the module is too small."""
    betas, found = (basis.of_stages("beta_contact"), basis.of_stages("beta_bending")), []
    for C, beta in zip((asked.contact, asked.bending), betas, strict=True):
        room = module**3 - C * beta
        found.append(np.where(room > 0, C / np.where(room > 0, room, 1.0), psi))
    return np.maximum(*found)


def _checked(sets: ToothSets, task: StrengthTask, basis: Basis, asked: Demand, loads: MeshLoads) -> _Sizes:
    """Given modules with their given widths, or those of psi_bd as they are."""
    module = np.broadcast_to(_spread(task.modules, sets, "modules"), asked.contact.shape)
    outcome = np.full(len(sets), Outcome.ACCEPTED, dtype=np.int64)
    if tied(sets.scheme):
        proportion = _proportion(sets)
        in_proportion = module[:, :1] * proportion / proportion[:, :1]
        module = in_proportion if len(task.modules) == 1 else module
        outcome[(abs(module - in_proportion) > SLACK * module).any(axis=1)] = Outcome.PROPORTION
    if not task.widths:
        psi = np.broadcast_to(basis.of_stages("psi_bd"), module.shape)
        return _Sizes(module, psi, psi * module * loads.reference, outcome)
    width = np.broadcast_to(_spread(task.widths, sets, "face widths"), module.shape)
    return _Sizes(module, width / (module * loads.reference), width, outcome)


def _spread(given: tuple[float, ...], sets: ToothSets, what: str) -> Values:
    """One value of every stage (stages,)."""
    stages = sets.scheme.stages
    if len(given) not in (1, stages):
        raise UsageError(
            f"{len(given)} {what} are given; the layout {sets.layout} has {stages} stages",
            where=WHERE,
            value=len(given),
            limit=stages,
            remedy="give one for every stage, or one for all",
        )
    return np.array(given * (stages if len(given) == 1 else 1))


def _proportion(sets: ToothSets) -> Integers:
    """Modules of the stages to one another (n, stages)."""
    stages = sets.scheme.stages
    if sets.modules.shape != (len(sets), stages) or (sets.modules.size and sets.modules.min() < 1):
        raise UsageError(
            f"modules of the shape {sets.modules.shape} to one another; positive ones of {len(sets)} sets in "
            f"{stages} stages are needed",
            where=WHERE,
            remedy="give the proportion m1 : m2 of every set",
        )
    return sets.modules


def _overloaded(outcome: Integers, share_H: Values, share_F: Values) -> Integers:
    over = (np.maximum(share_H, share_F) > 1 + SLACK).any(axis=1)
    return np.where(over & (outcome == Outcome.ACCEPTED), Outcome.OVERLOADED, outcome)


def _outside(values: Values, low: Values | float, high: Values | float) -> Flags:
    outside: Flags = (values < low * (1 - SLACK)) | (values > high * (1 + SLACK))
    return outside


def _least_teeth(sets: ToothSets, layout: Layout) -> Integers:
    external = [k for k, wheel in enumerate(layout.wheels) if wheel not in layout.rings]
    least: Integers = sets.teeth[:, external].min(axis=1)
    return least


def _not_standard(task: StrengthTask) -> tuple[Note, ...]:
    """A warning for every given module that Table D.4.8 does not have."""
    told = []
    for module in task.modules:
        if not any(abs(module * EIGHTHS - entry) < SLACK * entry for entry in eighths()):
            told.append(
                Note("warning", Phrase("a module of {module:g} mm is not in Table D.4.8", module=module * 1000))
            )
    return tuple(told)
