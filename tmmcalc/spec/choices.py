"""Further field types: exact numbers, quantities within limits, known words, one value or several, or false."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from fractions import Fraction
from typing import Any

from tmmcalc.spec.dimensions import DIMENSIONS
from tmmcalc.spec.phrases import listing, nearest, show
from tmmcalc.spec.quantities import Quantity
from tmmcalc.spec.reader import Reader
from tmmcalc.spec.units import UnitError

_DECIMAL = r"[+-]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]{1,3})?"
_LONGEST = 60  # characters of a number: the arithmetic is exact, whatever the digits


class Exact(Reader):
    """A number as it is written, as a fraction: 8.15, ``"8.15"``, ``"163/20"``, and ``"1 %"`` if that is allowed."""

    def __init__(
        self,
        noun: str,
        example: str,
        *,
        above: int | None = None,
        at_least: int | None = None,
        below: int | None = None,
        nonzero: bool = False,
        percent: bool = False,
    ) -> None:
        self.noun = noun
        self.example = example
        self.limits = {"above": above, "at least": at_least, "below": below, "other than": 0 if nonzero else None}
        self.percent = percent

    def read(self, value: object) -> Fraction:
        """Return the fraction; raise UnitError with the fault in plain words."""
        number = self._number(value)
        above, at_least, below, other = self.limits.values()
        inside = (above is None or number > above) and (below is None or number < below)
        if not inside or (at_least is not None and number < at_least) or number == other:
            limits = " and ".join(f"{word} {limit}" for word, limit in self.limits.items() if limit is not None)
            raise UnitError(f"{show(value)} is out of range; {self.noun} is {limits}", self._advice())
        return number

    def describe(self) -> dict[str, Any]:
        """Return the JSON Schema: a number, or a decimal or quotient in quotes."""
        words = {"above": "exclusiveMinimum", "at least": "minimum", "below": "exclusiveMaximum"}
        limits = {words[word]: limit for word, limit in self.limits.items() if limit is not None and word in words}
        percent = r"(\s*%)?" if self.percent else ""
        pattern = rf"^\s*{_DECIMAL}(\s*/\s*{_DECIMAL})?{percent}\s*$"
        kinds = [{"type": "number", **limits}, {"type": "string", "pattern": pattern}]
        return {"anyOf": kinds, "description": f"{self.noun.capitalize()}: a number, such as {self.example}."}

    def _number(self, value: object) -> Fraction:
        if isinstance(value, bool) or not isinstance(value, int | float | str):
            raise UnitError(f"{show(value)} is not {self.noun}", self._advice())
        text = str(value).replace("−", "-").strip()
        if len(text) > _LONGEST:
            raise UnitError(f"{show(value)} is not a finite number of ordinary size", self._advice())
        parts = re.fullmatch(rf"({_DECIMAL})(?:\s*/\s*({_DECIMAL}))?\s*(%?)", text, re.ASCII)
        if parts is None or (parts[7] and not self.percent):
            raise UnitError(f"{show(value)} is not {self.noun}", self._advice())
        if parts[4] and not Fraction(parts[4]):
            raise UnitError(f"{show(value)} is not a finite number of ordinary size", self._advice())
        number = Fraction(parts[1]) / Fraction(parts[4] or 1) / (100 if parts[7] else 1)
        if number and not Fraction(1, 10**100) <= abs(number) <= 10**100:
            raise UnitError(f"{show(value)} is not a finite number of ordinary size", self._advice())
        return number

    def _advice(self) -> str:
        return f"write a number, such as {self.example}"


class Within(Reader):
    """A quantity between two limits in ``unit``, both included, whose SI value is ``scale`` of it.

    A bare number, which is in SI, is below ``bare``: a larger one is meant in ``unit``.
    """

    def __init__(
        self, dimension: str, unit: str, scale: float, low: float, high: float, bare: float = math.inf
    ) -> None:
        self.quantity = Quantity(dimension)
        self.unit = unit
        self.scale = scale
        self.ends = (low, high)
        self.bare = bare

    def read(self, value: object) -> float:
        """Return the value in SI; raise UnitError with the fault in plain words."""
        number = self.quantity.read(value)
        assert isinstance(number, float)
        low, high = self.ends
        inside = low * self.scale <= number <= high * self.scale
        if isinstance(value, int | float) and not (inside and number < self.bare) and low <= value <= high:
            si = DIMENSIONS[self.quantity.dimensions[0]].si
            or_si = f' or "{value:g} {si}"' if inside else ""
            raise UnitError(f"{show(value)} without a unit is in {si}", f'write "{value:g} {self.unit}"{or_si}')
        if not inside:
            limits = f"it is between {low:g} and {high:g} {self.unit}"
            raise UnitError(f"{show(value)} is out of range; {limits}", "write a value between them")
        return number

    def describe(self) -> dict[str, Any]:
        """Return the JSON Schema: a number in SI within the limits, or a string of number and unit."""
        found = self.quantity.describe()
        low, high = (end * self.scale for end in self.ends)
        found["anyOf"][0].update(minimum=low, maximum=min(high, self.bare))
        return found


class Whole(Reader):
    """A whole number within limits, both included."""

    def __init__(self, noun: str, least: int, largest: int) -> None:
        self.noun = noun
        self.least = least
        self.largest = largest

    def read(self, value: object) -> int:
        """Return the number; raise UnitError with the fault in plain words."""
        if isinstance(value, bool) or not isinstance(value, int):
            raise UnitError(f"{show(value)} is not {self.noun}", "write a whole number")
        if not self.least <= value <= self.largest:
            limits = f"between {self.least} and {self.largest}"
            raise UnitError(f"{show(value)} is out of range; {self.noun} is {limits}", f"write a number {limits}")
        return value

    def describe(self) -> dict[str, Any]:
        """Return the JSON Schema: an integer within its limits."""
        limits = {"minimum": self.least, "maximum": self.largest}
        return {"type": "integer", **limits, "description": f"{self.noun.capitalize()}: a whole number."}


class Known(Reader):
    """A word of a list."""

    def __init__(self, noun: str, words: Sequence[str]) -> None:
        self.noun = noun
        self.words = tuple(words)

    def read(self, value: object) -> str:
        """Return the word; raise UnitError with the nearest known one."""
        if isinstance(value, str) and value in self.words:
            return value
        close = nearest(value, self.words) if isinstance(value, str) else None
        guess = f'did you mean "{close}"? ' if close else ""
        from tmmcalc.spec.cyrillic import stranger  # late: only faults need it

        alike = stranger(value) if isinstance(value, str) else ""
        raise UnitError(f"{show(value)} is no {self.noun}{alike}", f"{guess}there are: {listing(self.words)}")

    def describe(self) -> dict[str, Any]:
        """Return the JSON Schema: one of the words."""
        return {"type": "string", "enum": list(self.words), "description": f"A {self.noun}."}


class OneOrMore(Reader):
    """A value, or a list of different values of the same kind; always read as a list."""

    def __init__(self, item: Reader) -> None:
        self.item = item

    def read(self, value: object) -> list[Any]:
        """Return the list; raise UnitError with the fault of the first value that has one."""
        if not isinstance(value, list):
            return [self.item.read(value)]
        found = [self.item.read(each) for each in value]
        if not found:
            raise UnitError("[] is an empty list", "write one value or several")
        for place, each in enumerate(found):
            if each in found[:place]:
                raise UnitError(f"{show(value[place])} is named twice", "remove one of them")
        return found

    def describe(self) -> dict[str, Any]:
        """Return the JSON Schema: the value or a list of it."""
        one = self.item.describe()
        return {"anyOf": [one, {"type": "array", "items": one, "minItems": 1}], "description": one["description"]}


class Listed(Reader):
    """A list of a fixed number of values, or of any number of them but none."""

    def __init__(self, item: Reader, example: str, count: int | None = None) -> None:
        self.item = item
        self.example = example
        self.count = count

    def read(self, value: object) -> list[Any]:
        """Return the list; raise UnitError with the fault in plain words."""
        if not isinstance(value, list) or not value or self.count not in (None, len(value)):
            many = f"a list of {self.count} values" if self.count else "a list"
            raise UnitError(f"{show(value)} is not {many}", f"write {self.example}")
        return [self.item.read(each) for each in value]

    def describe(self) -> dict[str, Any]:
        """Return the JSON Schema: an array."""
        size = {"minItems": self.count, "maxItems": self.count} if self.count else {"minItems": 1}
        return {"type": "array", "items": self.item.describe(), **size, "description": f"A list: {self.example}."}


class OrFalse(Reader):
    """A value, or false that switches it off."""

    def __init__(self, item: Reader) -> None:
        self.item = item

    def read(self, value: object) -> Any:
        """Return False or the value; raise UnitError with the fault of the value."""
        if value is False:
            return False
        try:
            return self.item.read(value)
        except UnitError as fault:
            raise UnitError(fault.message, f"{fault.remedy}; or false to switch it off") from None

    def describe(self) -> dict[str, Any]:
        """Return the JSON Schema: false or the value."""
        one = self.item.describe()
        return {"anyOf": [{"const": False}, one], "description": f"{one['description'].rstrip('.')}; or false."}
