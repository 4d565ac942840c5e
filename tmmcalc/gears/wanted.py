"""Which stages of the gear room a scene wants, and which results they read, where the spec gives none.

Nothing heavy is imported here, because plans ask about every stage.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tmmcalc.gears.room import GearTables

NO_KEPT = "no [[constraints]] on its rows: none is judged"
TRAIN = ("criteria",)  # the stage that chooses the best train


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


def pair(spec: GearTables) -> str | None:
    """Pairs are written out, or those of a train that is chosen; every pair has profiles."""
    if spec.pair is None:
        return "no [pair]: no pair of gears is asked for"
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
    table = spec.pair
    if table is None:
        return set()
    general = table.kind or "external"
    return {mesh.kind or general for mesh in table.meshes} or {general}
