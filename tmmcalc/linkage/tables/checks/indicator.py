"""Checks of ``[loads.indicator]``: the piston, and strokes that run over their whole way."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.linkage.tables.checks.written_linkage import written_linkage
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline, Raw, tables
from tmmcalc.spec.phrases import Path, show
from tmmcalc.spec.values import amounts, first_disorder


def check_indicator(outline: Outline, load: Raw, path: Path) -> Iterator[Finding]:
    """Yield the faults of the indicator diagram of a load, which stands at this path."""
    indicator = load["indicator"]
    if not isinstance(indicator, dict):
        return
    yield from _check_piston(outline, load, indicator, path)
    strokes = indicator.get("strokes")
    if isinstance(strokes, list) and len(strokes) not in (2, 4):
        yield Finding(
            (*path, "strokes"),
            f"{len(strokes)} stroke{'s' if len(strokes) != 1 else ''}: the cycle of a cylinder has two or four",
            "write one { x = [...], p = [...] } for each stroke of the cycle",
        )
    for index, stroke in tables(indicator, "strokes"):
        yield from _check_stroke(stroke, (*path, "strokes", index))


def _check_piston(outline: Outline, load: Raw, indicator: Raw, path: Path) -> Iterator[Finding]:
    if "diameter" in indicator and "area" in indicator:
        yield Finding((*path, "area"), "diameter and area together: the piston is measured once", "remove one of them")
    if not {"diameter", "area"} & {*indicator}:
        yield Finding(path, "missing key: an indicator diagram needs the size of its piston", 'add diameter = "80 mm"')
    if load.get("axes"):
        yield Finding(
            (*path[:-1], "axes"),
            "an indicator diagram belongs to a cylinder in the frame; its direction does not turn with a link",
            "remove axes; the direction points from the closed end to the crank",
        )
    if written_linkage(outline).slides:
        yield Finding(
            path, "an indicator diagram with a driven slider: its strokes follow a crank", "give the force as a table"
        )


def _check_stroke(stroke: Raw, path: Path) -> Iterator[Finding]:
    x, p = stroke.get("x"), stroke.get("p")
    if isinstance(x, list) and isinstance(p, list) and len(x) != len(p) > 1 < len(x):
        yield Finding(
            (*path, "p"), f"{len(p)} pressures for {len(x)} distances x", "write one pressure for each distance"
        )
    numbers = amounts(x)
    if numbers is None or len(numbers) < 2 or min(numbers) < 0 or max(numbers) > 1:
        return
    if {numbers[0], numbers[-1]} != {0.0, 1.0}:
        yield Finding(
            (*path, "x"),
            f"{show(x)} does not run over the whole stroke",
            "write distances from 0 (the closed end) to 1, or from 1 to 0",
        )
        return
    disorder = first_disorder(numbers if numbers[0] < numbers[-1] else [-number for number in numbers])
    if disorder is not None:
        yield Finding(
            (*path, "x", disorder),
            f"{stroke['x'][disorder]} after {stroke['x'][disorder - 1]}: the distances run one way",
            "put them in order",
        )
