"""What the teeth ask of the module: contact (4.38) and bending (4.41) endurance of every mesh, the worst of a stage.

    m_H^3 = K_d^3 T K_H (u +- 1)/u / (psi Z_1 Z^2 sigma_HP^2)      K_d = 770
    m_F^3 = K_m^3 T K_F Y_F / (psi Z_1 Z sigma_FP)                 K_m = 14

with T on the pinion of Z teeth and b = psi m Z_1; in the textbook Z_1 = Z. Both are written as m^3 = C K/psi, so that
the share of the permissible stress at any module and width is C K/(psi m^3): its root in contact, itself in bending.
K = 1 + beta psi grows with the width.
The constants are for N*m, MPa and mm. The tooth of every wheel is checked in bending; the tooth of a ring is taken as
that of a rack, which is thinner at its root.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tmmcalc.gears.model import ToothSets, Values
from tmmcalc.gears.scheme import Layout
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
    contact_module: Values  # m_H at psi_bd [m]
    bending_module: Values  # m_F at psi_bd [m]


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

    # the flanks of both wheels bear one stress, and the softer decides (4.38)
    permissible = np.array([wheel.permissible_contact for wheel in basis.wheels])
    sigma_HP = np.minimum(permissible[loads.pinion], permissible[loads.wheel])
    C_H = K_D3 * pinion_torque * loads.factor / (reference * loads.teeth**2 * sigma_HP**2)

    # of the teeth in mesh the one with the larger Y_F/sigma_FP decides (4.41)
    permissible = np.array([wheel.permissible_bending for wheel in basis.wheels])
    weakness = form_factors(sets, layout) / permissible
    pinion, wheel = (np.take_along_axis(weakness, columns, axis=1) for columns in (loads.pinion, loads.wheel))
    sigma_FP = permissible[np.where(pinion >= wheel, loads.pinion, loads.wheel)]
    C_F = K_M3 * pinion_torque * np.maximum(pinion, wheel) / (reference * loads.teeth)

    C_H, sigma_HP = _worst(C_H, sigma_HP, of_stage)
    C_F, sigma_FP = _worst(C_F, sigma_FP, of_stage)
    psi = basis.of_stages("psi_bd")
    m_H = np.cbrt(C_H * (1 + basis.of_stages("beta_contact") * psi) / psi)
    m_F = np.cbrt(C_F * (1 + basis.of_stages("beta_bending") * psi) / psi)
    return Demand(C_H, C_F, sigma_HP, sigma_FP, m_H, m_F)


def _worst(demands: Values, permissible: Values, of_stage: list[int]) -> tuple[Values, Values]:
    """Largest demand (n, stages) of the meshes of every stage, and the permissible stress there."""
    rows, columns = np.arange(len(demands)), []
    for stage in range(max(of_stage) + 1):
        meshes = [k for k, own in enumerate(of_stage) if own == stage]
        worst = demands[:, meshes].argmax(axis=1)
        columns.append((demands[:, meshes][rows, worst], permissible[:, meshes][rows, worst]))
    largest, beside = (np.stack(column, axis=1) for column in zip(*columns, strict=True))
    return largest, beside
