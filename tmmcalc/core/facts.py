"""What stages tell of their results by name: the numbers of their summaries."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any, NamedTuple

from tmmcalc.core.stage import STAGES

SEPARATORS = frozenset(".@[]()*?,;")  # a part with one of these in its name goes by its number
Quantity = tuple[float, str]  # value and unit


def facts(stage: str, result: Any) -> Iterator[tuple[str, Quantity]]:
    """All numbers of a stage's summary by name, without their unit."""
    for each in labelled(stage, result):
        if not isinstance(each.value, str):
            yield each.name, (float(each.value), each.unit)


class Labelled(NamedTuple):
    """One value of a summary."""

    name: str  # without its unit
    value: float | str  # a truth value is one; a word where the summary tells one
    unit: str
    label: str  # under which the summary tells it
    within: str = ""  # of a value among several in one place the name of that place: ``weights`` of ``weights.mass``
    apart: bool = False  # whether its label has several such places
    part: str = ""  # title of its part, where names begin with it

    @property
    def own(self) -> str:
        """Its name without that of its part and of its place."""
        return self.name.rpartition(".")[2]


def labelled(stage: str, result: Any) -> Iterator[Labelled]:
    """All values of a stage's summary.

    Where parts of a summary tell the same, as several motions do, a name begins with that of its part:
    ``start-up.end_time``.
    """
    document = STAGES[stage].summary(result, stage)
    for name, part in (("", document), *zip(beginnings(document.parts), document.parts, strict=True)):
        for fact in part.facts:
            label, apart = fact.meaning or fact.label, _apart(fact.values)
            for told, value, unit, within in _leaves(fact.values, name):
                yield Labelled(told, value, unit, label, within, apart, part.title if name else "")


def beginnings(parts: Sequence[Any]) -> list[str]:
    """What names of the facts of every part begin with: nothing, where no two parts tell the same."""
    keys = [key for part in parts for key in {key for fact in part.facts for key in fact.values}]
    if len(set(keys)) == len(keys):
        return [""] * len(parts)
    names = [part.name or part.title for part in parts]
    alike = {name for name in names if names.count(name) > 1}
    unfit = (name in alike or not SEPARATORS.isdisjoint(name) for name in names)
    return [f"{number if no else name}." for number, (name, no) in enumerate(zip(names, unfit, strict=True), 1)]


def _leaves(values: Mapping[str, Any], path: str, within: str = "") -> Iterator[tuple[str, float | str, str, str]]:
    for key, value in values.items():
        name, unit = named(key)
        if isinstance(value, Mapping):
            yield from _leaves(value, f"{path}{key}.", f"{within}{'.' if within else ''}{name}")
        elif isinstance(value, int | float | str):
            yield f"{path}{name}", value, unit, within


def _apart(values: Mapping[str, Any]) -> bool:
    """Whether a fact has several places with values."""
    inner = [value for value in values.values() if isinstance(value, Mapping)]
    return len(inner) > 1 or any(isinstance(each, Mapping) for value in inner for each in value.values())


def named(header: str) -> tuple[str, str]:
    """Name and unit of a header.

    >>> named("vS_D[m/s]"), named("efficiency")
    (('vS_D', 'm/s'), ('efficiency', ''))
    """
    name, _, unit = header.partition("[")
    return name, unit.removesuffix("]")
