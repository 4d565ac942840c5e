"""What a law of a load tells of itself. A law is a record in a file of its own, a subclass of `Placed` that depends on
the position, or of `Resistance`, against a velocity; it provides

1. ``rank``, the place of its keys among those of ``[[loads]]``, and ``spec_keys``, these keys with their field types;
2. ``kind_of`` and ``from_table``: whether a load of that law is a force or a moment, and the law from its table;
3. its value ``along`` the motion, or the ``order`` of the speed that it goes with and its size ``against`` a velocity;
4. what is ``given`` of it in the task of a note, in the language in force;
5. where they are needed ``check`` for its faults beyond single values, ``check_kind``, ``cycle``, ``smooth``,
   ``counted``, ``judged``, ``alike``, ``turns``, and words for its keys: ``missing``, ``lists``, ``inline``.

A table in a CSV file is named in the manifest.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any, ClassVar, Literal, NamedTuple

from tmmcalc.core.records import record

if TYPE_CHECKING:
    from tmmcalc.report.manuscript import Datum
    from tmmcalc.spec.findings import Finding
    from tmmcalc.spec.outline import Outline, Raw
    from tmmcalc.spec.phrases import Path, Said

Kind = Literal["force", "moment"]


class Key(NamedTuple):
    """A key of ``[[loads]]``: its type without None, and its line in the docs."""

    annotation: Any
    description: str


class Coordinate(NamedTuple):
    """The coordinate of an output: what it is, and whether it is an angle."""

    said: str
    angular: bool


@record
class Called:
    """How a load is called where its law is told."""

    load: str  # “gas”
    key: str  # its value in formulas, ``Q_{gas}``
    index: str  # of the other letters of its law, ``Q,gas``
    kind: Kind
    turns: bool  # whether the input is a crank; else it is counted by its travel
    outputs: Mapping[str | None, Coordinate]  # of the mechanism by their names, the first one under None too
    windowed: bool  # whether it acts within a window, from whose beginning it may be counted
    against: int  # the link that it pushes against, or whose motion it resists; 0 for the frame

    @property
    def unit(self) -> str:
        """The unit of its value."""
        return "N" if self.kind == "force" else "N*m"


class Law:
    """A law of a load, see above."""

    rank: ClassVar[int]
    counted: ClassVar[bool] = False  # from the beginning of its window
    judged: ClassVar[bool] = True  # a resistance that drives on a part of the cycle is likely a fault

    missing: ClassVar[Mapping[str, Said]] = {}  # words for its keys, see `tmmcalc.project.words`
    lists: ClassVar[Mapping[str, Said]] = {}
    inline: ClassVar[Mapping[str, str]] = {}

    @classmethod
    def spec_keys(cls) -> Mapping[str, Key]:
        """Its keys in ``[[loads]]``."""
        raise NotImplementedError

    @classmethod
    def kind_of(cls, load: Raw, key: str) -> Kind | None:
        """Whether a raw load with this key is a force or a moment; None if that cannot be read."""
        raise NotImplementedError

    @classmethod
    def from_table(cls, load: Any, key: str) -> tuple[Kind, Law]:
        """ "force" or "moment", and the law of a checked table."""
        raise NotImplementedError

    def given(self, table: Any, called: Called) -> Iterator[Datum]:
        """What is given of it: the law and all its numbers."""
        raise NotImplementedError

    @classmethod
    def check_kind(cls, load: Raw, key: str, path: Path) -> Iterator[Finding]:
        """Faults in whether it is a force or a moment."""
        return iter(())

    @classmethod
    def check(cls, outline: Outline, load: Raw, path: Path) -> Iterator[Finding]:
        """Faults of a raw load with its key beyond single values."""
        return iter(())

    @classmethod
    def cycle(cls, load: Raw) -> float:
        """Angle after which a raw load repeats [rad]; 0: each turn."""
        return 0.0

    @classmethod
    def smooth(cls, load: Any) -> bool:
        """Whether monotone cubics run through the points of a checked table."""
        return False

    @property
    def turns(self) -> int:
        """Turns of the crank after which it repeats."""
        return 1

    @property
    def alike(self) -> bool:
        """Whether variants of such a load can be solved together."""
        return False


def kind_of_values(load: Raw, key: str) -> Kind | None:
    """What a raw table of values under ``force`` or ``moment`` is of."""
    values = load.get(key)
    named = {"force", "moment"} & {*values} if isinstance(values, dict) else set()
    return None if len(named) != 1 else "force" if "force" in named else "moment"


def values_of(table: Any) -> tuple[Kind, tuple[float, ...]]:
    """The values of a checked table under ``force`` or ``moment``."""
    return ("force", tuple(table.force)) if table.force is not None else ("moment", tuple(table.moment or ()))
