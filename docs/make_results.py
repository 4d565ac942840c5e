"""Write docs/results.md: ``make docs``. What the stages give out, as it is declared on the fields of their results."""

from __future__ import annotations

from collections.abc import Iterator
from importlib import import_module
from inspect import getmodule
from pathlib import Path
from pkgutil import walk_packages

from tmmcalc.core.manifest import Room
from tmmcalc.core.quantity import Quantity, given_out, standing_in
from tmmcalc.core.stage import Stage
from tmmcalc.rooms import ROOMS, STAGES

PAGE = Path(__file__).parent / "results.md"
HEAD = """# Results

What the stages give out, by the names that JSON, CSV, `sweep --columns` and `[[constraints]]` have for them. A name in
braces stands for one of the scene: `x_{point}[m]` is `x_B[m]`, `x_C[m]` ... In one document a quantity has one unit:
lengths are in m, speeds in rad/s, angles in deg, those of gears and vibrations in rad. `make docs` writes this page
from the fields of the results.
"""
IN_RADIANS = ("gears", "vibration")  # rooms whose documents tell angles as they are kept


def page() -> str:
    """The whole page."""
    parts = [HEAD]
    for room in ROOMS:
        listed: set[Quantity] = set()
        for stage in room.stages:
            told = _once(_of_stage(STAGES[stage.name]))
            listed |= {*told}
            if told:
                rows = _rows(told, room.name)
                parts.append("\n".join((f"## `{stage.name}`\n{stage.title}\n", *rows, "")))
        further = [each for each in _once(_of_room(room)) if each not in listed]
        if further:
            parts.append(
                "\n".join(
                    (
                        f"## Further in {room.name}\ncolumns, figures of tables and of plans\n",
                        *_rows(further, room.name),
                        "",
                    )
                )
            )
    return "\n".join(parts)


def _of_stage(stage: Stage) -> Iterator[Quantity]:
    """What the results of a stage give out, and what heads its columns besides."""
    for kind in stage.kinds:
        yield from given_out(kind)
    if columns := stage.part("columns"):
        yield from standing_in(getmodule(columns))


def _of_room(room: Room) -> Iterator[Quantity]:
    """All that is declared in a room."""
    for module in walk_packages(import_module(room.home).__path__, f"{room.home}."):
        if not {"pictures", "tables", "accuracy"} & {*module.name.split(".")}:
            yield from standing_in(import_module(module.name))


def _once(told: Iterator[Quantity]) -> list[Quantity]:
    """Those that differ in key or meaning."""
    return list({(each.key, each.meaning): each for each in told}.values())


def _rows(told: list[Quantity], room: str) -> Iterator[str]:
    yield "| key | meaning | symbol | source |"
    yield "|---|---|---|---|"
    for each in told:
        symbol = f"`{each.symbol}`" if each.symbol else ""
        key = each.key if room in IN_RADIANS else each.key.replace("[rad]", "[deg]")
        cells = (f"`{key}`", each.meaning, symbol, each.source)
        yield f"| {' | '.join(cell.replace('|', chr(92) + '|') for cell in cells)} |".replace("  |", " |")


if __name__ == "__main__":
    PAGE.write_text(page(), encoding="utf-8")
