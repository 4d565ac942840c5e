"""Which keys of a spec a function reads: it is given the spec behind a glass that notes every key that is looked at.

So what a plan says of a decision is what the decision looked at, and needs no second list that could differ from it.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator
from typing import Any, NamedTuple

from tmmcalc.core.records import record


@record
class Seen:
    """A key that was read: its dotted path, those of all entries of a list under one, and whether a value was there."""

    key: str  # "mechanism.links.mass"
    there: bool


class Something:
    """Stands for a value that the spec has not: it is there, and so is whatever is looked for in it."""

    def __getattr__(self, name: str) -> Something:
        return self

    def __iter__(self) -> Iterator[Something]:
        yield self

    def __sub__(self, other: object) -> float:
        return 0.0  # a number that is just what it is compared with


class BarredError(Exception):
    """A key was read that is not to be looked at."""


def watched(
    function: Callable[[Any], Any], spec: object, supposed: str = "", barred: Collection[str] = ()
) -> tuple[Any, tuple[Seen, ...]]:
    """Return ``function(spec)`` and the keys that it read, in the order of the first look at each.

    Tables that were only passed through, to get at a key of theirs, are left out. ``supposed`` is an absent key that
    is to be taken for given: the function then sees `Something` there. Raises `BarredError` for a look at a key that
    is ``barred``.

    >>> from types import SimpleNamespace
    >>> @record
    ... class Wheel:
    ...     delta: float | None
    >>> @record
    ... class Scene:
    ...     wheel: Wheel | None
    >>> watched(lambda spec: spec.wheel is not None and spec.wheel.delta, Scene(Wheel(None)))
    (None, (Seen(key='wheel.delta', there=False),))
    """
    notes: dict[str, bool] = {}
    result = function(_behind_glass(spec, _Place("", notes, supposed, barred)))
    through = {key for key in notes if any(other.startswith(f"{key}.") for other in notes)}
    return result, tuple(Seen(key, there) for key, there in notes.items() if key not in through)


class _Place(NamedTuple):
    """A place in the spec, what was noted of all of it, the key that is supposed to be given, those that are barred."""

    path: str
    notes: dict[str, bool]
    supposed: str
    barred: Collection[str]


def _behind_glass(value: Any, place: _Place) -> Any:
    """Tables, and lists and dicts of tables, behind the glass; everything else as it is."""
    if _fields(value):
        return _Glass(value, place)
    if isinstance(value, (list, tuple)) and any(_fields(item) for item in value):
        return type(value)(_behind_glass(item, place) for item in value)
    if isinstance(value, dict) and any(_fields(item) for item in value.values()):
        return {key: _behind_glass(item, place) for key, item in value.items()}
    return value


def _fields(value: Any) -> Any:
    """The fields of a table (a pydantic model or a record); empty for anything else."""
    kind = type(value)
    return getattr(kind, "model_fields", None) or getattr(kind, "__dataclass_fields__", ())


class _Glass:
    """Stands for a table, notes the keys that are read, and passes for it under ``isinstance``."""

    __slots__ = ("_place", "_table")

    def __init__(self, table: Any, place: _Place) -> None:
        self._table, self._place = table, place

    @property  # type: ignore[misc]  # mypy knows a class of an object as that alone which made it
    def __class__(self) -> type:
        return type(self._table)

    def __getattr__(self, name: str) -> Any:
        own = getattr(type(self._table), name, None)
        if isinstance(own, property) and own.fget is not None and name not in _fields(self._table):
            return own.fget(self)
        value = getattr(self._table, name)
        if name not in _fields(self._table):
            return value
        key = getattr(_fields(self._table)[name], "alias", None) or name
        place = self._place._replace(path=f"{self._place.path}.{key}".removeprefix("."))
        if place.path in place.barred:
            raise BarredError(place.path)
        place.notes[place.path] = place.notes.get(place.path, False) or bool(value)
        if place.path == place.supposed:
            return Something()
        return _behind_glass(value, place)
