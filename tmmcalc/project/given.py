"""What a spec gives, key by key: the value in SI with its unit, as it is written, and what the key means."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, NamedTuple, get_args

from pydantic import BaseModel
from pydantic.fields import FieldInfo

from tmmcalc.project.root import Spec
from tmmcalc.spec.dimensions import DIMENSIONS
from tmmcalc.spec.phrases import Path, show_path
from tmmcalc.spec.quantities import Quantity
from tmmcalc.spec.units import dimension_of, parse


class Given(NamedTuple):
    """One value of a spec."""

    key: str  # as ``--set`` names it
    value: float | str | bool  # numbers in SI
    unit: str
    written: str  # of a quantity with a unit: as it stands in the file
    meaning: str


def given(spec: Spec) -> Iterator[Given]:
    """Every value that stands in the file of a spec, in its order; none of a spec that was not read from a text.

    Values that ``--set`` has put there, and those of CSV files that it names, are among them.
    """
    if spec._written is not None:
        yield from _given(spec._written.document, (), spec, None)


def _given(value: Any, path: Path, model: Any, field: FieldInfo | None) -> Iterator[Given]:
    """The values within one, which ``model`` holds; ``field`` is the last one on the way that is declared."""
    if isinstance(value, dict):
        for key, inner in value.items():
            own = type(model).model_fields.get(key) if isinstance(model, BaseModel) else None
            yield from _given(inner, (*path, key), _inner(model, key), own or field)
    elif isinstance(value, list):
        for k, inner in enumerate(value):
            yield from _given(inner, (*path, k), _inner(model, k), field)
    else:
        yield _one(value, path, field)


def _inner(model: Any, key: Any) -> Any:
    if isinstance(model, BaseModel):
        return getattr(model, str(key), None)
    try:
        return model[key]
    except (TypeError, LookupError):
        return None


def _one(value: Any, path: Path, field: FieldInfo | None) -> Given:
    meaning = (field.description or "").replace("`", "") if field is not None else ""
    dimension = dimension_of(value)
    if dimension is not None:
        return Given(show_path(path), parse(value, dimension), DIMENSIONS[dimension].si, value, meaning)
    known = {*_dimensions(field)} if field is not None and isinstance(value, float | int) else set()
    unit = DIMENSIONS[known.pop()].si if len(known) == 1 and not isinstance(value, bool) else ""
    return Given(show_path(path), value if isinstance(value, bool | int | float) else str(value), unit, "", meaning)


def _dimensions(declared: Any) -> Iterator[str]:
    """The dimensions of the quantities in an annotation, or in that of a field."""
    if isinstance(declared, Quantity):
        yield from declared.dimensions
    elif isinstance(declared, FieldInfo):
        for each in (declared.annotation, *declared.metadata):
            yield from _dimensions(each)
    else:
        for each in get_args(declared):
            yield from _dimensions(each)
