"""What a stage gives out, said once: on the field that holds it.

    @record
    class OverBalls:
        size: float = quantity("M[m]", "size over two balls or pins, of a ring between them")

The keys of documents, the headers of tables and the pages that list results are read from here. A quantity that is
found from others is a method under `derived`; one that is a component of an array, and stands in no field, is a
`Quantity` by itself beside the columns that it heads. A place in braces stands for a name of the scene:
``quantity("x_{point}[m]", ...)`` heads x_B[m] and x_C[m].
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import MISSING, field
from math import pi
from typing import Any, Generic, NamedTuple, TypeVar, get_args, get_origin, get_type_hints, overload

from tmmcalc.core.notes import Phrase

T = TypeVar("T")

# what a value in the first unit is multiplied by for the second, the unit of people
FORMS: Mapping[tuple[str, str], float] = {
    ("m", "mm"): 1e3,
    ("m", "um"): 1e6,
    ("rad", "deg"): 180 / pi,
    ("", "%"): 100,
    ("Pa", "MPa"): 1e-6,
    ("N/m", "N/mm"): 1e-3,
}


class Quantity(NamedTuple):
    """A quantity by its key for programs, with its unit: ``M[m]``."""

    key: str
    meaning: str  # a few English words; a `Phrase` where they name something of the scene
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
        """The quantity of one point, link, wheel ... by its name; a unit may be a place too, and be empty.

        >>> Quantity("x_{point}[m]", "x of {point}").of(point="C").key
        'x_C[m]'
        >>> Quantity("{name}_max[{unit}]", "largest {name}").of(name="K", unit="").key
        'K_max'
        """
        if not places:
            return self
        found = Quantity(*(text and text.format(**places).removesuffix("[]") for text in self))
        return found._replace(meaning=Phrase(self.meaning, **places)) if "{" in self.meaning else found

    def marked(self, word: str) -> Quantity:
        """The same of its extreme, mean, error ...: a word after the name.

        >>> Quantity("P[W]", "power").marked("max").key
        'P_max[W]'
        """
        name, bracket, unit = self.key.partition("[")
        meaning = Phrase("{quantity}: {word}", quantity=self.meaning, word=word)
        return Quantity(f"{name}_{word}{bracket}{unit}", meaning, source=self.source)

    def shown(self, unit: str) -> tuple[str, float]:
        """The header in a unit for people, and the factor of the values.

        >>> Quantity("M[m]", "size over balls").shown("mm")
        ('M[mm]', 1000.0)
        """
        name = self.heading.partition("[")[0]
        return f"{name}[{unit}]", FORMS[self.unit, unit]

    def value(self, value: Any) -> dict[str, Any]:
        """One value by its key.

        >>> Quantity("M[m]", "size over balls").value(0.25)
        {'M[m]': 0.25}
        """
        return {self.key: value}


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


def quantities(kind: Any) -> Mapping[str, Quantity]:
    """What a kind of record gives out, by the names of its fields and properties, in their order."""
    found: Mapping[str, Quantity] = kind.__record__.quantities
    return found


def quantity_of(kind: Any, name: str, **places: object) -> Quantity:
    """What a field or property of a kind of record gives out."""
    return quantities(kind)[name].of(**places)


def keys(kind: Any, *names: str, **places: object) -> list[str]:
    """Keys of these fields and properties of a kind of record, for values that stand in no record."""
    return [quantity_of(kind, name, **places).key for name in names]


def keyed(of: Any, *names: str, **places: object) -> dict[str, Any]:
    """The quantities of a record by their keys: those of these fields, or all; ``places`` are names of the scene.

    ``"angle[deg]"`` is a field in a unit for people. Tuples and arrays become lists.

    >>> from tmmcalc.core.records import record
    >>> @record
    ... class Ball:
    ...     diameter: float = quantity("D_{wheel}[m]", "diameter of the ball")
    >>> keyed(Ball(0.25), wheel=2), keyed(Ball(0.25), "diameter[mm]", wheel=2)
    ({'D_2[m]': 0.25}, {'D_2[mm]': 250.0})
    """
    found = {}
    for name, key, _, factor in _asked(type(of), names, places):
        value = _plain(getattr(of, name))
        found[key] = value if factor is None else _scaled(value, factor)
    return found


def _asked(
    kind: Any, names: Sequence[str], places: Mapping[str, object]
) -> Iterator[tuple[str, str, str, float | None]]:
    """Fields with the key and the heading under which they are asked for; the factor of those in another unit."""
    known = quantities(kind)
    for asked in names or known:
        name, _, unit = asked.removesuffix("]").partition("[")
        told = known[name].of(**places)
        if unit:
            heading, factor = told.shown(unit)
            yield name, f"{told.name}[{unit}]", heading, factor
        else:
            yield name, told.key, told.heading, None


def _plain(value: Any) -> Any:
    if isinstance(value, tuple):
        return list(value)
    return value.tolist() if hasattr(value, "tolist") else value


def _scaled(value: Any, factor: float) -> Any:
    if isinstance(value, list | tuple):
        return [_scaled(each, factor) for each in value]
    if isinstance(value, Mapping):
        return {name: _scaled(each, factor) for name, each in value.items()}
    return None if value is None else factor * value


def in_degrees(values: Mapping[str, Any]) -> dict[str, Any]:
    """Values by their keys with every angle in deg, those within records and lists too; the rest as it is.

    Angles are kept in rad; where columns of a document are in deg its other angles are too. A derivative by an angle
    has another unit and stays.

    >>> in_degrees({"psi[rad]": pi, "omega[rad/s]": 2.0, "arcs": [{"theta[rad]": [0.0, None]}]})
    {'psi[deg]': 180.0, 'omega[rad/s]': 2.0, 'arcs': [{'theta[deg]': [0.0, None]}]}
    """
    found = {}
    for key, value in values.items():
        if key.endswith("[rad]"):
            header, factor = Quantity(key, "").shown("deg")
            found[header] = _scaled(value, factor)
        else:
            found[key] = _within_degrees(value)
    return found


def _within_degrees(value: Any) -> Any:
    if isinstance(value, Mapping):
        return in_degrees(value)
    return [_within_degrees(each) for each in value] if isinstance(value, list) else value


def headed(of: Any, *names: str, **places: object) -> dict[str, Any]:
    """Arrays (n,) of a record by the headings of their columns, as they are; ``"angle[deg]"`` is one in another unit.

    >>> from tmmcalc.core.records import record
    >>> @record
    ... class Ball:
    ...     radius: float = quantity("M_radius[m]", "where it touches", header="r[m]")
    >>> headed(Ball(0.01)), keyed(Ball(0.01))
    ({'r[m]': 0.01}, {'M_radius[m]': 0.01})
    """
    found = {}
    for name, _, heading, factor in _asked(type(of), names, places):
        value = getattr(of, name)
        found[heading] = value if factor is None else factor * value
    return found


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
    found = {}
    for name, _, heading, factor in _asked(kind, names, places):
        values = [getattr(row, name) for row in rows]
        found[heading] = values if factor is None else _scaled(values, factor)
    return found


def given_out(kind: Any) -> Iterator[Quantity]:
    """All that a kind of record gives out, with the records within it."""
    for each in _records(kind):
        yield from quantities(each).values()


def given_over_rows(kind: Any) -> Iterator[Quantity]:
    """What of it stands in arrays."""
    for each in _records(kind):
        yield from _over_rows(each)


def _over_rows(kind: Any) -> Iterator[Quantity]:
    """What a record has in arrays itself."""
    try:
        hints = get_type_hints(kind)
    except NameError:  # a field of a class that only type checkers import
        return
    yield from (told for name, told in quantities(kind).items() if _holds_arrays(_declared(kind, name, hints)))


def _declared(kind: Any, name: str, hints: Mapping[str, Any]) -> Any:
    """The type of a field, or of what a property returns."""
    own = vars(kind).get(name)
    return get_type_hints(own.find).get("return") if isinstance(own, Derived) else hints.get(name)


def _holds_arrays(hint: Any) -> bool:
    return getattr(get_origin(hint) or hint, "__name__", "") == "ndarray" or any(map(_holds_arrays, get_args(hint)))


def _records(kind: Any) -> Iterator[Any]:
    """A kind of record and those within it."""
    seen: set[Any] = set()
    waiting = [kind]
    while waiting:
        each = waiting.pop(0)
        if each in seen:
            continue
        seen.add(each)
        if hasattr(each, "__record__"):
            yield each
            waiting += get_type_hints(each).values()
        else:
            waiting += get_args(each)


def truths(kind: Any) -> set[str]:
    """Keys of the quantities of a kind of record that are yes or no, with those of the records within it.

    >>> from tmmcalc.core.records import record
    >>> @record
    ... class Brake:
    ...     moment: float = quantity("M[N*m]", "moment of the brake")
    ...     holds: bool = quantity("holds", "whether it holds")
    >>> truths(Brake)
    {'holds'}
    """
    found, others = set[str](), set[str]()
    for each in _records(kind):
        hints = get_type_hints(each)
        for name, told in quantities(each).items():
            (found if _declared(each, name, hints) in (bool, bool | None) else others).add(told.key)
    return found - others


def standing_in(module: Any, over_rows: bool = False) -> Iterator[Quantity]:
    """Quantities that stand in a module by themselves, several together, or on the fields of its records.

    With ``over_rows`` of the records what stands in arrays alone.
    """
    for each in vars(module).values():
        if hasattr(each, "__record__"):
            if each.__module__ == module.__name__:
                yield from _over_rows(each) if over_rows else quantities(each).values()
        else:
            yield from _within(each)


def _within(value: Any) -> Iterator[Quantity]:
    if isinstance(value, Quantity):
        yield value
    elif isinstance(value, tuple | Mapping):
        for each in value.values() if isinstance(value, Mapping) else value:
            yield from _within(each)
