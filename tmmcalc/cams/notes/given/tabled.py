"""Data of the task from lexicons of formulas."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from math import degrees

from tmmcalc.report.formula.symbols import canonical
from tmmcalc.report.manuscript import Datum, Lexicon


def data(known: Lexicon, names: Iterable[str]) -> Iterator[Datum]:
    """Those of the names that have a value, angles in degrees."""
    for name in names:
        given = known.get(name) or known.get(canonical(name))
        if given is None or not given.value:
            continue
        assert isinstance(given.value, float)
        turned = given.unit == "rad"
        value, unit = (degrees(given.value), "deg") if turned else (given.value, given.unit)
        yield Datum(given.meaning, (name,), (value,), unit)


def written(table: object, names: Mapping[str, str]) -> list[str]:
    """The names of the keys that the spec has written into a table."""
    said = getattr(table, "model_fields_set", ())
    return [name for key, name in names.items() if key in said]
