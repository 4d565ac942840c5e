"""Which stages of the linkage room a scene wants: None, or the reason why it leaves the stage out.

Nothing heavy is imported here, because plans ask about every stage.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from tmmcalc.core.stage import CSV_ROWS

if TYPE_CHECKING:
    from tmmcalc.linkage.room import LinkageTables

TURN = 2 * math.pi
FRICTION = "no friction in any pair: no friction is solved, no self-locking sought"
SPRINGS = "no [[springs]]: no forces of springs and dampers"
NO_CSV = f"its csv is not written: more than {CSV_ROWS} rows"
SLIDES = "the input is a driven slider: its motion is no cycle"


def moves(spec: LinkageTables) -> str | None:
    """What moves, and has groups, is a mechanism."""
    return None if spec.mechanism is not None else "no [mechanism]"


def forces(spec: LinkageTables) -> str | None:
    """Nothing acts on a linkage without loads, masses and springs."""
    if spec.mechanism is None:
        return moves(spec)
    if has_masses(spec) or spec.loads or spec.springs:
        return None
    return "no loads, masses or springs: nothing acts on the links"


def paths(spec: LinkageTables) -> str | None:
    """A path is asked for, and a mechanism has it."""
    return moves(spec) or ("no [[paths]]: no path is wanted" if not spec.paths else None)


def unsteady(spec: LinkageTables) -> str | None:
    """A motion from rest to rest is asked for, and a mechanism makes it."""
    return moves(spec) or ("no [unsteady]: no motion from rest to rest is asked for" if not spec.unsteady else None)


def has_masses(spec: LinkageTables) -> bool:
    """Whether a link has a mass or an inertia."""
    return spec.mechanism is not None and any(link.mass or link.inertia for link in spec.mechanism.links)


def slides(spec: LinkageTables) -> bool:
    """Whether the input is a driven slider."""
    joints, driven = (spec.mechanism.joints, spec.mechanism.input.joint) if spec.mechanism is not None else ((), "")
    return any(joint.name == driven and joint.kind == "prismatic" for joint in joints)


def acyclic(spec: LinkageTables) -> str | None:
    """Why the motion of the linkage is no cycle; None if its crank turns fully."""
    if spec.mechanism is None:
        return moves(spec)
    if slides(spec):
        return SLIDES
    span = spec.mechanism.grid.span
    if span is not None and abs(span - TURN) > 1e-9:
        return "grid.span is not a full turn: the motion is no cycle"
    return None


def is_long(spec: LinkageTables) -> bool:
    """Whether the equal steps alone, or those of both strokes, make more rows than a CSV is written of."""
    if spec.mechanism is None:
        return False
    grid = spec.mechanism.grid
    both = grid.working is not None and grid.idle is not None
    return ((grid.working or 0) + (grid.idle or 0) + 1 if both else grid.positions + 1) > CSV_ROWS


def interpolated(spec: LinkageTables) -> bool:
    """Whether monotone cubics run through the points of a load."""
    if not spec.loads:
        return False
    from tmmcalc.linkage.loadlaws import laws

    return any(law.smooth(load) for load in spec.loads for law in set(laws().values()))
