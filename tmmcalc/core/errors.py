"""All errors of the program, one exit code a class.

    TmmError                what the user can mend; never shown with a traceback
    ├── UsageError      2   a wrong flag, a missing file, a missing extra
    ├── SpecError       2   faults of the project spec, all of them at once
    ├── StructureError  3   mobility is not 1, or a group that cannot be solved
    ├── AssemblyError   3   the links do not reach: no such position
    ├── SingularityError 3  a dead point: positions exist, velocities do not
    ├── NoSolutionError 3   the question has no answer for this mechanism
    ├── AccuracyError   4   the asked accuracy or convergence was not reached
    └── LimitError      5   a limit was exceeded and ``--strict`` is on

Exit code 0 is success, 1 a fault of the program itself (with its traceback).
A message says where, the value, the rule it breaks, and what to change.
"""

from __future__ import annotations

from tmmcalc.core.records import record


class TmmError(Exception):
    """Base of every error that a user can cause and mend.

    ``where`` names the stage, group and angle; ``value`` and ``limit`` are the numbers compared;
    ``remedy`` says what to change. The text is built from them.
    """

    exit_code = 1

    def __init__(
        self,
        message: str,
        *,
        where: str = "",
        value: float | None = None,
        limit: float | None = None,
        remedy: str = "",
    ) -> None:
        self.message = message
        self.where = where
        self.value = value
        self.limit = limit
        self.remedy = remedy
        super().__init__(message)

    def __str__(self) -> str:
        text = f"{self.where}: {self.message}" if self.where else self.message
        return f"{text}\n  -> {self.remedy}" if self.remedy else text


class UsageError(TmmError):
    """A wrong flag, an unreadable file, a missing extra."""

    exit_code = 2


@record
class Fault:
    """One fault of a spec: where it stands, what is wrong, what to write instead."""

    path: str  # TOML path such as ``mechanism.links[2].mass``
    line: int | None  # 1-based line of the source, None if the source is unknown
    message: str
    remedy: str = ""
    column: int | None = None  # 1-based, where the line has one

    def __str__(self) -> str:
        return self.told("")

    def told(self, file: str) -> str:
        """The text of the fault with its place, which editors follow: ``my.toml:12:5: path: message``."""
        place = ":".join(str(part) for part in (file, self.line, self.column) if part) if self.line else ""
        text = ": ".join(part for part in (place, self.path, self.message) if part)
        return f"{text}\n    -> {self.remedy}" if self.remedy else text


class SpecError(TmmError):
    """The faults of one project spec, all at once, in the order of their lines; the text has the first of very many."""

    exit_code = 2
    SHOWN = 50  # faults in the text

    def __init__(self, file: str, faults: list[Fault]) -> None:
        self.file = file
        self.faults = sorted(faults, key=lambda f: (f.line is None, f.line or 0))
        count = f"{len(faults)} fault{'s' if len(faults) != 1 else ''}"
        lines = [f"  {fault.told(file)}" for fault in self.faults[: self.SHOWN]]
        if len(faults) > self.SHOWN:
            lines.append(f"  and {len(faults) - self.SHOWN} more: mend these first")
        super().__init__("\n".join((f"{file}: {count}", *lines)))


class StructureError(TmmError):
    """The links and joints are not a mechanism of mobility 1, or hold a group that is not solvable yet."""

    exit_code = 3


class AssemblyError(TmmError):
    """The links of a group do not reach each other at some position of the input link."""

    exit_code = 3


class SingularityError(TmmError):
    """A dead point: the position is defined, its velocities are not."""

    exit_code = 3


class NoSolutionError(TmmError):
    """The question asked has no answer for this mechanism."""

    exit_code = 3


class AccuracyError(TmmError):
    """The accuracy or convergence asked for was not reached."""

    exit_code = 4


class LimitError(TmmError):
    """A graded warning that ``--strict`` turns into a failure."""

    exit_code = 5
