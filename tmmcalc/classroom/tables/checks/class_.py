"""Checks of ``[class]``: what is drawn are numbers of the spec, each once; what is asked has names of its own."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence

from tmmcalc.classroom.tables.class_ import followed
from tmmcalc.core.errors import UsageError
from tmmcalc.design.tables.checks.ranges import RANGE, check_keys, check_values, listed, numbers_in, place_of
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline, Raw, tables
from tmmcalc.spec.phrases import Path, did_you_mean, listing, show
from tmmcalc.spec.units import dimension_of
from tmmcalc.spec.variants import given


def check_drawn(outline: Outline) -> Iterator[Finding]:
    """Each key is a number that is drawn once; values are round; a relation is to a number that there is before."""
    own = outline.document.get("class", {})
    every = tables(own, "drawn") if isinstance(own, dict) else []
    later = {place: index for index, table in every for place in _places(table, outline.document)}
    seen: dict[Path, str] = {}
    for index, table in every:
        path: Path = ("class", "drawn", index)
        units = yield from check_keys(path, table, outline.document, seen, "drawn", "the tables")
        if len({*units}) > 1:
            rule = f"{' and '.join(map(show, dict.fromkeys(units)))}: keys with one value are written in one unit"
            yield Finding((*path, "of"), rule, "write the spec in one unit, or two [[class.drawn]]")
        elif "times" in table:
            yield from _check_relation(path, table, units, outline.document, later)
        else:
            yield from check_values(path, table, units, "drawn", "the table")
        if "among" not in table and "step" not in table:
            rule = "missing key: step, of which values are multiples: students get round numbers"
            yield Finding(path, rule, 'add step = "5 mm", or among = [...]')


def _check_relation(
    path: Path, table: Raw, units: list[str], document: Raw, drawn: Mapping[Path, int]
) -> Iterator[Finding]:
    """Factors without units, a step, and one number that is given or drawn before."""
    if "among" in table:
        rule = "among together with times, which at_least and at_most multiply"
        yield Finding((*path, "among"), rule, "remove one of them")
        return
    keys = listed(table["times"])
    if len(keys) != 1 or any(wild in keys[0] for wild in "*?"):
        yield Finding((*path, "times"), f"{show(table['times'])}: one key is multiplied", "write one key")
    else:
        yield from _check_base((*path, "times"), keys[0], document, drawn)
    factors = [table[key] for key in RANGE if key in table]
    for key in RANGE:
        value = table.get(key)
        if dimension_of(value) is not None:
            rule = f"{key} = {show(value)} beside times is a factor, which has no unit"
            yield Finding((*path, key), rule, f"write {key} = 3")
            return
        if isinstance(value, int | float) and not isinstance(value, bool) and value <= 0:
            yield Finding((*path, key), f"a factor of {show(value)}", "write one above 0")
            return
    step = yield from numbers_in((*path, "step"), [table["step"]] if "step" in table else [], units)
    if step and step[0] <= 0:
        yield Finding((*path, "step"), f"a step of {show(table['step'])} goes nowhere", "write one above 0")
    if len(factors) == len(RANGE):
        yield from check_values(path, {key: table[key] for key in RANGE}, [""], "drawn", "the table")
    else:
        missing = " and ".join(key for key in RANGE if key not in table)
        yield Finding(path, f"missing key: {missing}, the factor of times", "add at_least = 3 and at_most = 4")


def _check_base(path: Path, key: str, document: Raw, drawn: Mapping[Path, int]) -> Iterator[Finding]:
    try:
        given(key, document)
    except UsageError as error:
        yield Finding(path, error.message, error.remedy)
        return
    index = path[2]
    at = drawn.get(place_of(key, document), -1)
    if at == index:
        yield Finding(path, f"{key} is multiplied to give itself", "name another key")
    elif isinstance(index, int) and at > index:
        yield Finding(path, f"{key} is drawn after what it multiplies to", "move its table before this one")


def _places(table: Raw, document: Raw) -> Iterator[Path]:
    for key in filter(None, listed(table.get("of"))):
        try:
            given(key, document)
        except UsageError:
            continue
        yield place_of(key, document)


def check_asked(outline: Outline) -> Iterator[Finding]:
    """No two results that are asked share a name; what one is computed from is asked too, and not from it."""
    own = outline.document.get("class", {})
    every = tables(own, "asked") if isinstance(own, dict) else []
    names = _names(every)
    known: dict[str, int] = {}
    for index, own_names in names.items():
        for key, name in own_names:
            at = known.setdefault(name.casefold(), index)
            if at != index:
                rule = f"{show(name)} is the name of two asked results: an answer could be to either"
                yield Finding(("class", "asked", index, key), rule, "give one of them another name")
    before: dict[int, list[int]] = {}
    for index, table in every:
        for name in listed(table.get("after")):
            at = known.get(followed(name)[0].casefold(), -1)
            if at < 0:
                own_name = [each[0][1] for each in names.values() if each]
                guess = f"{did_you_mean(name, own_name)} asked are: {listing(own_name)}".strip()
                yield Finding(("class", "asked", index, "after"), f"no asked result is called {show(name)}", guess)
            else:
                before.setdefault(index, []).append(at)
            own, power = followed(name)
            if own != name and not power:
                rule = f"{show(name)}: with the power 0 it does not follow it"
                yield Finding(("class", "asked", index, "after"), rule, f'write "{own}", or another power')
    for index in _in_circles(before):
        rule = "it is computed from itself, by what after says"
        yield Finding(("class", "asked", index, "after"), rule, "name only what comes before it")


def check_plans(outline: Outline) -> Iterator[Finding]:
    """Plans of which an accuracy is given are less accurate than right answers: else no answer is within them alone."""
    own = outline.document.get("class", {})
    if not isinstance(own, dict):
        return
    for path, table in (((), own), *((("asked", index), table) for index, table in tables(own, "asked"))):
        given = {key: table.get(key, own.get(key)) for key in ("tolerance", "plans")}
        if given["plans"] is None or not table.keys() & given.keys():
            continue
        tolerance, plans = 0.01 if given["tolerance"] is None else _part(given["tolerance"]), _part(given["plans"])
        if tolerance is not None and plans is not None and plans < tolerance:
            key = "plans" if "plans" in table else "tolerance"
            rule = f"plans within {100 * plans:g} % are more accurate than right answers, within {100 * tolerance:g} %"
            yield Finding(("class", *path, key), rule, "make plans larger, or tolerance smaller")


def _part(value: object) -> float | None:
    """A part as it is written, 0.01 or "1 %"; None of what is none, whose own fault is told."""
    text = str(value).strip()
    try:
        return float(text.removesuffix("%")) / (100 if text.endswith("%") else 1)
    except ValueError:
        return None


def _names(every: Sequence[tuple[int, Raw]]) -> dict[int, list[tuple[str, str]]]:
    """The names of each asked result with their keys, the first of which is its own."""
    found = {}
    for index, table in every:
        named = "name" if isinstance(table.get("name"), str) else "result"
        own = [(named, table[named].strip())] if isinstance(table.get(named), str) else []
        found[index] = own + [("also", each) for each in listed(table.get("also")) if each]
    return found


def _in_circles(before: Mapping[int, Sequence[int]]) -> Iterator[int]:
    """Those from which a way leads back to them."""
    for start in before:
        todo, met = [*before[start]], {*before[start]}
        while todo:
            fresh = {*before.get(todo.pop(), ())} - met
            met |= fresh
            todo += fresh
        if start in met:
            yield start


CHECKS: tuple[Callable[[Outline], Iterator[Finding]], ...] = (check_drawn, check_asked, check_plans)
