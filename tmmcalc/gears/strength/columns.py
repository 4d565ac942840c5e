"""The columns of sized tooth sets: wheels, required and standard modules, face widths, stresses, the outcome."""

from __future__ import annotations

import numpy as np

from tmmcalc.core.quantity import Quantity, components
from tmmcalc.gears.columns import stacked_tables
from tmmcalc.gears.sizing import Sized, Sizing
from tmmcalc.gears.strength.series import Outcome

BRANCHES = Quantity("K", "number of planets or layshafts, which share the power")
NUMBER = Quantity("i", "number of the train, from 1")
STAGE = (  # of every stage, in the order of its columns
    *("contact_module", "bending_module", "contact_governs", "module", "psi", "width"),
    *("contact_stress", "permissible_contact", "contact_margin"),
    *("bending_stress", "permissible_bending", "bending_margin", "contact_spread", "bending_spread"),
)
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
        BRANCHES.key: np.full(len(sets), sets.planets),
        **components(sets, "teeth", wheel=sets.scheme.wheels),
    }
    stages = range(1, sets.scheme.stages + 1)
    for of_stage in zip(*(components(found, name, stage=stages).items() for name in STAGE), strict=True):
        columns |= {header: _in_words(column) for header, column in of_stage}
    words = np.array([OUTCOMES[outcome] for outcome in Outcome])
    return {**columns, "outcome": words[found.outcome]}


def _in_words(column: np.ndarray) -> np.ndarray:
    """What governs a stage by its name; every other column as it is."""
    return np.where(column, "contact", "bending") if column.dtype == np.bool_ else column


def stacked(sizing: Sizing) -> dict[str, np.ndarray]:
    """The columns of all variants, one after the other, rows numbered from 1."""
    columns = stacked_tables([sized_columns(sized) for sized in sizing.variants if len(sized.sets)])
    return {NUMBER.key: np.arange(1, len(columns["layout"]) + 1), **columns}
