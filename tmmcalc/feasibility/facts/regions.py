"""The document of a map of feasible parameters: a sign a point for people, a row a point for programs."""

from __future__ import annotations

from collections import Counter

import numpy as np

from tmmcalc.core.quantity import keyed, quantities, quantity_of
from tmmcalc.feasibility.logic import Values
from tmmcalc.feasibility.maps import Parameter, RegionMap
from tmmcalc.report.document import Document, Fact, View
from tmmcalc.report.numbers import column

HOLDS, SEVERAL, NOTHING = ".", "*", "-"
SIGNS = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
WAYS = ("to the right", "upwards")
WIDEST = 100  # signs in a row


def region_document(result: RegionMap, title: str, *, everything: bool) -> Document:
    """What part of the points is feasible, which constraint fails where, the best point."""
    count = int(result.feasible.sum())
    points = len(result.feasible)
    facts = [
        Fact("rule", result.rule, keyed(result, "rule")),
        *(Fact(way, _extent(each)) for way, each in zip(WAYS, result.parameters, strict=False)),
        Fact("feasible", f"{count} of {points} points", {"feasible": count, "points": points}),
        _best(result),
        *_fails(result),
    ]
    view = _rows(result) if everything else _signs(result)
    return Document(title, tuple(facts), _notes(result), view)


def _extent(each: Parameter) -> str:
    first, last = column([each.values[0], each.values[-1]])
    return f"{each.header} = {first} to {last}, {len(each.values)} values"


def _best(result: RegionMap) -> Fact:
    """The point where the rule is kept by the most, as it is written in overrides."""
    words = [each.assignments[k] for each, k in zip(result.parameters, result.at(result.best), strict=True)]
    label = "best point" if result.feasible.any() else "nearest point"
    told = {"overrides": words, quantity_of(RegionMap, "function").key: float(result.function[result.best])}
    return Fact(f"{label} ({result.form})", "\n".join(words), {label.replace(" ", "_"): told})


def _fails(result: RegionMap) -> list[Fact]:
    """How often every constraint is at fault, with its sign in the map."""
    counts = Counter(name for names in result.failing for name in names)
    facts = [
        Fact(f"{sign} {name}", f"at fault at {counts[name]} points", {f"constraint_{name}": {"at_fault": counts[name]}})
        for sign, name in zip(_alphabet(result), result.names, strict=True)
    ]
    refused = int(np.count_nonzero(~result.solved))
    first = next((reason for reason in result.refused if reason), "")
    if refused:
        text = f"at {refused} points, the first: {first.splitlines()[0]}"
        facts.append(Fact(f"{NOTHING} no solution", text, {"without_solution": refused}))
    return facts


def _alphabet(result: RegionMap) -> list[str]:
    return [SIGNS[k] if k < len(SIGNS) else SEVERAL for k in range(len(result.names))]


def _notes(result: RegionMap) -> tuple[str, ...]:
    if result.feasible.any():
        return ()
    return ("warning: no point is feasible; the nearest one has the greatest function",)


def _signs(result: RegionMap) -> View | None:
    """The map: the first parameter to the right, the second upwards."""
    first, *others = result.parameters
    if len(first.values) > WIDEST:
        return None
    alphabet = dict(zip(result.names, _alphabet(result), strict=True))
    signs = [_sign(result, k, alphabet) for k in range(len(result.feasible))]
    if not others:
        return View([WAYS[0]], [["".join(signs)]])
    (second,) = others
    n = len(second.values)
    rows = range(n - 1, -1, -1)
    values = column(second.values)
    return View([WAYS[1], WAYS[0]], [[values[k] for k in rows], ["".join(signs[k::n]) for k in rows]])


def _sign(result: RegionMap, point: int, alphabet: dict[str, str]) -> str:
    if not result.solved[point]:
        return NOTHING
    if result.feasible[point]:
        return HOLDS
    names = result.failing[point]
    return alphabet[names[0]] if len(names) == 1 else SEVERAL


def _rows(result: RegionMap) -> View:
    """A row a point: parameters, verdict, function, values and margins; empty where there is no solution."""
    places = np.unravel_index(np.arange(len(result.feasible)), result.shape)
    headers, columns = [], []
    for each, indices in zip(result.parameters, places, strict=True):
        headers.append(each.header)
        columns.append([each.values[k] for k in indices])
    function = quantity_of(RegionMap, "function", form=result.form)
    numbers = [(function.header, result.function)]
    for name, unit, values, margins in zip(result.names, result.units, result.values, result.margins, strict=True):
        keys = (quantity_of(RegionMap, part, constraint=name, unit=unit) for part in ("values", "margins"))
        numbers += [(each.key, row) for each, row in zip(keys, (values, margins), strict=True)]
    told = quantities(RegionMap)
    known = [_known(row, result) for _, row in numbers]
    state = ["yes" if good else "no" for good in result.feasible]
    fails = [why or ", ".join(names) for why, names in zip(result.refused, result.failing, strict=True)]
    return View(
        [*headers, told["feasible"].key, *(header for header, _ in numbers), told["failing"].key],
        [*columns, state, *known, fails],
    )


def _known(values: Values, result: RegionMap) -> list[float | None]:
    return [float(value) if there else None for value, there in zip(values, result.solved, strict=True)]
