"""Frozen records: dataclasses whose creation at import costs a quarter.

``dataclass(frozen=True)`` compiles six functions a class. With some forty records on the way of a short command that
is a tenth of its time. Here only ``__init__`` is compiled; comparison, hash, text and the refusal to change are
shared by all records. ``dataclasses.fields``, ``replace`` and ``asdict`` work as usual.
"""

from __future__ import annotations

from dataclasses import FrozenInstanceError, dataclass, field
from typing import Any, TypeVar, dataclass_transform

T = TypeVar("T")


@dataclass_transform(frozen_default=True, field_specifiers=(field,))
def record(cls: type[T]) -> type[T]:
    """Class decorator: a frozen dataclass.

    >>> @record
    ... class Pair:
    ...     a: int
    ...     b: int = 2
    >>> Pair(1), Pair(1) == Pair(1, 2)
    (Pair(a=1, b=2), True)
    """
    made: Any = dataclass(repr=False, eq=False, match_args=False)(cls)
    made.__setattr__ = _set_once
    made.__delattr__ = _keep
    made.__repr__ = _text
    made.__eq__ = _equal
    made.__hash__ = _hash
    return cls


def _values(self: Any) -> tuple[Any, ...]:
    return tuple(getattr(self, name) for name in self.__dataclass_fields__)


def _set_once(self: Any, name: str, value: Any) -> None:
    """``__init__`` gives every field its value; after that none can change and none can be added."""
    if name in self.__dict__ or name not in self.__dataclass_fields__:
        raise FrozenInstanceError(f"cannot assign to field {name!r}")
    self.__dict__[name] = value


def _keep(self: Any, name: str) -> None:
    raise FrozenInstanceError(f"cannot delete field {name!r}")


def _text(self: Any) -> str:
    parts = (f"{name}={getattr(self, name)!r}" for name in self.__dataclass_fields__)
    return f"{type(self).__qualname__}({', '.join(parts)})"


def _equal(self: Any, other: object) -> bool:
    return _values(self) == _values(other) if type(other) is type(self) else NotImplemented


def _hash(self: Any) -> int:
    return hash((type(self), *_values(self)))
