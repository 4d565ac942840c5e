"""Frozen records: dataclasses whose creation at import costs a fiftieth.

``dataclass(frozen=True)`` compiles six functions a class, which for the records of a whole project takes as long as its
computation. Here all records share theirs, and a class only keeps the names of its fields and their defaults. What
``dataclasses`` itself keeps is made when it is asked for, so ``fields``, ``replace`` and ``asdict`` work as usual.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import MISSING, Field, FrozenInstanceError, dataclass, field, fields, is_dataclass
from inspect import get_annotations
from typing import Any, NamedTuple, NoReturn, TypeVar, dataclass_transform

from tmmcalc.core.quantity import Derived, Quantity, quantity

T = TypeVar("T")


class Names(NamedTuple):
    """Fields of a record class in their order, those with a default, what makes a default, and what is given out."""

    fields: tuple[str, ...]
    defaults: dict[str, Any]
    makers: dict[str, Callable[[], Any]]
    quantities: dict[str, Quantity]


class _DeferredFields:
    """Stands for the fields as `dataclasses` keeps them, until it asks."""

    def __init__(self, cls: type[Any]) -> None:
        self.cls = cls

    def __get__(self, instance: object, owner: type[Any]) -> dict[str, Field[Any]]:
        found: Any = dataclass(init=False, repr=False, eq=False, match_args=False)(self.cls)
        kept: dict[str, Field[Any]] = found.__dataclass_fields__
        return kept


@dataclass_transform(frozen_default=True, field_specifiers=(field, quantity))
def record(cls: type[T]) -> type[T]:
    """Class decorator: a frozen dataclass; its fields are those of this class alone.

    >>> @record
    ... class Pair:
    ...     a: int
    ...     b: int = 2
    >>> Pair(1), Pair(1) == Pair(1, 2)
    (Pair(a=1, b=2), True)
    """
    made: Any = cls
    made.__record__ = _names(cls)
    made.__dataclass_fields__ = _DeferredFields(cls)
    made.__init__ = _fill
    made.__setattr__ = _set
    made.__delattr__ = _keep
    made.__repr__ = _text
    made.__eq__ = _equal
    made.__hash__ = _hash
    return cls


def names_of(kind: type[Any]) -> tuple[str, ...] | None:
    """Names of the fields of a record or another dataclass in their order; None of any other class."""
    own: Names | None = getattr(kind, "__record__", None)
    if own is not None:
        return own.fields
    return tuple(each.name for each in fields(kind)) if is_dataclass(kind) else None


def _names(cls: type[Any]) -> Names:
    names = tuple(get_annotations(cls))
    given = {name: cls.__dict__[name] for name in names if name in cls.__dict__}
    told = {name: value for name, value in given.items() if isinstance(value, Field)}
    declared = {name: each.metadata["quantity"] for name, each in told.items() if "quantity" in each.metadata}
    derived = {name: each.quantity for name, each in cls.__dict__.items() if isinstance(each, Derived)}
    defaults = {name: told[name].default if name in told else value for name, value in given.items()}
    return Names(
        names,
        {name: value for name, value in defaults.items() if value is not MISSING},
        {name: each.default_factory for name, each in told.items() if each.default_factory is not MISSING},
        declared | derived,
    )


def _fill(self: Any, *args: Any, **named: Any) -> None:
    """Give every field its value; raise TypeError where one is missing, is given twice or is none of the record."""
    names, defaults, makers, _ = self.__record__
    values = self.__dict__
    if not named and len(args) == len(names):
        values.update(zip(names, args, strict=True))
        if hasattr(self, "__post_init__"):
            self.__post_init__()
        return
    values.update(zip(names, args, strict=False))
    values.update(named)
    if len(args) + len(named) != len(names) or len(values) != len(names):
        for name in names:
            if name in values:
                continue
            if name not in defaults and name not in makers:
                raise TypeError(f"{type(self).__qualname__}: field {name!r} is missing")
            values[name] = defaults[name] if name in defaults else makers[name]()
    if len(values) != len(names) or len(args) > len(names) or not named.keys().isdisjoint(names[: len(args)]):
        raise TypeError(f"{type(self).__qualname__}: more is given than the fields {', '.join(names)}")
    if hasattr(self, "__post_init__"):
        self.__post_init__()


def _values(self: Any) -> tuple[Any, ...]:
    return tuple(getattr(self, name) for name in self.__record__.fields)


def _set(self: Any, name: str, value: Any) -> NoReturn:
    raise FrozenInstanceError(f"cannot assign to field {name!r}")


def _keep(self: Any, name: str) -> NoReturn:
    raise FrozenInstanceError(f"cannot delete field {name!r}")


def _text(self: Any) -> str:
    parts = (f"{name}={getattr(self, name)!r}" for name in self.__record__.fields)
    return f"{type(self).__qualname__}({', '.join(parts)})"


def _equal(self: Any, other: object) -> bool:
    return _values(self) == _values(other) if type(other) is type(self) else NotImplemented


def _hash(self: Any) -> int:
    return hash((type(self), *_values(self)))
