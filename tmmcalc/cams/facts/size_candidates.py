"""The sizes of a cam by each of its constraints alone, and which of them decides."""

from __future__ import annotations

from collections.abc import Mapping

from tmmcalc.cams.facts.cam_synthesis import KINDS
from tmmcalc.cams.synthesis.candidates import SizeCandidate
from tmmcalc.cams.synthesis.results import Synthesis
from tmmcalc.core.quantity import in_degrees, keyed, table
from tmmcalc.report.document import Document, Fact, View
from tmmcalc.report.numbers import number

NEVER = "note: a blank size: no size that was looked at keeps the constraint, all others left as they are"


def candidates_document(
    result: Synthesis, found: Mapping[str, SizeCandidate], title: str, *, everything: bool = False
) -> Document:
    """A row a constraint; ``everything`` is the values by the short names of the constraints."""
    follower = result.follower
    stem = result.kind != "oscillating"
    taken = f"R0 = {number(1e3 * follower.base)} mm" + (f", S0 = {number(1e3 * follower.start)} mm" if stem else "")
    binding = [each.constraint for each in found.values() if each.binds]
    facts = (
        Fact("follower", KINDS[result.kind], keyed(result, "kind")),
        Fact("size taken", taken, keyed(follower, "base")),
        Fact("decided by", " and ".join(binding) or result.governs, keyed(result, "governs")),
    )
    if everything:
        values = {name: in_degrees(keyed(each)) for name, each in found.items()}
        return Document(title, (*facts, Fact("candidates", "", {"candidates": values})))
    rows = list(found.values())
    sizes = ("base[mm]", "start[mm]") if stem else ("base[mm]",)
    columns = table(rows, SizeCandidate, "constraint", *sizes, "phi[deg]")
    columns["decides"] = ["yes" if each.binds else "" for each in rows]
    cells = [["" if cell is None else cell for cell in column] for column in columns.values()]
    notes = (NEVER,) if any(each.base is None for each in rows) else ()
    return Document(title, facts, notes, View(list(columns), cells))
