"""Records in extended precision: formulas that keep the precision of what they are given then have 64 bits."""

from __future__ import annotations

from dataclasses import fields, is_dataclass, replace
from typing import Any, TypeVar

import numpy as np

KINDS = {"f": np.longdouble, "c": np.clongdouble}

Given = TypeVar("Given")


def wide(value: Given) -> Given:
    """The same with all floats, in records and tuples as well, in extended precision.

    >>> wide(0.5).dtype == np.longdouble, wide(("a", 3))
    (True, ('a', 3))
    """
    found: Given = _wide(value)
    return found


def _wide(value: Any) -> Any:
    if isinstance(value, np.ndarray):
        kind = KINDS.get(value.dtype.kind)
        return value if kind is None else value.astype(kind)
    if isinstance(value, float):
        return np.longdouble(value)
    if isinstance(value, tuple):
        return tuple(_wide(each) for each in value)
    if is_dataclass(value) and not isinstance(value, type):
        return replace(value, **{each.name: _wide(getattr(value, each.name)) for each in fields(value) if each.init})
    return value
