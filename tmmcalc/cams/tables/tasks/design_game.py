"""The options of the design game in ``[cam.optimum]``: values, or values by names of one's own."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from tmmcalc.spec.phrases import nearest, show
from tmmcalc.spec.reader import Reader
from tmmcalc.spec.units import UnitError

ROLLER_KINDS = {"needle": 1.15, "plain": 2.2, "rolling": 3.0}  # alpha0: least r2 over the radius of the pin


class Options(Reader):
    """A list of values, of which some have ``words``, or a table of values by name; read as (name, value)."""

    def __init__(self, item: Reader, example: str, words: Mapping[str, float] | None = None) -> None:
        self.item = item
        self.example = example
        self.words = dict(words or {})

    def read(self, value: object) -> list[tuple[str, float]]:
        """Return names, empty where there is none, and values; raise UnitError with the fault in plain words."""
        if isinstance(value, dict) and value:
            return [(str(name), self.item.read(each)) for name, each in value.items()]
        if isinstance(value, dict | list) and not value:
            raise UnitError(
                f"{show(value) if value == [] else '{}'} is empty: there is nothing to try", f"write {self.example}"
            )
        if not isinstance(value, list):
            raise UnitError(f"{show(value)} is not a list", f"write {self.example}")
        return [self._one(each) for each in value]

    def _one(self, value: object) -> tuple[str, float]:
        if isinstance(value, str) and self.words and value[:1].isalpha():
            if value not in self.words:
                close = nearest(value, list(self.words))
                guess = f'did you mean "{close}"? ' if close else ""
                known = f"{guess}there are: {', '.join(self.words)}, or a number"
                raise UnitError(f"{show(value)} is no known kind", known)
            return value, self.words[value]
        return "", self.item.read(value)

    def describe(self) -> dict[str, Any]:
        """Return the JSON Schema: an array, or an object of values by name."""
        one = self.item.describe()
        item = {"anyOf": [{"type": "string", "enum": list(self.words)}, one]} if self.words else one
        kinds = [
            {"type": "array", "items": item, "minItems": 1},
            {"type": "object", "patternProperties": {".+": one}, "additionalProperties": False, "minProperties": 1},
        ]
        return {"anyOf": kinds, "description": f"A list, {self.example}, or a table of values by name."}
