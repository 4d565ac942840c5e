"""The document of an optimum: what is sought and found, its variables, what binds it, how it was confirmed."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from tmmcalc.core.headers import key_and_unit
from tmmcalc.design.optimize.optimum import Binding
from tmmcalc.design.optimize.problem import Objective
from tmmcalc.design.optimize.scene import Optimum
from tmmcalc.design.sensitivity_document import per
from tmmcalc.report.document import Document, Fact, View
from tmmcalc.report.numbers import number

VARIABLES = ("variable", "value", "at least", "at most", "as good from", "as good to", "limit costs")
LIMITS = ("constraint", "value", "at least", "at most", "limit costs")
WORSE = 10.0  # of the objective: what is told as a part of it
BALANCED = 1e-6  # of the objective: what slopes may leave over
REPEATED = 1e-9  # of the objective: what the stages may differ by when the design is solved by itself


def optimum_document(result: Optimum, title: str, people: bool = True) -> Document:
    """Of one objective the best design, its variables and limits; of several a row a design of the front.

    ``people``: values have their units beside them; else units have a column.
    """
    if len(result.objectives) > 1:
        return _front(result, title)
    facts = (*_best(result), *_search(result))
    return Document(title, facts, (*_notes(result),), _variables(result, people), parts=tuple(_limits(result, people)))


def _best(result: Optimum) -> Iterator[Fact]:
    objective, best = result.objectives[0], result.designs[0].objectives[0]
    unit = objective.unit
    text = f"{number(best)} {unit}".rstrip()
    yield Fact(_sense(objective), text, {"objective": objective.name, "best": best, "unit": unit})
    was = result.nominal[0]
    if np.isfinite(was):
        change = (
            f", {abs(best / was - 1):.1%} {'less' if best < was else 'more'} than now" if was and best != was else ""
        )
        broken = f", which breaks {', '.join(result.broken)}" if result.broken else ""
        told = f"{number(was)} {unit}".rstrip() + change + broken
        yield Fact("of the spec as it is", told, {"now": was, "breaks": list(result.broken)})


def _search(result: Optimum) -> Iterator[Fact]:
    lost = f", {result.failed} of them without a solution" if result.failed else ""
    if result.resumed:
        lost += f", {result.resumed} of them by an earlier run"
    values = {"solved": result.solved, "without_solution": result.failed, "method": result.method}
    yield Fact("designs", f"{result.solved} solved{lost}", values)
    yield Fact("method", f"complete: {result.method} were solved" if result.complete else result.method)
    second = result.second
    if second is not None:
        signs = [each.sign for each in result.objectives]
        found = [sign * best if np.isfinite(best) else None for sign, best in zip(signs, second.best, strict=True)]
        told = {"method": second.method, "best": found, "starts": second.starts, "hits": second.hits}
        yield Fact("second method", _confirmed(result), {f"second_{key}": value for key, value in told.items()})
    balance = result.stationarity
    if balance is not None and np.isfinite(balance.gain) and not all(each.among for each in result.variables):
        left = "balance" if balance.gain < REPEATED else f"leave over what wins {balance.gain:.0e} of it"
        text = f"the {'exact ' * result.exact}slopes of objective and limits {left}"
        yield Fact("optimality", text, {"gain": balance.gain, "exact": result.exact})
    again = max(each.again for each in result.designs)
    yield Fact("solved again", f"by the ordinary stages, the same to {again:.0e}", {"apart": again})


def _confirmed(result: Optimum) -> str:
    """What the second method says."""
    second = result.second
    assert second is not None
    of_starts = f" from the best {second.starts} of {second.drawn} random designs" if second.starts else ""
    told = []
    for at, (objective, best) in enumerate(zip(result.objectives, second.best, strict=True)):
        own = min(objective.sign * each.objectives[at] for each in result.designs)
        if not np.isfinite(best):
            told.append("found nothing that keeps the constraints")
        elif second.worse[at]:
            worse = f", {(best - own) / abs(own):.1%} worse" if best - own < WORSE * abs(own) else ""
            told.append(f"found {number(objective.sign * best)} {objective.unit}".rstrip() + worse)
        else:
            first = "it is what is told here: the first found less good" if second.better[at] else "the same"
            told.append(f"{first}{f' in {second.hits[at]}' if second.starts else ''}")
    return f"{second.method}{of_starts}: {'; '.join(told)}"


def _notes(result: Optimum) -> Iterator[str]:
    balance = result.stationarity
    if balance is not None and balance.kinks:
        costs = ": what limits cost is found by seeking again with looser ones" if result.binding else ""
        yield f"note: the objective has a kink at the optimum in {balance.kinks} of its variables{costs}"
    elif balance is not None and balance.gain > BALANCED and not all(each.among for each in result.variables):
        yield f"warning: going on along the slopes wins {balance.gain:.1e} of it: the best is not reached"
    if result.ends:
        yield f"note: a small step from the optimum has no solution any more, along {', '.join(result.ends)}"
    if balance is not None and not np.isfinite(balance.gain) and not _agreed(result):
        yield "warning: not confirmed: slopes do not tell that it is the best, and the second method found another"
    if result.designs and max(each.again for each in result.designs) > REPEATED:
        yield "warning: solved by itself a design differs from what the search saw"


def _agreed(result: Optimum) -> bool:
    """Whether all designs were solved, or the second method found the same as the first."""
    second = result.second
    if second is None:
        return True
    return not any(second.better) and not any(second.worse)


def _variables(result: Optimum, people: bool) -> View:
    """A row a variable: its value, its limits, how far it can go at one per cent of the objective."""
    bound = {(each.name, each.side): each for each in result.binding if each.variable}
    rows = []
    for variable, flat in zip(result.variables, result.flat, strict=True):
        binds = bound.get((variable.name, "at least")) or bound.get((variable.name, "at most"))
        values = (flat.value, variable.low, variable.high, flat.low, flat.high)
        rows.append(_row(result, variable.name, variable.unit, values, binds, people))
    return _view(VARIABLES, rows, people)


def _limits(result: Optimum, people: bool) -> Iterator[Document]:
    """A row a constraint, if there are any."""
    if not result.limits:
        return
    bound = {(each.name, each.side): each for each in result.binding if not each.variable}
    rows = []
    for limit, value in zip(result.limits, result.designs[0].limits, strict=True):
        binds = bound.get((limit.name, "at least")) or bound.get((limit.name, "at most"))
        rows.append(_row(result, limit.name, limit.unit, (value, limit.at_least, limit.at_most), binds, people))
    names = [each.name for each in result.binding]
    fact = Fact("bind", ", ".join(names) or "none", {"binding": names})
    yield Document("constraints", (fact,), (), _view(LIMITS, rows, people))


def _row(
    result: Optimum,
    name: str,
    unit: str,
    values: Sequence[float | None],
    binding: Binding | None,
    people: bool,
) -> tuple[Any, ...]:
    """Name, values, what a unit of the limit costs that binds: with their units for people."""
    if not people:
        cost = binding.cost if binding is not None and np.isfinite(binding.cost) else None
        return name, unit, *values, cost
    told = ["" if each is None else f"{number(each)} {unit}".rstrip() for each in values]
    return name, *told, _cost(result, binding)


def _view(headers: tuple[str, ...], rows: Sequence[tuple[Any, ...]], people: bool) -> View:
    first, *rest = headers
    return View(headers if people else (first, "unit", *rest), [*map(list, zip(*rows, strict=True))])


def _cost(result: Optimum, binding: Binding | None) -> str:
    """What a unit of a limit that binds changes of the objective."""
    if binding is None:
        return ""
    if not np.isfinite(binding.cost):
        return "binds"
    text = f"{binding.cost:+.4g} {per(result.objectives[0].unit, binding.unit)}".rstrip()
    return f"about {text}" if binding.again else text


def _front(result: Optimum, title: str) -> Document:
    best = _ends(result)
    ends = [
        Fact(_sense(each), f"{number(own)} {each.unit}".rstrip(), {})
        for each, own in zip(result.objectives, best, strict=True)
    ]
    values = {"designs": len(result.designs), "objectives": [each.name for each in result.objectives], "best": best}
    facts = (Fact("front", f"{len(result.designs)} designs of which none is better in all", values), *ends)
    headers = ["i", *(header(each.name, each.unit) for each in result.objectives)]
    headers += [header(each.name, each.unit) for each in result.variables]
    rows = [(at, *each.objectives, *each.values) for at, each in enumerate(result.designs, 1)]
    table = View(headers, [*map(list, zip(*rows, strict=True))])
    return Document(title, (*facts, *_search(result)), (*_notes(result),), table)


def _ends(result: Optimum) -> list[float]:
    """The best of each objective by itself."""
    return [
        each.sign * min(each.sign * design.objectives[at] for design in result.designs)
        for at, each in enumerate(result.objectives)
    ]


def header(name: str, unit: str) -> str:
    """The header of a column of a result or a variable."""
    bare, own = key_and_unit(name)
    return f"{bare}[{unit or own}]" if unit or own else bare


def _sense(objective: Objective) -> str:
    return f"{'least' if objective.sign > 0 else 'greatest'} {objective.name}"
