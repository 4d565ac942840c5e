"""The document of the textbook's friction passes: one row a solution, the solution that they creep to below them."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmmcalc.core.plane import Real
from tmmcalc.core.quantity import Quantity, keyed, quantity_of
from tmmcalc.linkage.forces.columns import FRICTION, FRICTION_MOMENT
from tmmcalc.linkage.forces.iteration import Iteration
from tmmcalc.report.document import Document, Fact, View

SOLUTION = "solution"  # label of the row that the passes are compared with
CHANGE = quantity_of(Iteration, "change").shown("%")[0]
OFF = Quantity("off[%]", "largest distance of an unknown from the solution, as a part of it").key
UNKNOWN = Quantity("{name}[{unit}]", "unknown {name} of the group")
ARM = ".h"  # ends the name of an arm, which is in metres among forces
LEAST_ARM = 1e-12  # [m]
NOISE = 1e-12  # of the largest force


def iteration_document(found: Iteration, title: str, stop: float) -> Document:
    """Unknowns and friction of every pass, how much they changed, how far they are off the solution.

    A blank stands where nothing can be compared: the first pass changes nothing, a group that locks itself has no
    solution. ``stop`` is the relative change at which the passes were to end.
    """
    acting = ", ".join(f"{joint} on link {link}" for joint, link in found.acting)
    facts = (
        Fact("group", found.group, keyed(found, "group")),
        Fact("reactions and friction", f"what is done in {acting}; friction that the reactions of the row give"),
        Fact("stop", f"no unknown changes by more than {100 * stop:g} %", {"stop": stop}),
        _passes_fact(found),
    )
    return Document(title, facts, tuple(_notes(found)), _view(found), wide=True, more="print them with --format csv")


def _passes_fact(found: Iteration) -> Fact:
    text = str(found.passes)
    if found.exact is not None:
        text += f"; the last is off by {100 * _off(found)[-1]:.2g} % of the solution"
    return Fact("passes", text, keyed(found, "passes", "stopped"))


def _notes(found: Iteration) -> Iterator[str]:
    if not found.joints:
        yield "note: no pair of this group has friction, so the first pass is the solution"
    elif not found.stopped:
        yield "warning: the passes do not settle: near self-locking take the solution, not the passes"


def _off(found: Iteration) -> Real:
    """Largest relative distance (m,) of an unknown of every pass from the solution; one that is nothing counts not."""
    assert found.exact is not None
    size, arms = np.abs(found.exact), np.array([name.endswith(ARM) for name in found.names])
    counts = size > np.where(arms, LEAST_ARM, NOISE * np.max(size[~arms]))
    return np.max(np.abs(found.unknowns - found.exact)[:, counts] / size[counts], axis=1, initial=0.0)


def _view(found: Iteration) -> View:
    unknowns = [UNKNOWN.of(name=name, unit="m" if name.endswith(ARM) else "N").key for name in found.names]
    told = {each.unit: each for each in (FRICTION, FRICTION_MOMENT)}
    friction = [
        told[unit].of(pin=joint, slide=joint).key for joint, unit in zip(found.joints, found.units, strict=True)
    ]
    label = [str(k + 1) for k in range(found.passes)]
    rows = np.hstack((found.unknowns, found.friction[1:]))
    change: list[float | str] = ["", *(100 * found.change[1:]).tolist()]
    off: list[float | str] = [""] * found.passes
    if found.exact is not None and found.exact_friction is not None:
        label.append(SOLUTION)
        rows = np.vstack((rows, np.concatenate((found.exact, found.exact_friction))))
        change.append("")
        off = [*(100 * _off(found)).tolist(), ""]
    headers = ["pass", CHANGE, OFF, *friction, *unknowns]
    count = len(found.names)
    columns = [label, change, off, *rows[:, count:].T.tolist(), *rows[:, :count].T.tolist()]
    return View(headers, columns, scientific=[CHANGE, OFF])
