"""The documents of the kinematics stage: the summary, and the summary with the table of positions."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from tmmcalc.linkage.columns import Column, columns, select
from tmmcalc.linkage.results import Kinematics
from tmmcalc.report.document import Document, View
from tmmcalc.report.facts import facts_of, input_column, unit_fact


def kinematics_summary(result: Kinematics, title: str) -> Document:
    """Facts and notes, without the table of positions."""
    return Document(title, tuple(facts_of(result)), tuple(str(g) for g in result.grades))


def kinematics_document(
    result: Kinematics,
    title: str,
    *,
    patterns: Sequence[str] = (),
    rows: Sequence[int] | None = None,
    dimensionless: bool = False,
    everything: bool = False,
    where: str = "",
) -> Document:
    """Summary and table of positions.

    ``patterns`` choose columns by name, header or wildcard, ``rows`` positions by index; ``everything`` takes
    all columns (for csv, json, toml). Without either the columns that a reader looks at first come first and
    the terminal cuts the rest.
    """
    available = columns(result, dimensionless=dimensionless)
    names = {"i": "", **{c.header: c.name for c in available}}
    wanted = [name for name in (names.get(p, p) for p in patterns) if name]
    usual = available if everything else _first(result, available)
    chosen = select(available, wanted) if patterns else usual
    summary = kinematics_summary(result, title)
    return replace(
        summary,
        facts=(*summary.facts, *([unit_fact(result)] if dimensionless else [])),
        table=_view(result.labels, chosen, range(len(result.labels)) if rows is None else rows),
        wide=not patterns,
        more=f"choose with --columns, e.g. --columns 'phi,x_*'{f', or see {where}' if where else ''}",
    )


def _view(labels: Sequence[str], chosen: Sequence[Column], rows: Sequence[int]) -> View:
    values = [c.make() for c in chosen]
    return View(
        ["i", *(c.header for c in chosen)],
        [[labels[k] for k in rows], *([float(v[k]) for k in rows] for v in values)],
        [0.0, *(float(abs(v).max()) for v in values)],
    )


def _first(result: Kinematics, available: list[Column]) -> list[Column]:
    """Both input coordinates, outputs, links and the rest; no transfer functions, and no given velocities."""
    drive = input_column(result)
    link, joint = result.structure.input_link, result.input_joint
    given = {f"angle_{link}", f"omega_{link}", f"eps_{link}", f"v_{joint}", f"a_{joint}"} - {drive}
    shown = [c for c in available if not c.name.startswith("d") and c.name not in given]
    return sorted(shown, key=lambda c: (c.name != "phi", c.name != drive, not c.name.startswith(("S_", "vS_", "aS_"))))
