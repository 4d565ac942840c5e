"""The documents of the liner: shell and ring, what they do to each other, the largest stresses, the bore."""

from __future__ import annotations

from collections.abc import Sequence
from math import degrees

from tmmcalc.core.quantity import keyed
from tmmcalc.extras.columns import liner_columns
from tmmcalc.extras.facts.rows import even, view_of, with_table
from tmmcalc.extras.liner import Liner, Peak
from tmmcalc.report.document import Document, Fact
from tmmcalc.report.numbers import angle, number
from tmmcalc.report.sizes import quantity

FOLLOWED = {
    "edge": "the edge of the ring, which its turn moves too",
    "centre": "the centre of the ring, as in the source",
}
OTHER = {"edge": "centre", "centre": "edge"}


def summary(result: Liner, title: str) -> Document:
    """Shell, ring, the forces between them, the largest stresses."""
    shell = f"alpha = {number(result.alpha)} 1/m, D = {number(result.stiffness)} N*m"
    ring = f"F' = {number(1e6 * result.ring_area)} mm^2, I' = {number(1e12 * result.ring_inertia)} mm^4"
    other = f"Q0 = {number(result.other_force)} N/m, M0 = {number(result.other_couple)} N*m/m"
    end = f"w = {quantity(result.end, 'm')}, turn {angle(degrees(result.turn))} deg, "
    facts = (
        Fact("shell", shell, keyed(result, "alpha", "stiffness")),
        Fact("ring", ring, keyed(result, "ring_area", "ring_inertia")),
        Fact("moment on the ring", f"m = {number(result.moment)} N*m/m", keyed(result, "moment")),
        Fact(
            "between ring and shell",
            f"Q0 = {number(result.force)} N/m, M0 = {number(result.couple)} N*m/m; the end of the shell follows "
            f"{FOLLOWED[result.continuity]}",
            keyed(result, "force", "couple", "continuity"),
        ),
        Fact(f"by the {OTHER[result.continuity]} of the ring", other, keyed(result, "other_force", "other_couple")),
        Fact(
            "at the ring",
            f"{end}centre of the ring {quantity(result.centre, 'm')}",
            keyed(result, "end", "turn", "centre"),
        ),
        Fact("stress of the ring", quantity(result.ring_stress, "Pa"), keyed(result, "ring_stress")),
        Fact("largest stress of bending", _peak(result.bending), {"bending": keyed(result.bending)}),
        Fact("largest equivalent stress", _peak(result.largest), {"equivalent": keyed(result.largest)}),
    )
    return Document(title, facts, result.notes)


def document(
    result: Liner,
    title: str,
    *,
    patterns: Sequence[str] = (),
    rows: Sequence[int] | None = None,
    everything: bool = False,
    where: str = "",
) -> Document:
    """The summary with the shell along the bore."""
    view = view_of(liner_columns(result), patterns, rows, everything, even(len(result.x)))
    return with_table(summary(result, title), view, everything or rows is not None)


def _peak(at: Peak) -> str:
    return f"{quantity(at.stress, 'Pa')} at x = {quantity(at.x, 'm')}, {at.surface} surface"
