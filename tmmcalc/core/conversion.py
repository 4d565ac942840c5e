"""Frozen records as plain values for TOML and arrays for npz, and back, by their type hints."""

from __future__ import annotations

import math
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import cache, partial
from inspect import get_annotations
from types import UnionType
from typing import Any, Union, get_args, get_origin

import numpy as np

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.notes import Note, Phrase, restored
from tmmcalc.core.plain import plain_array, plain_table, plain_value
from tmmcalc.core.records import names_of
from tmmcalc.core.stored import Record

PLAIN = frozenset((float, int, str, bool, type(None)))  # what TOML holds as it is
LABELS = "labels"  # a field of this name is as long as the table: it goes to the arrays


def to_record(result: Any, error: Mapping[str, Any] | None = None) -> Record:
    """The stored form of a result record: arrays by their dotted path, everything else as nested plain values.

    It is what `plain.plain_record` would make of it.
    Raises `NoSolutionError` if a number of it is not finite.
    """
    arrays: dict[str, np.ndarray] = {}
    scalars = plain(result, arrays)
    _check_finite(type(result).__name__.lower(), scalars, arrays)
    counters = scalars.pop("counters", {})
    taken = {name: plain_array(array, name) for name, array in arrays.items()}
    return Record(scalars, taken, plain_table(error or {}, "error"), counters)


def largest(errors: Sequence[Any]) -> dict[str, float]:
    """The largest of each estimate of several records of one kind; None are records without any."""
    told: dict[str, float] = {}
    for name, size in (pair for each in errors if each is not None for pair in plain(each).items()):
        told[name] = max(told.get(name, 0.0), size)
    return told


def _check_finite(what: str, scalars: Any, arrays: Mapping[str, np.ndarray]) -> None:
    """Refuse NaN and inf, which would spread through every later stage without a word."""
    bad = None
    if not _finite(scalars):
        bad = next(f"{path} is {value:g}" for path, value in _numbers(scalars) if not math.isfinite(value))
    if bad is None:
        bad = next((_first_bad(path, array, arrays) for path, array in arrays.items() if not _sound(array)), None)
    if bad is not None:
        raise NoSolutionError(
            f"{bad}: the numbers of this task go beyond what can be computed",
            where=what,
            remedy="look for a quantity far from the sizes of a machine, such as a wrong unit or exponent",
        )


def _finite(value: Any) -> bool:
    """Whether all floats in nested plain values are finite."""
    if isinstance(value, float):
        return math.isfinite(value)
    if isinstance(value, dict | list):
        return all(map(_finite, value.values() if isinstance(value, dict) else value))
    return True


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

    Fields that are None are left out, as TOML has no null; in a list an empty table stands for it. Phrases stay, see
    `tmmcalc.core.sentences`.
    """
    kind = type(value)
    if kind in PLAIN:
        return value
    names = names_of(kind)
    if names is not None:
        return _table(value, names, arrays, f"{path}." if path else "")
    if isinstance(value, dict):
        return {str(k): plain(v, arrays, f"{path}.{k}") for k, v in value.items() if v is not None}
    if isinstance(value, tuple | list):
        return [{} if v is None else plain(v, arrays, f"{path}.{k}") for k, v in enumerate(value)]
    if isinstance(value, Fraction):
        return str(value)
    if isinstance(value, Phrase):
        return value
    if isinstance(value, Note):
        return value.stored()
    return [float(value.real), float(value.imag)] if isinstance(value, complex) else plain_value(value, path)


def _table(value: Any, names: tuple[str, ...], arrays: dict[str, np.ndarray] | None, start: str) -> dict[str, Any]:
    """The fields of a record that did not go to the arrays; ``start`` is what their paths begin with."""
    found: dict[str, Any] = {}
    for name in names:
        part = getattr(value, name)
        if arrays is not None and isinstance(part, np.ndarray):
            arrays[start + name] = part
        elif arrays is not None and name == LABELS:
            arrays[start + name] = np.array(part)
        elif part is not None:
            found[name] = plain(part, arrays, start + name)
    return found


def restore(kind: Any, data: Any, arrays: Mapping[str, np.ndarray] | None = None, path: str = "") -> Any:
    """The record of type ``kind`` that ``plain`` turned into ``data`` and ``arrays``."""
    return _read(_reader(kind), data, arrays or {}, path)


Reader = Callable[[Any, Mapping[str, np.ndarray], str], Any]  # of data, arrays and the path


def _read(reader: Reader | None, data: Any, arrays: Mapping[str, np.ndarray], path: str) -> Any:
    """What stands in the arrays under the path, else the data; without ``reader`` they are the value itself."""
    if path in arrays:
        return tuple(arrays[path].tolist()) if path.rpartition(".")[2] == LABELS else arrays[path]
    return data if reader is None else reader(data, arrays, path)


@cache
def _reader(kind: Any) -> Reader | None:
    """What reads a value of a type; None: it is stored as it is. A result holds many values of one type."""
    origin, args = get_origin(kind), get_args(kind)
    if isinstance(kind, type) and names_of(kind) is not None:
        return partial(_record, kind)
    if origin in (Union, UnionType):
        return partial(_optional, next(a for a in args if a is not type(None)))
    if origin is tuple:
        return partial(_tuple, args)
    if origin is dict:
        return partial(_dict, args[1])
    if kind in (Note, Phrase):
        return lambda data, arrays, path: restored(kind, data)
    if kind is Fraction:
        return lambda data, arrays, path: Fraction(data)
    return (lambda data, arrays, path: complex(*data)) if kind is complex else None


def _record(kind: Any, data: Any, arrays: Mapping[str, np.ndarray], path: str) -> Any:
    start = f"{path}." if path else ""
    return kind(**{name: _read(reader, data.get(name), arrays, start + name) for name, reader in _fields(kind)})


@cache
def _fields(kind: Any) -> tuple[tuple[str, Reader | None], ...]:
    """Names and readers of the fields of a record."""
    return tuple((name, _reader(_meant(said, kind.__module__))) for name, said in get_annotations(kind).items())


@cache
def _meant(said: Any, module: str) -> Any:
    """The type that an annotation says in its module: most records of a module say the same few."""
    return eval(said, vars(sys.modules[module])) if isinstance(said, str) else said


def _optional(inner: Any, data: Any, arrays: Mapping[str, np.ndarray], path: str) -> Any:
    return None if data is None or data == {} else _read(_reader(inner), data, arrays, path)


def _tuple(args: tuple[Any, ...], data: Any, arrays: Mapping[str, np.ndarray], path: str) -> Any:
    kinds = [args[0]] * len(data) if args[-1] is Ellipsis else args
    return tuple(_read(_reader(a), v, arrays, f"{path}.{k}") for k, (a, v) in enumerate(zip(kinds, data, strict=True)))


def _dict(inner: Any, data: Any, arrays: Mapping[str, np.ndarray], path: str) -> Any:
    reader = _reader(inner)
    return {k: _read(reader, v, arrays, f"{path}.{k}") for k, v in data.items()}
