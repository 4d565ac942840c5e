"""Sizes that were measured, from a CSV file: a column under a header ``name[unit]``, as tables of inspection have."""

from __future__ import annotations

from pathlib import Path

from tmmcalc.core.errors import UsageError
from tmmcalc.core.files import read_file
from tmmcalc.core.headers import key_and_unit
from tmmcalc.spec.csvtables import Column, cells
from tmmcalc.spec.phrases import listing, show
from tmmcalc.spec.units import UnitError, dimension_of

FEWEST = 2  # values that are a distribution


def column_of(file: Path, name: str, where: str) -> tuple[str, list[float]]:
    """Unit of a column (empty: plain numbers) and its values in SI, by its ``name``; without one the only column.

    Lines that are blank or begin with ``#``, and cells without a value, are passed over. Raises UsageError for a file
    that cannot be read, for a column that there is not, and for a cell that is no number, with its line.
    """
    try:
        text = read_file(file).decode("utf-8-sig")
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or "it is no text in UTF-8"
        raise UsageError(f"{file} cannot be read: {reason}", where=where, remedy="name a CSV file in UTF-8") from None
    lines = [(n, line) for n, line in enumerate(text.splitlines(), 1) if line.strip() and line.lstrip()[0] != "#"]
    if not lines:
        raise UsageError(f"{file} is empty", where=where, remedy="write a header such as A[mm], and a value a line")
    separator = next((sign for sign in ";\t" if sign in lines[0][1]), ",")
    header = cells(lines[0][1], separator)
    named = [key_and_unit(each) for each in header]
    found = [at for at, (bare, _) in enumerate(named) if not name or name in (bare, header[at])]
    if len(found) != 1:
        rule = f"{file} has no column {show(name)}" if name else f"{file} has {len(found)} columns"
        remedy = f"name one by column = ...: {listing([bare for bare, _ in named])}"
        raise UsageError(rule, where=where, remedy=remedy)
    at, unit = found[0], named[found[0]][1]
    kind = dimension_of(f"1 {unit}") if unit else ""
    if kind is None:
        raise UsageError(f"{file}: {show(unit)} is no unit", where=where, remedy="write a header such as A[mm]")
    values = []
    for number, line in lines[1:]:
        row = cells(line, separator)
        try:
            values += [Column(unit, kind).read(row[at])] if at < len(row) and row[at] else []
        except UnitError as error:
            raise UsageError(f"{file}, line {number}: {error.message}", where=where, remedy=error.remedy) from None
    if len(values) < FEWEST:
        rule = f"{file} has {len(values)} values of {show(named[at][0])}: they are no distribution"
        raise UsageError(rule, where=where, remedy="measure more pieces, or write a tolerance")
    return unit, values
