"""Constants of several variants in the place of one: arrays that have a truth value where all of them agree.

Code for one variant asks its constants questions (``if offset == 0``) and is array code in all the rest. With an
`Alike` in the place of a number it holds for many variants at once, as long as each question has the same answer for
all; where it has not, `MixedError` is raised and the variants have to be taken apart. What takes one number alone
(``math.sqrt``, a key of a dictionary, a format) gets `SeveralError`.

Trees are records, named tuples, tuples and dictionaries, however nested, with numbers and `Alike` as leaves.
"""

from __future__ import annotations

import operator
from collections.abc import Callable, Iterator, Sequence
from typing import Any, Generic, TypeVar

import numpy as np
from numpy.typing import NDArray

T = TypeVar("T")
Indices = NDArray[np.intp]
Maker = Callable[[Any], Any]


class MixedError(Exception):
    """A question has different answers for the variants."""


class SeveralError(Exception):
    """One number is asked for where there are several."""


class Alike(np.ndarray):
    """One number for each variant, or for each row of several variants."""

    def __bool__(self) -> bool:
        """The truth that all have; raises `MixedError` where they differ."""
        plain = self.view(np.ndarray)
        if plain.all():
            return True
        if plain.any():
            raise MixedError
        return False

    def __float__(self) -> float:
        return float(self._one())

    def __int__(self) -> int:
        return int(self._one())

    def __complex__(self) -> complex:
        return complex(self._one())

    def __index__(self) -> int:
        return operator.index(self._one())

    def __round__(self, digits: int | None = None) -> Any:
        return round(self._one(), digits)

    def __format__(self, form: str) -> str:
        return format(self._one(), form)

    def __hash__(self) -> int:  # type: ignore[override]
        return hash(self._one())

    def _one(self) -> Any:
        """The number, if it is one; else raises `SeveralError`."""
        if self.size != 1:
            raise SeveralError
        return self.item()


def alike(values: Any) -> Any:
    """The values (V,) as one constant: a number where all are equal."""
    plain = np.asarray(values)
    return plain[0].item() if np.all(plain == plain[0]) else plain.view(Alike)


class Rows(Generic[T]):
    """A tree whose `Alike` (V,) can be taken at any rows; the way to them is looked up once."""

    def __init__(self, tree: T) -> None:
        self.tree = tree
        self._make = _maker(tree)

    def __call__(self, rows: Indices | int) -> T:
        """The tree with the constants of the variants ``rows``, in their shape; of one number with plain numbers."""
        return self.tree if self._make is None else self._make(rows)


def rows_of(tree: T, rows: Indices) -> T:
    """The tree with every `Alike` (V,) at ``rows`` (m,)."""
    return Rows(tree)(rows)


def numbers(tree: Any) -> list[float | complex]:
    """All floats and complex numbers of a tree, in its order."""
    return list(_numbers(tree))


def rebuilt(tree: T, given: Sequence[Any]) -> T:
    """The tree with other leaves in the place of its `numbers`."""
    made: T = _rebuilt(tree, iter(given))
    return made


def groups(tree: Any) -> list[int]:
    """Of every number of a tree which record or dictionary holds it, directly or in a tuple."""
    found: list[int] = []

    def look(part: Any, owner: int) -> None:
        if isinstance(part, float | complex):
            found.append(owner)
            return
        inner = owner if type(part) is tuple else len(seen)
        seen.append(part)
        for each in _parts(part):
            look(each, inner)

    seen: list[Any] = []
    look(tree, 0)
    return found


def paths(tree: Any, path: str = "") -> Iterator[str]:
    """Where every number of a tree stands, ``bodies.0.mass``, in its order."""
    if isinstance(tree, float | complex):
        yield path
        return
    for name, part in zip(_names(tree), _parts(tree), strict=True):
        yield from paths(part, f"{path}.{name}" if path else name)


def shape_of(tree: Any) -> Any:
    """All of a tree but its numbers, to be compared."""
    if isinstance(tree, float | complex):
        return float
    if not _is_tree(tree):
        return tree
    return type(tree), tuple(_names(tree)), tuple(shape_of(part) for part in _parts(tree))


def _is_tree(part: Any) -> bool:
    return isinstance(part, tuple | dict) or hasattr(part, "__dataclass_fields__")


def _names(tree: Any) -> list[str]:
    if isinstance(tree, dict):
        return [str(key) for key in tree]
    if hasattr(tree, "__dataclass_fields__"):
        return list(tree.__dataclass_fields__)
    return [str(i) for i in range(len(tree))] if isinstance(tree, tuple) else []


def _parts(tree: Any) -> list[Any]:
    if isinstance(tree, dict):
        return list(tree.values())
    if hasattr(tree, "__dataclass_fields__"):
        return [tree.__dict__[name] for name in tree.__dataclass_fields__]
    return list(tree) if isinstance(tree, tuple) else []


def _numbers(tree: Any) -> Iterator[float | complex]:
    if isinstance(tree, float | complex):
        yield tree
        return
    for part in _parts(tree):
        yield from _numbers(part)


def _maker(tree: Any) -> Maker | None:
    """What makes a tree of the rows; None where nothing in it differs."""
    if isinstance(tree, Alike):
        return lambda rows: tree.item(rows) if isinstance(rows, int) else tree[rows]
    makers = {at: made for at, part in enumerate(_parts(tree)) if (made := _maker(part)) is not None}
    if not makers:
        return None

    def make(rows: Any) -> Any:
        parts = _parts(tree)
        for at, maker in makers.items():
            parts[at] = maker(rows)
        return _like(tree, parts)

    return make


def _rebuilt(tree: Any, rest: Iterator[Any]) -> Any:
    if isinstance(tree, float | complex):
        return next(rest)
    parts = _parts(tree)
    return _like(tree, [_rebuilt(part, rest) for part in parts]) if parts else tree


def _like(tree: Any, parts: Sequence[Any]) -> Any:
    """A tree of the same kind with other parts."""
    if isinstance(tree, dict):
        return dict(zip(tree, parts, strict=True))
    if hasattr(tree, "__dataclass_fields__"):
        return _record(tree, parts)
    return type(tree)(*parts) if hasattr(tree, "_fields") else tuple(parts)


def _record(tree: Any, parts: Sequence[Any]) -> Any:
    """A record with other fields, whose checks are those of the record that it was made of."""
    made = object.__new__(type(tree))
    made.__dict__.update(zip(tree.__dataclass_fields__, parts, strict=True))
    return made
