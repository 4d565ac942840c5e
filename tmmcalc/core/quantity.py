"""What a stage gives out, said once: on the field that holds it.

    @record
    class OverBalls:
        size: float = quantity("M[m]", "size over two balls or pins", source="(4.65)")

The keys of documents, the headers of tables and the pages that list results are read from here. A quantity that is
found from others is a method under `derived`; one that is a component of an array, and stands in no field, is a
`Quantity` by itself beside the columns that it heads. A place in braces stands for a name of the scene:
``quantity("x_{point}[m]", ...)`` heads x_B[m] and x_C[m].
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import MISSING, field
from math import pi
from typing import Any, Generic, NamedTuple, TypeVar, overload

T = TypeVar("T")

# what a value in the first unit is multiplied by for the second, the unit of people
FORMS: Mapping[tuple[str, str], float] = {
    ("m", "mm"): 1e3,
    ("rad", "deg"): 180 / pi,
    ("", "%"): 100,
    ("Pa", "MPa"): 1e-6,
}


class Quantity(NamedTuple):
    """A quantity by its key for programs, with its unit: ``M[m]``."""

    key: str
    meaning: str  # a few English words
    symbol: str = ""  # as it is typeset where that is not its name: ``W^*`` of ``W_star[m]``
    source: str = ""  # the textbook's formula or the rule that it is from
    header: str = ""  # as it heads a column of the table of its records, where that is not the key

    @property
    def name(self) -> str:
        """The key without its unit."""
        return self.key.partition("[")[0]

    @property
    def heading(self) -> str:
        """What heads its column in a table of the records."""
        return self.header or self.key

    @property
    def unit(self) -> str:
        """Its unit; empty: a number, a word or a truth value."""
        return self.key.partition("[")[2].removesuffix("]")

    def of(self, **places: object) -> Quantity:
        """The quantity of one point, link, wheel ... by its name.

        >>> Quantity("x_{point}[m]", "x of {point}").of(point="C").key
        'x_C[m]'
        """
        return Quantity(*(text.format(**places) for text in self)) if places else self

    def shown(self, unit: str) -> tuple[str, float]:
        """The header in a unit for people, and the factor of the values.

        >>> Quantity("M[m]", "size over balls").shown("mm")
        ('M[mm]', 1000.0)
        """
        name = self.heading.partition("[")[0]
        return f"{name}[{unit}]", FORMS[self.unit, unit]


def quantity(
    key: str,
    meaning: str,
    *,
    symbol: str = "",
    source: str = "",
    header: str = "",
    default: Any = MISSING,
    default_factory: Any = MISSING,
) -> Any:
    """A field of a record that is given out, see `Quantity`."""
    told = Quantity(key, meaning, symbol, source, header)
    return field(default=default, default_factory=default_factory, metadata={"quantity": told})


class Derived(Generic[T]):
    """A property that is given out; made by `derived`."""

    def __init__(self, told: Quantity, find: Callable[[Any], T]) -> None:
        self.quantity, self.find, self.__doc__ = told, find, find.__doc__

    @overload
    def __get__(self, instance: None, owner: type) -> Derived[T]: ...
    @overload
    def __get__(self, instance: object, owner: type) -> T: ...
    def __get__(self, instance: object | None, owner: type) -> Derived[T] | T:
        return self if instance is None else self.find(instance)


def derived(
    key: str, meaning: str, *, symbol: str = "", source: str = "", header: str = ""
) -> Callable[[Callable[[Any], T]], Derived[T]]:
    """Decorator of a method without arguments: a property of a record that is given out, see `Quantity`."""
    return lambda find: Derived(Quantity(key, meaning, symbol, source, header), find)


def quantities(kind: Any) -> dict[str, Quantity]:
    """What a kind of record gives out, by the names of its fields and properties, in their order."""
    found: dict[str, Quantity] = dict(kind.__record__.quantities)
    return found | {name: each.quantity for name, each in vars(kind).items() if isinstance(each, Derived)}


def keyed(of: Any, *names: str, **places: object) -> dict[str, Any]:
    """The quantities of a record by their keys: those of these fields, or all; ``places`` are names of the scene.

    >>> from tmmcalc.core.records import record
    >>> @record
    ... class Ball:
    ...     diameter: float = quantity("D_{wheel}[m]", "diameter of the ball")
    >>> keyed(Ball(0.01), wheel=2)
    {'D_2[m]': 0.01}
    """
    known = quantities(type(of))
    return {known[name].of(**places).key: getattr(of, name) for name in names or known}


def headed(of: Any, *names: str, **places: object) -> dict[str, Any]:
    """The arrays of a record by the headings of their columns, as `keyed` gives them by their keys.

    >>> from tmmcalc.core.records import record
    >>> @record
    ... class Ball:
    ...     radius: float = quantity("M_radius[m]", "where it touches", header="r[m]")
    >>> headed(Ball(0.01)), keyed(Ball(0.01))
    ({'r[m]': 0.01}, {'M_radius[m]': 0.01})
    """
    known = quantities(type(of))
    return {known[name].of(**places).heading: getattr(of, name) for name in names or known}


def components(of: Any, name: str, **place: Sequence[object]) -> dict[str, Any]:
    """The components of an array (n, m), or of a tuple of m numbers, of a record by the headings of each of m names.

    >>> from tmmcalc.core.records import record
    >>> @record
    ... class Point:
    ...     place: tuple[float, float] = quantity("{axis}_S[m]", "place of S")
    >>> components(Point((1.0, 2.0)), "place", axis="xy")
    {'x_S[m]': 1.0, 'y_S[m]': 2.0}
    """
    told, values = quantities(type(of))[name], getattr(of, name)
    ((where, names),) = place.items()
    parts = zip(names, getattr(values, "T", values), strict=True)
    return {told.of(**{where: each}).heading: part for each, part in parts}


def table(rows: Sequence[Any], kind: type, *names: str, **places: object) -> dict[str, list[Any]]:
    """The quantities of many records of a kind, a list a header; ``"diameter[mm]"`` is a field in a unit for people.

    >>> from tmmcalc.core.records import record
    >>> @record
    ... class Ball:
    ...     diameter: float = quantity("D[m]", "diameter of the ball")
    >>> table([Ball(0.25), Ball(0.5)], Ball, "diameter[mm]")
    {'D[mm]': [250.0, 500.0]}
    """
    known = quantities(kind)
    found = {}
    for asked in names or known:
        name, _, unit = asked.removesuffix("]").partition("[")
        told = known[name].of(**places)
        values = [getattr(row, name) for row in rows]
        if unit:
            header, factor = told.shown(unit)
            found[header] = [None if value is None else factor * value for value in values]
        else:
            found[told.heading] = values
    return found
