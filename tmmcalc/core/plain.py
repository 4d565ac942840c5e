"""The one form in which a record is handed on, whether it has just been computed or comes from a file.

Values become what TOML gives back (lists for tuples, Python numbers for numpy scalars), arrays what npz
gives back (C order, contiguous): sums over another memory layout may differ in the last bit, and a run
resumed from files must not. Arrays are read-only, for several stages look at the same one.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from tmmcalc.core.stored import Record


def plain_record(record: Record) -> Record:
    """Return the record in the form in which it would come back from its files.

    Raises TypeError for a value that TOML cannot hold and for arrays of objects.
    """
    return Record(
        scalars=plain_table(record.scalars, "scalars"),
        arrays={name: plain_array(array, name) for name, array in record.arrays.items()},
        error=plain_table(record.error, "error"),
        counters=plain_table(record.counters, "counters"),
    )


def plain_table(table: Mapping[str, Any], where: str) -> dict[str, Any]:
    """Return the table with plain values only; ``where`` names it in a TypeError."""
    return {_plain_key(key, where): plain_value(value, f"{where}.{key}") for key, value in table.items()}


def _plain_key(key: object, where: str) -> str:
    if not isinstance(key, str):
        raise TypeError(f"{where}: key {key!r} is not a string")
    return str(key)


def plain_value(value: Any, where: str) -> Any:
    """A value as TOML gives it back; ``where`` names it in a TypeError."""
    kind = type(value)
    if kind in (float, int, str, bool):
        return value
    if kind is dict or isinstance(value, Mapping):
        return plain_table(value, where)
    if isinstance(value, (list, tuple)):
        return [plain_value(item, f"{where}[{at}]") for at, item in enumerate(value)]
    if isinstance(value, str):
        return str.__str__(value)  # a member of a string enum is its value
    if isinstance(value, (int, float)):  # numpy.float64 is a float
        return int(value) if isinstance(value, int) else float(value)
    return _plain_number(value, where)


def _plain_number(value: Any, where: str) -> Any:
    """Convert a numpy scalar or array; an extended-precision one has no Python number and is refused."""
    converted = value.tolist() if hasattr(value, "tolist") else value
    if type(converted) not in (bool, int, float, str, list):
        raise TypeError(f"{where}: TOML cannot hold {value!r} of type {type(value).__qualname__}")
    return plain_value(converted, where)


def plain_array(array: Any, name: str) -> Any:
    """A read-only view of the array as npz gives it back; ``name`` names it in a TypeError."""
    import numpy as np

    view = np.asarray(array, order="C").view()
    if view.dtype.hasobject:
        raise TypeError(f"array {name!r} holds Python objects: it cannot be stored")
    view.flags.writeable = False
    return view
