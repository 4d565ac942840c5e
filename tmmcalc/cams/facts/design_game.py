"""The design game as a table: every option with the lowest mechanism of its own, and which of them buys most."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from tmmcalc.cams.follower import along
from tmmcalc.cams.optimum.results import CamOptimum, Option, Relaxation
from tmmcalc.core.quantity import keyed, quantity_of, table
from tmmcalc.report.document import Document, Fact, View
from tmmcalc.report.sizes import quantity

GAIN = quantity_of(Relaxation, "gain")
FOUND = (
    *("height", "start", "roller", "least", "active", "stress", "contact", "torque", "driving"),
    *("stiffness", "preload"),
)
NOTHING = 1e-8  # [m] a difference of two least heights that is none


def game_facts(result: CamOptimum) -> Iterator[Fact]:
    """The option that lowers the mechanism most, against what is asked."""
    if not result.options:
        return
    base, best, size = result.options[0], _best_first(result)[0], result.names["height"]
    less = "less" if result.kind == "oscillating" else "lower"
    values = keyed(best, "changes", "least", **result.names)
    if base.refused:
        text = f"{best.name}: least {size} = {quantity(best.least, 'm')}; as asked there is no solution"
        yield Fact("option that buys most", text, values)
        return
    gain = base.least - best.least
    if gain > NOTHING:
        text = (
            f"{best.name}: least {size} = {quantity(best.least, 'm')} against {quantity(base.least, 'm')}, "
            f"{quantity(gain, 'm', 3)} {less}"
        )
    else:
        text = f"none of {len(result.options) - 1} options is {less} than what is asked"
    yield Fact("option that buys most", text, values | {GAIN.key: gain})


def game_document(result: CamOptimum) -> Document:
    """All options that have a solution, the lowest first; of the others why not."""
    refused = [Fact(each.name, each.refused) for each in result.options if each.refused]
    return Document("design game: options compared", tuple(refused), (), _view(result))


def _best_first(result: CamOptimum) -> list[Option]:
    return sorted((each for each in result.options if not each.refused), key=lambda each: each.least)


def _view(result: CamOptimum) -> View:
    rows, base = _best_first(result), result.options[0]
    lengths = table(rows, Option, "least[mm]", **result.names)
    if not base.refused:
        gain, millimetres = GAIN.shown("mm")
        lengths[gain] = [millimetres * (base.least - each.least) for each in rows]
    turns = result.kind == "oscillating"
    own = ("length[mm]",) if turns else ()
    lengths |= table(rows, Option, "height[mm]", *own, "start[mm]", "roller[mm]", **result.names)
    stiffness = "stiffness" if turns else "stiffness[N/mm]"
    told = ("stress[MPa]", "contact", "torque", "driving", stiffness, "preload")
    sizes = table(rows, Option, *told, **along(turns))
    columns: dict[str, list[Any]] = {
        "option": [each.name for each in rows],
        **{header: [round(value, 6) for value in column] for header, column in lengths.items()},
        "active": [" ".join(map(str, each.active)) for each in rows],
        **{
            header: [round(value, places) for value in column]
            for (header, column), places in zip(sizes.items(), (4, 4, 6, 6, 6, 4), strict=True)
        },
    }
    return View(list(columns), list(columns.values()))


def option_values(each: Option, names: Mapping[str, str]) -> dict[str, Any]:
    """One option for programs, in SI; ``names`` are those of its sizes."""
    asked = keyed(each, "changes", "law", "safety", "allowed", "ratio")
    said = {key: value for key, value in asked.items() if value is not None}
    if each.refused:
        return said | keyed(each, "refused")
    own = () if each.length is None else ("length",)
    return said | keyed(each, *FOUND, *own, **names, **along(each.length is not None))
