"""The variants of a sweep for a page: labels and keys that lead the rows of its CSV, as overrides of the spec."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from itertools import takewhile
from pathlib import Path
from typing import NamedTuple

from tmmcalc.batch.table import cells_of, is_key, number_of
from tmmcalc.core.errors import UsageError
from tmmcalc.core.headers import key_and_unit
from tmmcalc.core.stage import STAGES
from tmmcalc.page.said import Said, said
from tmmcalc.report.language import tr_measured
from tmmcalc.spec.variants import Axis

MOST = 24  # variants that a page has: of more, so many in equal steps
STATUS = "status"  # the column behind the results


class Swept(NamedTuple):
    """What was swept, and of each variant its name and the overrides that make it."""

    key: str
    variants: tuple[tuple[Said, tuple[str, ...]], ...]


def swept(file: Path) -> Swept:
    """The variants of a CSV of ``tmmcalc sweep`` that were solved; raises `UsageError` if it is none."""
    head, *rows = cells_of(file)
    labels = [*takewhile(lambda header: not is_key(header) and header != STATUS, head)]
    keys = _keys(head[len(labels) :])
    if not keys or STATUS not in head:
        raise UsageError(
            f"{file} is no table of a sweep: no swept key leads its columns, or it has no column {STATUS}",
            where="--sweep",
            remedy="write one by tmmcalc sweep SPEC --set KEY=RANGE -o FILE",
        )
    solved = [(line, row) for line, row in enumerate(rows, 2) if row[head.index(STATUS)] == "ok"]
    if not solved:
        rule = f"no variant of {file} is solved"
        raise UsageError(rule, where="--sweep", remedy="see the reasons in its last column")
    step = -(-len(solved) // MOST)
    axes = [Axis(key, (), unit) for key, unit in map(key_and_unit, keys)]
    variants = []
    for line, row in solved[::step]:
        numbered = zip(axes, keys, row[len(labels) :], strict=False)
        own = [(axis, number_of(file, line, key, cell, where="--sweep")) for axis, key, cell in numbered]
        name = ", ".join(row[: len(labels)]) or said(partial(_measured, own))
        variants.append((name, tuple(axis.assignment(value) for axis, value in own)))
    return Swept(", ".join(labels or (axis.key for axis in axes)), tuple(variants))


def _measured(own: Sequence[tuple[Axis, float]]) -> str:
    """Values with their units in the language in force."""
    return "; ".join(tr_measured(f"{value:.6g}", axis.unit) for axis, value in own)


def _keys(head: Sequence[str]) -> list[str]:
    """The headers that are keys of a spec: behind the first of them a stage begins the results."""
    found: list[str] = []
    for header in head:
        if not is_key(header) or (found and header.partition(".")[0] in STAGES):
            break
        found.append(header)
    return found
