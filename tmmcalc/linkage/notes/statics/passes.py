"""Friction by successive approximations: reactions, friction from them, reactions again (textbook 3.2.7, D.3.3)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from tmmcalc.linkage.forces.iteration import Iteration, textbook_iteration
from tmmcalc.linkage.forces.results import side_of
from tmmcalc.linkage.forces.wrench import Plan
from tmmcalc.linkage.notes.statics.loaded import Loaded, printed_head
from tmmcalc.linkage.notes.statics.pairs import ToldPair, along
from tmmcalc.report.language import tr, tr_number
from tmmcalc.report.manuscript import Block, Paragraph, Table
from tmmcalc.report.telling import cell, column_of, located

STOP = 1e-4  # of the magnitude of a reaction: a change at which the passes end
FIRST, LAST = 3, 3  # passes that a long table shows
MOST = 50
LEAST = 1e-9  # of an unknown [N, mm]: less is rounding


def passes(loaded: Loaded, plan: Plan, pairs: Sequence[ToldPair]) -> Iterator[Block]:
    """A table of the passes for each shown position; nothing where no pair of the group rubs."""
    if not any(post.coefficient > 0 for post in plan.posts):
        return
    by_joint = {pair.joint.name: pair for pair in pairs}
    tables = []
    for shown, row in enumerate(loaded.rows):
        theta, side = float(loaded.result.theta[row]), side_of(loaded.result, row)
        found = textbook_iteration(loaded.statics, plan.group.name, theta, side, STOP, MOST, "reactions")
        caption = tr(
            "Successive approximations of group {name} {place}", name=plan.group.name, place=loaded.told.there(shown)
        )
        tables.append(_table(found, by_joint, loaded, caption, f"forces_passes_{plan.group.links[0]}_{row}"))
    yield Paragraph(
        tr(
            "The reactions are first found without friction; they give friction forces and moments, with which the "
            "reactions are found again, until no reaction changes by more than {stop} % of its magnitude; the passes "
            "are {where}. The formulas below hold for the solution to which these successive approximations lead.",
            stop=tr_number(f"{100 * STOP:g}"),
            where=located(tables),
        )
    )
    yield from tables


def _table(found: Iteration, pairs: Mapping[str, ToldPair], loaded: Loaded, caption: str, key: str) -> Table:
    """The friction that each pass is solved with, the unknowns that it gives, the largest change."""
    shown = [*range(found.passes)]
    if found.passes > FIRST + LAST:
        shown = [*shown[:FIRST], *shown[-LAST:]]
    slot = next((pair for pair in [*pairs.values()][1:2] if pair.joint.kind == "prismatic"), None)
    rows = []
    exact = [np.nan] * len(found.joints) if found.exact_friction is None else found.exact_friction
    for k, (joint, unit) in enumerate(zip(found.joints, found.units, strict=True)):
        pair = pairs[joint]
        letter, sense = ("M", 1.0) if unit == "N*m" else ("F", along(loaded, pair))
        head, factor = printed_head(f"{letter}_{{{pair.ij}}}", unit)
        rows.append((head, *column_of(sense * factor * np.append(found.friction[:-1, k][shown], exact[k]))))
    ends = [np.nan] * len(found.names) if found.exact is None else found.exact
    for k, name in enumerate(found.names):
        joint, _, part = name.rpartition(".")
        symbol, unit, sense = _unknown(loaded, pairs[joint], part, slot)
        values = sense * np.append(found.unknowns[:, k][shown], ends[k])
        if np.nanmax(np.abs(values)) > LEAST:
            head, factor = printed_head(symbol, unit)
            rows.append((head, *column_of(factor * values)))
    shift = [cell(100 * each, 2) for each in found.shift]
    rows.append((tr("Largest change of a reaction, %"), *("–" if k == 0 else shift[k] for k in shown), "–"))
    return Table(caption, (tr("Pass"), *(str(k + 1) for k in shown), tr("solution")), tuple(rows), key)


def _unknown(loaded: Loaded, pair: ToldPair, part: str, slot: ToldPair | None) -> tuple[str, str, float]:
    """The symbol of an unknown, its unit, and its factor to this unit and to the sense of the formulas.

    With an inner prismatic pair, the ``slot``, the parts of an outer reaction are those along and across its line.
    """
    ij = pair.ij
    if pair.joint.kind == "prismatic":
        sense = along(loaded, pair)
        return (f"N_{{{ij}}}", "N", sense) if part == "N" else (f"h_{{{ij}}}", "mm", 1e3 * sense)
    if part in "xy":
        return f"R_{{{ij}{part}}}", "N", 1.0
    if slot is None:
        return {"T": f"R_{{{ij}}}^t", "N": f"R_{{{ij}}}^n"}[part], "N", 1.0
    sense = along(loaded, slot)
    return (f"R_{{{ij}}}^e", "N", -sense) if part == "T" else (f"R_{{{ij}}}^n", "N", sense)
