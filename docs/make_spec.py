"""Write the tables of keys in docs/spec.md from the models of the spec: ``make docs``.

A table stands between ``<!-- keys: PATH -->`` and ``<!-- end -->``. The path is that of a table of the spec, such as
``mechanism.grid``; several, divided by commas, share one table of rows, where a column tells whose each row is, if it
is not of all. Of a table in several forms a form is chosen by its ``kind``: ``mechanism.joints.revolute``. Keys in
brackets after the path are those that are shown, in this order: ``loads (stroke output)``.

What a key means is the description of its field, what it is by default stands there as "(default: ...)" or is the
default of the field, in the units in which specs are written. The laws of motion of cams stand between
``<!-- laws of motion -->`` and ``<!-- end -->``.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from pathlib import Path
from typing import Any, Literal, NamedTuple, get_args, get_origin

from pydantic.fields import FieldInfo
from pydantic_core import PydanticUndefined

from tmmcalc.cams.laws.catalogue import NAMES, title_of
from tmmcalc.project.root import Spec
from tmmcalc.project.words import words_of
from tmmcalc.spec.choices import Within
from tmmcalc.spec.deferred import DeferredTable
from tmmcalc.spec.dimensions import DIMENSIONS, UNITS
from tmmcalc.spec.quantities import Quantity
from tmmcalc.spec.table import Table

PAGE = Path(__file__).parent / "spec.md"
MARKED = re.compile(r"(<!-- keys: ([^\n]*) -->\n)(?:(?!<!-- keys).)*?(<!-- end -->)", re.DOTALL)
LAWS = re.compile(r"(<!-- laws of motion -->\n).*?(<!-- end -->)", re.DOTALL)
ASKED = re.compile(r"([\w.]+)(?: \(([\w ]+)\))?")
TOLD = re.compile(r",? \(default: ([^()]*(?:\([^()]*\)[^()]*)*)\)")
SHOWN = {"angle": ("deg",), "length": ("m", "mm", "um"), "pressure": ("MPa", "Pa")}  # units of defaults, largest first


class Row(NamedTuple):
    """A key of a table: as it is written, what it is by default, what it means."""

    key: str
    default: str
    meaning: str


def page(text: str) -> str:
    """Return the document with its tables made afresh."""
    laws = "".join(f'| `"{name}"` | {title_of(name)} |\n' for name in NAMES)
    text = LAWS.sub(lambda found: f"{found[1]}| `law` | |\n|---|---|\n{laws}{found[2]}", text)
    return MARKED.sub(lambda found: found[1] + _table(found[2]) + found[3], text)


def shown(text: str) -> set[tuple[str, str]]:
    """Return the keys, with their meanings, that the document asks for."""
    asked = [_rows(*each.groups("")) for found in MARKED.finditer(text) for each in ASKED.finditer(found[2])]
    return {(row.key, row.meaning) for rows in asked for row in rows}


def known() -> set[tuple[str, str]]:
    """Return the keys, with their meanings, of all tables of the models."""
    found, todo = set(), [(name, table) for name, field in Spec.model_fields.items() for table in _tables(field)]
    while todo:
        path, model = todo.pop()
        for key, field in _fields(model).items():
            row = _row(f"{path}.{key}", field)
            found.add((row.key, row.meaning))
            todo += [(f"{path}.{key}", table) for table in _tables(field)]
    return found


def _table(asked: str) -> str:
    """The table of keys of one or several tables of the spec; rows of the same key stand one after the other."""
    forms = {path.rpartition(".")[2]: _rows(path, keys) for path, keys in ASKED.findall(asked)}
    every = list(dict.fromkeys(row for rows in forms.values() for row in rows))
    keys = list(dict.fromkeys(row.key for row in every))
    rows = sorted(every, key=lambda row: keys.index(row.key))
    whose = [[form for form, rows_of in forms.items() if row in rows_of] for row in rows]
    columns = {
        "key": [f"`{row.key}`" for row in rows],
        "of": ["" if len(each) == len(forms) else ", ".join(each) for each in whose],
        "default": [row.default for row in rows],
        "meaning": [row.meaning for row in rows],
    }
    kept = {head: cells for head, cells in columns.items() if any(cells)}
    lines = [_line(kept), f"|{'---|' * len(kept)}\n", *(_line(cells) for cells in zip(*kept.values(), strict=True))]
    return "".join(lines)


def _line(cells: Iterable[str]) -> str:
    return f"|{'|'.join(f' {cell} ' if cell else ' ' for cell in cells)}|\n"


def _rows(path: str, keys: str = "") -> list[Row]:
    """The rows of one table of the spec: of all its keys, or of those that are named."""
    place, model = _found(path)
    fields = _fields(model)
    return [_row(f"{place}.{key}", fields[key]) for key in keys.split() or fields]


def _found(path: str) -> tuple[str, type[Table]]:
    """Where a spec has the table of a path, and its model; forms of a table are told apart by their kind."""
    place: list[str] = []
    models: list[type[Table]] = [Spec]
    for part in path.split("."):
        forms = [model for model in models if part in _kinds(model)]
        if not forms:
            place.append(part)
            fields = [_fields(model)[part] for model in models if part in _fields(model)]
            forms = [table for field in fields for table in _tables(field)]
        if not forms:
            raise LookupError(f"<!-- keys: {path} --> asks for a table that the spec does not have")
        models = forms
    return ".".join(place), models[0]


def _fields(model: type[Table]) -> dict[str, FieldInfo]:
    """Fields by their keys: from is a word of Python, so its field has another name."""
    return {field.alias or name: field for name, field in model.model_fields.items()}


def _kinds(model: type[Table]) -> tuple[Any, ...]:
    return get_args(model.model_fields["kind"].annotation) if "kind" in model.model_fields else ()


def _tables(field: FieldInfo) -> Iterator[type[Table]]:
    """Tables that a field holds, alone, in a list, or as one of several forms."""
    for leaf in _leaves(field.annotation, *field.metadata):
        if isinstance(leaf, DeferredTable):
            yield leaf.table
        elif isinstance(leaf, type) and issubclass(leaf, Table):
            yield leaf


def _leaves(*annotations: Any) -> Iterator[Any]:
    """The types, and what tells of them, that an annotation is made of."""
    for each in annotations:
        parts = (*get_args(each), *getattr(each, "__metadata__", ()))
        if parts and get_origin(each) is not Literal:
            yield from _leaves(*parts)
        else:
            yield each


def _row(place: str, field: FieldInfo) -> Row:
    words = field.description or ""
    told = TOLD.search(words)
    default = told[1] if told else _default(field)
    return Row(_key(place, field), _escaped(default), _escaped(TOLD.sub("", words)))


def _key(place: str, field: FieldInfo) -> str:
    """A key, or the header of a table that has lines of its own."""
    plain = any(leaf in (str, int, float) for leaf in _leaves(field.annotation))
    table, _, within = place.partition(".")
    if plain or within in words_of(table).inline or not list(_tables(field)):
        return place.rpartition(".")[2]
    return f"[[{place}]]" if get_origin(field.annotation) is list else f"[{place}]"


def _default(field: FieldInfo) -> str:
    if field.is_required():
        return "required"
    value = None if field.default is PydanticUndefined else field.default
    if value is None or value in ("", [], {}):
        return ""
    written = _value(value, _dimensions(field))
    return written if isinstance(value, int | float | Fraction) and not isinstance(value, bool) else f"`{written}`"


def _dimensions(field: FieldInfo) -> tuple[str, ...]:
    """Dimensions of the quantities that a field holds."""
    for reader in _leaves(field.annotation, *field.metadata):
        while hasattr(reader, "item"):
            reader = reader.item
        quantity = reader.quantity if isinstance(reader, Within) else reader
        if isinstance(quantity, Quantity):
            return quantity.dimensions
    return ()


def _value(value: Any, dimensions: Sequence[str]) -> str:
    """A value as TOML has it, a quantity with its unit."""
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, str):
        return f'"{value}"'
    if isinstance(value, list):
        return f"[{', '.join(_quoted(_value(each, dimensions)) for each in value)}]"
    if not dimensions or (value == 0 and "angle" not in dimensions):
        return f"{float(value):.12g}" if isinstance(value, float) else str(value)
    return " or ".join(_quantity(value, dimension) for dimension in dimensions)


def _quoted(text: str) -> str:
    return f'"{text}"' if " " in text and not text.startswith('"') else text


def _quantity(value: float, dimension: str) -> str:
    units = SHOWN.get(dimension, (DIMENSIONS[dimension].si,))
    sizes = {unit: value / _scale(dimension, unit) for unit in units}
    unit = next((unit for unit, size in sizes.items() if abs(size) >= 1), units[-1])
    return f"{sizes[unit]:.10g} {unit}"


def _scale(dimension: str, unit: str) -> float:
    factor = UNITS[dimension][unit]
    return factor.num / factor.den * (math.pi if factor.pi else 1)


def _escaped(text: str) -> str:
    """A text in a cell: outside of code asterisks and what looks like a tag stand for themselves."""
    parts = re.split(r"(`[^`]*`)", text.replace("|", r"\|"))
    return "".join(part if part.startswith("`") else re.sub(r"(\*|<(?=\w))", r"\\\1", part) for part in parts)


if __name__ == "__main__":
    PAGE.write_text(page(PAGE.read_text(encoding="utf-8")), encoding="utf-8")
