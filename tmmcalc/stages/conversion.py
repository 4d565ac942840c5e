"""Frozen records as plain values for TOML, and back, by their type hints."""

from __future__ import annotations

from dataclasses import fields, is_dataclass
from types import UnionType
from typing import Any, Union, get_args, get_origin, get_type_hints


def plain(value: Any) -> Any:
    """The value as nested dicts and lists; fields that are None are left out, as TOML has no null."""
    if is_dataclass(value) and not isinstance(value, type):
        pairs = ((f.name, getattr(value, f.name)) for f in fields(value))
        return {name: plain(v) for name, v in pairs if v is not None}
    if isinstance(value, dict):
        return {str(k): plain(v) for k, v in value.items() if v is not None}
    if isinstance(value, tuple | list):
        return [plain(v) for v in value]
    return value


def restore(kind: Any, data: Any) -> Any:
    """The record of type ``kind`` that ``plain`` turned into ``data``."""
    origin, args = get_origin(kind), get_args(kind)
    if is_dataclass(kind) and isinstance(kind, type):
        hints = get_type_hints(kind)
        return kind(**{name: restore(hint, data.get(name)) for name, hint in hints.items()})
    if origin in (Union, UnionType):
        return None if data is None else restore(next(a for a in args if a is not type(None)), data)
    if origin is tuple:
        if args[-1] is Ellipsis:
            return tuple(restore(args[0], v) for v in data)
        return tuple(restore(a, v) for a, v in zip(args, data, strict=True))
    if origin is dict:
        return {k: restore(args[1], v) for k, v in data.items()}
    return data
