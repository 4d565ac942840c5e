"""What the teeth ask of the module: contact (4.38) and bending (4.41) endurance of every mesh, the worst of a stage.

    m_H^3 = K_d^3 T K_H (u +- 1)/u / (psi Z_1 Z^2 sigma_HP^2)      K_d = 770
    m_F^3 = K_m^3 T K_F Y_F / (psi Z_1 Z sigma_FP)                 K_m = 14

with T on the pinion of Z teeth and b = psi m Z_1; in the textbook Z_1 = Z. Both are written as m^3 = C K/psi, so that
the share of the permissible stress at any module and width is C K/(psi m^3): its root in contact, itself in bending.
The constants are for N*m, MPa and mm. The tooth of every wheel is checked in bending; the tooth of a ring is taken as
that of a rack, which is thinner at its root.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tmmcalc.gears.layouts import Layout
from tmmcalc.gears.model import ToothSets, Values
from tmmcalc.gears.strength.basis import Basis
from tmmcalc.gears.strength.loads import MeshLoads

K_D = 770.0
K_M = 14.0
K_D3 = K_D**3 * 1e3  # in m, N*m, Pa
K_M3 = K_M**3 * 1e-3
RACK_FORM = 3.568  # Y_F of infinitely many teeth
LEAST_TEETH = 15  # for which the fit of Y_F holds


class Demand(NamedTuple):
    """Governing demand of every stage, arrays (n, stages)."""

    contact: Values  # m_H^3 psi/K_H [m^3]
    bending: Values  # m_F^3 psi/K_F [m^3]
    permissible_contact: Values  # of the mesh with the largest C_H [Pa]
    permissible_bending: Values  # of the wheel with the largest C_F [Pa]


def form_factor(teeth: Values) -> Values:
    """Form factor Y_F of unshifted external teeth, a fit to the chart of GOST 21354-75 from 15 teeth up.

    >>> round(float(form_factor(np.array(20.0))), 4)
    4.0729
    """
    return RACK_FORM + 201.95 / teeth**2


def form_factors(sets: ToothSets, layout: Layout) -> Values:
    """Form factors (n, wheels) of all wheels, rings as racks."""
    ring = np.array([wheel in layout.rings for wheel in layout.wheels])
    return np.where(ring, RACK_FORM, form_factor(1.0 * sets.teeth))


def demand(sets: ToothSets, torque: float, basis: Basis, loads: MeshLoads) -> Demand:
    """Governing demand of every stage of every train for T1 = ``torque`` [N*m] of all branches."""
    layout = sets.scheme
    of_stage = [mesh.stage for mesh in layout.meshes]
    reference = loads.reference[:, of_stage]
    pinion_torque = torque * loads.q / sets.planets
    sigma_HP = _contact_stress(basis, loads)
    C_H = K_D3 * pinion_torque * loads.factor / (reference * loads.teeth**2 * sigma_HP**2)
    weakness, sigma_FP = _weaker_tooth(form_factors(sets, layout), basis, loads)
    C_F = K_M3 * pinion_torque * weakness / (reference * loads.teeth)
    contact = [_worst(C_H, sigma_HP, of_stage, k) for k in range(layout.stages)]
    bending = [_worst(C_F, sigma_FP, of_stage, k) for k in range(layout.stages)]
    columns = (part for side in (contact, bending) for part in zip(*side, strict=True))
    C_H, sigma_HP, C_F, sigma_FP = (np.stack(column, axis=1) for column in columns)
    return Demand(C_H, C_F, sigma_HP, sigma_FP)


def _contact_stress(basis: Basis, loads: MeshLoads) -> Values:
    """The flanks of both wheels of a mesh bear one stress; the softer decides."""
    permissible = np.array([wheel.permissible_contact for wheel in basis.wheels])
    return np.minimum(permissible[loads.pinion], permissible[loads.wheel])


def _weaker_tooth(forms: Values, basis: Basis, loads: MeshLoads) -> tuple[Values, Values]:
    """Largest Y_F/sigma_FP (n, meshes) of the two wheels of every mesh, and the sigma_FP of that wheel."""
    permissible = np.array([wheel.permissible_bending for wheel in basis.wheels])
    pinion, wheel = (
        np.take_along_axis(forms / permissible, columns, axis=1) for columns in (loads.pinion, loads.wheel)
    )
    weaker = np.where(pinion >= wheel, loads.pinion, loads.wheel)
    return np.maximum(pinion, wheel), permissible[weaker]


def _worst(demands: Values, permissible: Values, of_stage: list[int], stage: int) -> tuple[Values, Values]:
    """Largest demand (n,) of the meshes of a stage, and the permissible stress there."""
    meshes = [k for k, own in enumerate(of_stage) if own == stage]
    worst = demands[:, meshes].argmax(axis=1)
    rows = np.arange(len(demands))
    return demands[:, meshes][rows, worst], permissible[:, meshes][rows, worst]
