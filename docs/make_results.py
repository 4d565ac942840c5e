"""Write docs/results.md: ``make docs``. What the stages give out, as it is declared on the fields of their results."""

from __future__ import annotations

from collections.abc import Iterator
from inspect import getmodule
from pathlib import Path
from typing import Any

from tmmcalc.core.quantity import Quantity, given_out
from tmmcalc.core.stage import Stage
from tmmcalc.rooms import ROOMS, STAGES

PAGE = Path(__file__).parent / "results.md"
HEAD = """# Results

What the stages give out, by the names that JSON, CSV, `sweep --columns` and `[[constraints]]` have for them. A name in
braces stands for one of the scene: `x_{point}[m]` is `x_B[m]`, `x_C[m]` ... `make docs` writes this page from the
fields of the results.
"""


def page() -> str:
    """The whole page."""
    parts = [HEAD]
    for room in ROOMS:
        for stage in room.stages:
            told = list(_told(STAGES[stage.name]))
            if told:
                parts.append("\n".join((f"## `{stage.name}`\n{stage.title}\n", *_rows(told), "")))
    return "\n".join(parts)


def _told(stage: Stage) -> Iterator[Quantity]:
    """What the results of a stage give out, and what heads its columns besides."""
    found: dict[str, Quantity] = {}
    for kind in stage.kinds:
        found |= {key: each for key, each in given_out(kind).items() if key not in found}
    if columns := stage.part("columns"):
        own = _within(tuple(vars(getmodule(columns)).values()))
        found |= {each.key: each for each in own if each.key not in found}
    yield from found.values()


def _within(value: Any) -> Iterator[Quantity]:
    """Quantities that stand in a module by themselves, or several together."""
    if isinstance(value, Quantity):
        yield value
    elif isinstance(value, tuple):
        for each in value:
            yield from _within(each)


def _rows(told: list[Quantity]) -> Iterator[str]:
    yield "| key | meaning | symbol | source |"
    yield "|---|---|---|---|"
    for each in told:
        symbol = f"`{each.symbol}`" if each.symbol else ""
        cells = (f"`{each.key}`", each.meaning, symbol, each.source)
        yield f"| {' | '.join(cell.replace('|', chr(92) + '|') for cell in cells)} |".replace("  |", " |")


if __name__ == "__main__":
    PAGE.write_text(page(), encoding="utf-8")
