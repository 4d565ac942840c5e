"""The documents of the kinematics stage: the summary, and the summary with the table of positions."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from tmmcalc.core.columns import Column
from tmmcalc.linkage.columns import columns
from tmmcalc.linkage.facts.kinematics_facts import facts_of, input_column, unit_fact
from tmmcalc.linkage.results import Kinematics
from tmmcalc.report.document import Document
from tmmcalc.report.positions import more, positions_view


def summary(result: Kinematics, title: str) -> Document:
    """Facts and notes, without the table of positions."""
    return Document(title, tuple(facts_of(result)), tuple(str(g) for g in result.grades))


def document(
    result: Kinematics,
    title: str,
    *,
    patterns: Sequence[str] = (),
    rows: Sequence[int] | None = None,
    dimensionless: bool = False,
    everything: bool = False,
    where: str = "",
    further: Sequence[Column] = (),
) -> Document:
    """Summary and table of positions.

    ``patterns`` choose columns by name, header or wildcard, ``rows`` positions by index; ``everything`` takes
    all columns (for csv, json, toml). Without either the columns that a reader looks at first come first and
    the terminal cuts the rest. ``further`` columns are there if ``patterns`` name them.
    """
    available = columns(result, dimensionless=dimensionless)
    told = summary(result, title)
    return replace(
        told,
        facts=(*told.facts, *([unit_fact(result)] if dimensionless else [])),
        table=positions_view(
            result.labels,
            available,
            usual=available if everything else _first(result, available),
            patterns=patterns,
            rows=rows,
            everything=everything,
            further=further,
        ),
        wide=not patterns,
        more=more(where),
    )


def _first(result: Kinematics, available: list[Column]) -> list[Column]:
    """Both input coordinates, outputs, links and the rest; no transfer functions, and no given velocities."""
    drive = input_column(result)
    link, joint = result.structure.input_link, result.input_joint
    given = {f"angle_{link}", f"omega_{link}", f"eps_{link}", f"v_{joint}", f"a_{joint}"} - {drive}
    shown = [c for c in available if not c.name.startswith("d") and c.name not in given]
    return sorted(shown, key=lambda c: (c.name != "phi", c.name != drive, not c.name.startswith(("S_", "vS_", "aS_"))))
