"""Frozen records as plain values for TOML and arrays for npz, and back, by their type hints."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import fields, is_dataclass
from fractions import Fraction
from functools import cache
from types import UnionType
from typing import Any, Union, get_args, get_origin, get_type_hints

import numpy as np

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.stored import Record

LABELS = "labels"  # a field of this name is as long as the table: it goes to the arrays


def to_record(result: Any, error: Mapping[str, Any] | None = None) -> Record:
    """The stored form of a result record: arrays by their dotted path, everything else as nested plain values.

    Raises `NoSolutionError` if a number of it is not finite.
    """
    arrays: dict[str, np.ndarray] = {}
    scalars = plain(result, arrays)
    _check_finite(type(result).__name__.lower(), scalars, arrays)
    counters = scalars.pop("counters", {})
    return Record(scalars, arrays, error or {}, counters)


def largest(errors: Sequence[Any]) -> dict[str, float]:
    """The largest of each estimate of several records of one kind; None are records without any."""
    told: dict[str, float] = {}
    for name, size in (pair for each in errors if each is not None for pair in plain(each).items()):
        told[name] = max(told.get(name, 0.0), size)
    return told


def _check_finite(what: str, scalars: Any, arrays: Mapping[str, np.ndarray]) -> None:
    """Refuse NaN and inf, which would spread through every later stage without a word."""
    bad = next((f"{path} is {value:g}" for path, value in _numbers(scalars) if not math.isfinite(value)), None)
    if bad is None:
        bad = next((_first_bad(path, array, arrays) for path, array in arrays.items() if not _sound(array)), None)
    if bad is not None:
        raise NoSolutionError(
            f"{bad}: the numbers of this task go beyond what can be computed",
            where=what,
            remedy="look for a quantity far from the sizes of a machine, such as a wrong unit or exponent",
        )


def _numbers(value: Any, path: str = "") -> Iterator[tuple[str, float]]:
    """All floats in nested plain values with their paths."""
    if isinstance(value, float):
        yield path, value
    elif isinstance(value, dict | list):
        for key, part in value.items() if isinstance(value, dict) else enumerate(value):
            yield from _numbers(part, f"{path}.{key}" if path else str(key))


def _sound(array: np.ndarray) -> bool:
    return array.dtype.kind not in "fc" or bool(np.isfinite(array).all())


def _first_bad(path: str, array: np.ndarray, arrays: Mapping[str, np.ndarray]) -> str:
    """The first number of an array that is not finite, with the label of its position where it has one."""
    at = np.argwhere(~np.isfinite(array))[0]
    labels = arrays.get(LABELS, ())
    named = array.ndim and array.shape[-1] == len(labels)
    place = f"at position {labels[at[-1]]}" if named else f"at {at.tolist()}"
    return f"{path} is {array[tuple(at)]:g} {place}"


def from_record(kind: Any, record: Record) -> Any:
    """The result record of type ``kind`` that `to_record` stored."""
    return restore(kind, {**record.scalars, "counters": record.counters}, record.arrays)


def plain(value: Any, arrays: dict[str, np.ndarray] | None = None, path: str = "") -> Any:
    """The value as nested dicts and lists, arrays taken out under their path.

    Fields that are None are left out, as TOML has no null; in a list an empty table stands for it.
    """
    if is_dataclass(value) and not isinstance(value, type):
        pairs = ((f.name, getattr(value, f.name)) for f in fields(value))
        found = ((name, _part(name, v, arrays, f"{path}.{name}" if path else name)) for name, v in pairs)
        return {name: v for name, v in found if v is not None}
    if isinstance(value, dict):
        return {str(k): plain(v, arrays, f"{path}.{k}") for k, v in value.items() if v is not None}
    if isinstance(value, tuple | list):
        return [{} if v is None else plain(v, arrays, f"{path}.{k}") for k, v in enumerate(value)]
    if isinstance(value, Fraction):
        return str(value)
    return [value.real, value.imag] if isinstance(value, complex) else value


def _part(name: str, value: Any, arrays: dict[str, np.ndarray] | None, path: str) -> Any:
    """A field of a record; None if it went to the arrays."""
    if arrays is not None and isinstance(value, np.ndarray):
        arrays[path] = value
        return None
    if arrays is not None and name == LABELS:
        arrays[path] = np.array(value)
        return None
    return plain(value, arrays, path)


def restore(kind: Any, data: Any, arrays: Mapping[str, np.ndarray] | None = None, path: str = "") -> Any:
    """The record of type ``kind`` that ``plain`` turned into ``data`` and ``arrays``."""
    if arrays and path in arrays:
        return tuple(arrays[path].tolist()) if path.rpartition(".")[2] == LABELS else arrays[path]
    origin, args = get_origin(kind), get_args(kind)
    if is_dataclass(kind) and isinstance(kind, type):
        hints, start = _hints(kind), f"{path}." if path else ""
        return kind(**{name: restore(hint, data.get(name), arrays, f"{start}{name}") for name, hint in hints.items()})
    if origin in (Union, UnionType):
        inner = next(a for a in args if a is not type(None))
        return None if data is None or data == {} else restore(inner, data, arrays, path)
    if origin is tuple:
        kinds = [args[0]] * len(data) if args[-1] is Ellipsis else args
        return tuple(restore(a, v, arrays, f"{path}.{k}") for k, (a, v) in enumerate(zip(kinds, data, strict=True)))
    if origin is dict:
        return {k: restore(args[1], v, arrays, f"{path}.{k}") for k, v in data.items()}
    if kind is Fraction:
        return Fraction(data)
    return complex(*data) if kind is complex else data


@cache
def _hints(kind: type) -> dict[str, Any]:
    """Type hints of a record class; resolving them takes a millisecond, and a result holds many of one class."""
    return get_type_hints(kind)
