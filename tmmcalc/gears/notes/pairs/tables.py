"""Tables of quantities by their names: what they are, symbol, unit, value."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import isfinite

from tmmcalc.report.formula.digits import Given, significant
from tmmcalc.report.formula.symbols import canonical
from tmmcalc.report.language import tr, tr_number, tr_unit
from tmmcalc.report.manuscript import Lexicon, Table

FIGURES = 7  # digits of a value
PLACES = 4  # its decimals at most


def parameters(caption: str, names: Sequence[str], lexicon: Lexicon, key: str) -> Table:
    """The quantities of a lexicon that are there and are something; shifts that are nothing too."""
    rows = [
        (given.meaning, f"${name}$", shown_unit(given.unit), shown(given)) for name, given in something(names, lexicon)
    ]
    head = tr("Quantity"), tr("Designation"), tr("Unit"), tr("Value")
    return Table(caption, head, tuple(rows), key)


def of_wheels(
    caption: str, names: Sequence[str], lexicons: Sequence[Lexicon], wheels: Sequence[str], key: str
) -> Table:
    """The same quantities of several wheels, by names without an index."""
    rows = []
    for name in names:
        found = [lexicon.get(canonical(name)) for lexicon in lexicons]
        first = next((given for given in found if given is not None), None)
        if first is not None:
            cells = ["–" if given is None else shown(given) for given in found]
            rows.append((first.meaning, f"${name}$", shown_unit(first.unit), *cells))
    head = tr("Quantity"), tr("Designation"), tr("Unit"), *(tr("wheel {wheel}", wheel=wheel) for wheel in wheels)
    return Table(caption, head, tuple(rows), key)


def something(names: Sequence[str], lexicon: Lexicon) -> Iterator[tuple[str, Given]]:
    """Those of the names that are there and are something; shifts that are nothing too."""
    for name in names:
        given = lexicon.get(canonical(name))
        if given is not None and (given.value or name[0] == "x"):
            yield name, given


def shown(given: Given) -> str:
    """A value as it is printed in a table."""
    assert isinstance(given.value, float)
    text = significant(round(given.value, PLACES) + 0.0, FIGURES)
    return tr_number(text.replace("-", "−"))


def shown_unit(unit: str) -> str:
    """A unit as it stands in a cell."""
    return "°" if unit == "deg" else tr_unit(unit)


def decimals(value: float, places: int) -> str:
    """A number with so many decimals; a dash where there is none."""
    if not isfinite(value):
        return "–"
    return tr_number(f"{round(value, places) + 0.0:.{places}f}".replace("-", "−"))
