"""The columns of sized tooth sets: wheels, required and standard modules, face widths, stresses, the outcome.

m_H m_F         modules that contact and bending ask for
governs         which of the two decides
m psi b         standard (or given) module, width coefficient psi*, face width
sigma_H sigma_F stresses at this module and width; sigma_HP, sigma_FP the permissible ones, margin_H, margin_F the
                unused part of them, negative where a stage is overloaded
K_Hbeta K_Fbeta load distribution of these stresses
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmmcalc.gears.joined import joined
from tmmcalc.gears.sizing import Sized, Sizing
from tmmcalc.gears.strength.series import Outcome

OUTCOMES = {
    Outcome.ACCEPTED: "accepted",
    Outcome.NO_MODULE: "no module",
    Outcome.NO_PAIR: "no pair",
    Outcome.OVERLOADED: "overloaded",
    Outcome.PROPORTION: "proportion",
}


def sized_columns(sized: Sized) -> dict[str, np.ndarray]:
    """Every column of one variant by its header."""
    sets, found = sized.sets, sized.strength
    columns = {
        "layout": np.full(len(sets), sets.layout),
        "K": np.full(len(sets), sets.planets),
        **{f"z_{wheel}": sets.of(wheel) for wheel in sets.scheme.wheels},
    }
    for stage in range(sets.scheme.stages):
        columns |= dict(_of_stage(sized, stage))
    words = np.array([OUTCOMES[outcome] for outcome in Outcome])
    return {**columns, "outcome": words[found.outcome]}


def _of_stage(sized: Sized, k: int) -> Iterator[tuple[str, np.ndarray]]:
    found, stage = sized.strength, k + 1
    yield f"m_H_{stage}[m]", found.contact_module[:, k]
    yield f"m_F_{stage}[m]", found.bending_module[:, k]
    yield f"governs_{stage}", np.where(found.contact_governs[:, k], "contact", "bending")
    yield f"m_{stage}[m]", found.module[:, k]
    yield f"psi_{stage}", found.psi[:, k]
    yield f"b_{stage}[m]", found.width[:, k]
    yield f"sigma_H_{stage}[Pa]", found.contact_stress[:, k]
    yield f"sigma_HP_{stage}[Pa]", found.permissible_contact[:, k]
    yield f"margin_H_{stage}", found.contact_margin[:, k]
    yield f"sigma_F_{stage}[Pa]", found.bending_stress[:, k]
    yield f"sigma_FP_{stage}[Pa]", found.permissible_bending[:, k]
    yield f"margin_F_{stage}", found.bending_margin[:, k]
    yield f"K_Hbeta_{stage}", found.contact_spread[:, k]
    yield f"K_Fbeta_{stage}", found.bending_spread[:, k]


def stacked(sizing: Sizing) -> dict[str, np.ndarray]:
    """The columns of all variants, one after the other, rows numbered from 1."""
    columns = joined([sized_columns(sized) for sized in sizing.variants if len(sized.sets)])
    return {"i": np.arange(1, len(columns["layout"]) + 1), **columns}
