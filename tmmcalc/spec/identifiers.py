"""The field types of names: of points and joints, of things that are named in tables alone, of positions."""

from __future__ import annotations

import re
from typing import Annotated, Any

from pydantic import Field

from tmmcalc.spec.phrases import show
from tmmcalc.spec.reader import Reader
from tmmcalc.spec.units import UnitError

NAME_PATTERN = "^[A-Za-z][A-Za-z0-9_']*$"
NAME = re.compile(r"[A-Za-z][A-Za-z0-9_']*")


class Name(Reader):
    """A name of a point or joint: a Latin letter, then letters, digits, ``_`` or ``'``."""

    def __init__(self, noun: str) -> None:
        self.noun = noun

    def read(self, value: object) -> str:
        """Return the name; raise UnitError with the character that does not belong there."""
        if not isinstance(value, str):
            raise UnitError(f"{show(value)} is not a name", f'write the name of a {self.noun} in quotes, such as "A"')
        if NAME.fullmatch(value):
            return value
        from tmmcalc.spec.cyrillic import stranger  # late: only faults need it

        raise UnitError(
            f"{show(value)} cannot name a {self.noun}{stranger(value)}",
            "a name is a Latin letter, then letters, digits, _ or '",
        )

    def describe(self) -> dict[str, Any]:
        """Return the JSON Schema of a name."""
        return {"type": "string", "pattern": NAME_PATTERN, "description": f"Name of a {self.noun}."}


class Words(Name):
    """A name of something that is named in tables and messages alone: words of Latin letters and digits."""

    PATTERN = "[A-Za-z][A-Za-z0-9_']*([ -][A-Za-z0-9_']+)*"

    def read(self, value: object) -> str:
        """Return the name; raise UnitError with the character that does not belong there."""
        if isinstance(value, str) and re.fullmatch(self.PATTERN, value):
            return value
        if not isinstance(value, str):
            return super().read(value)
        from tmmcalc.spec.cyrillic import stranger  # late: only faults need it

        remedy = "a name is words of Latin letters, digits, _ or ', with single spaces or hyphens between them"
        raise UnitError(f"{show(value)} cannot name a {self.noun}{stranger(value)}", remedy)

    def describe(self) -> dict[str, Any]:
        """Return the JSON Schema of a name."""
        return {"type": "string", "pattern": f"^{self.PATTERN}$", "description": f"Name of a {self.noun}."}


class Label(Reader):
    """A position of the grid: its number, or its label, such as ``"6'"`` for the first one added after 6."""

    PATTERN = "(0|[1-9][0-9]{0,6})'*"

    def read(self, value: object) -> str:
        """Return the label; raise UnitError if the value is none."""
        written = str(value) if isinstance(value, int) and not isinstance(value, bool) else value
        if not isinstance(written, str) or not re.fullmatch(self.PATTERN, written):
            raise UnitError(f"{show(value)} is not a position", 'write its number, such as 6, or its label: "6\'"')
        return written

    def describe(self) -> dict[str, Any]:
        """Return the JSON Schema: a whole number or a label."""
        kinds = [{"type": "integer", "minimum": 0}, {"type": "string", "pattern": f"^{self.PATTERN}$"}]
        return {"anyOf": kinds, "description": "Number or label of a position."}


PointName = Annotated[str, Name("point")]
PositionLabel = Annotated[str, Label()]
NamePair = Annotated[list[PointName], Field(min_length=2, max_length=2)]
