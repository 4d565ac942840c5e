"""Which stages of the gear room a scene wants, and which results they read, where the spec gives none.

Nothing heavy is imported here, because plans ask about every stage.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tmmcalc.gears.room import GearTables

NO_KEPT = "no [[constraints]] on its rows: none is judged"
TRAIN = ("criteria",)  # the stage that chooses the best train


def ratio_of_drive(spec: GearTables) -> bool:
    """Whether neither a ratio nor speeds of its shafts are given for the train: the machine that it drives has it."""
    table = spec.train
    return table is not None and table.ratio is None and (table.input_speed is None or table.output_speed is None)


def read_by_train(spec: GearTables) -> tuple[str, ...]:
    """A ratio that is given wins."""
    return ("drive",) if ratio_of_drive(spec) else ()


def strength(spec: GearTables) -> str | None:
    """Modules are those of tooth sets under a torque; trains are compared by these sizes."""
    if not spec.train:
        return "no [train]: no tooth numbers are asked for"
    return "no [strength]: no torque and no materials" if spec.strength is None else None


def read_by_strength(spec: GearTables) -> tuple[str, ...]:
    """A torque, or the moment that it follows from, stands in place of the largest reduced moment."""
    table = spec.strength
    given = table is None or table.torque is not None or table.moment is not None
    return () if given else ("reduction",)


def open_pair(spec: GearTables) -> str | None:
    """The pair between the reducer and the crank."""
    return None if spec.open_pair is not None else "no [open_pair]: no gear on the crank"


def read_by_open_pair(spec: GearTables) -> tuple[str, ...]:
    """A moment on the crank that is given stands in place of the largest reduced one."""
    table = spec.strength
    return () if table is not None and table.moment is not None else ("reduction",)


def pair(spec: GearTables) -> str | None:
    """Pairs are written out, or those of a train that is chosen; every pair has profiles."""
    if spec.pair is None:
        return None if spec.open_pair is not None else "no [pair]: no pair of gears is asked for"
    return strength(spec) if pairs_of_train(spec) else None


def read_by_pair(spec: GearTables) -> tuple[str, ...]:
    """Pairs that are written out need no train."""
    return TRAIN if pairs_of_train(spec) else ()


def blocking(spec: GearTables) -> str | None:
    """The contour is that of two external wheels."""
    reason = pair(spec)
    if reason is None and not pairs_of_train(spec) and "external" not in _kinds(spec):
        return "no external pair: a ring or a rack has no blocking contour"
    return reason


def pairs_of_train(spec: GearTables) -> bool:
    """Whether the pairs of the spec are those of its train."""
    return spec.pair is not None and spec.pair.of_train


def _kinds(spec: GearTables) -> set[str]:
    """Kinds of the pairs that are written out."""
    table, on_crank = spec.pair, spec.open_pair
    found = set() if on_crank is None else {on_crank.kind or "external"}
    if table is None:
        return found
    general = table.kind or "external"
    return found | ({mesh.kind or general for mesh in table.meshes} or {general})
