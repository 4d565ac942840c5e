"""What a stage is: a pure function of plain inputs and upstream results, named by strings.

The pipeline knows a stage by this declaration alone. Its functions are given as ``"module:function"`` and
resolved at use, so a stage that does not run is never imported.

    spec --inputs--> plain values --solve--> result --dump--> Record --load--> result
                                             result --table--> Table

``load(dump(result))`` must give back everything that a later stage or a renderer reads, because this is
the only form in which a result is handed on, whether it has just been computed or comes from a file.
"""

from __future__ import annotations

from collections.abc import Callable, Container, Mapping, Sequence
from dataclasses import field, replace
from fnmatch import fnmatchcase
from importlib import import_module
from typing import TYPE_CHECKING, Any, overload

from tmmcalc.core.records import record

if TYPE_CHECKING:
    import numpy as np


@record
class Record:
    """The stored form of a result: values for TOML and arrays for npz.

    ``scalars``, ``error`` and ``counters`` may hold floats, integers, strings, booleans, lists and dicts
    with string keys; numpy scalars and tuples are converted. A table keeps the order of its keys, except
    that values come before sub-tables.
    """

    scalars: Mapping[str, Any] = field(default_factory=dict)
    arrays: Mapping[str, np.ndarray[Any, Any]] = field(default_factory=dict)
    error: Mapping[str, Any] = field(default_factory=dict)  # error estimate
    counters: Mapping[str, Any] = field(default_factory=dict)  # steps, iterations, evaluations


class Late(Sequence["np.ndarray[Any, Any]"]):
    """Columns of a table, each an array (n,) or what makes it when asked for: no long table is made whole."""

    def __init__(self, makers: Sequence[np.ndarray[Any, Any] | Callable[[], np.ndarray[Any, Any]]]) -> None:
        self._makers = makers

    def __len__(self) -> int:
        return len(self._makers)

    @overload
    def __getitem__(self, k: int) -> np.ndarray[Any, Any]: ...
    @overload
    def __getitem__(self, k: slice) -> Sequence[np.ndarray[Any, Any]]: ...
    def __getitem__(self, k: int | slice) -> Any:
        if isinstance(k, slice):
            return Late(self._makers[k])
        maker = self._makers[k]
        return maker() if callable(maker) else maker

    def those(self, chosen: Sequence[int]) -> Late:
        """Some of them; none is made."""
        return Late([self._makers[k] for k in chosen])


@record
class Table:
    """Columns for people: ``header`` such as ``phi[deg]`` and one array of shape (n,) for each.

    The first column says what a row is.
    """

    header: list[str]
    columns: Sequence[np.ndarray[Any, Any]]

    @property
    def rows(self) -> int:
        """Number of rows; 0 for a table without columns."""
        return len(self.columns[0]) if self.columns else 0

    def selected(self, patterns: Sequence[str]) -> Table | None:
        """The first column and those whose names, or headers, match; None if none does; all without patterns."""
        if not patterns:
            return self
        kept = [k for k, header in enumerate(self.header) if any(matches(header, pattern) for pattern in patterns)]
        if not kept:
            return None
        kept = sorted({0, *kept})
        own = self.columns
        chosen = own.those(kept) if isinstance(own, Late) else [own[k] for k in kept]
        return Table([self.header[k] for k in kept], chosen)


def matches(header: str, pattern: str) -> bool:
    """Whether a pattern such as ``x_*`` names a column.

    >>> matches("x_C[m]", "x_*"), matches("x_C[m]", "x_C[m]"), matches("x_C[m]", "C")
    (True, True, False)
    """
    return header == pattern or fnmatchcase(header.partition("[")[0], pattern)


@record
class Stage:
    """One stage of the pipeline; every function is a ``"module:function"`` string.

    ``wanted`` and ``spares`` are called while planning, also for scenes that leave the stage out: their module
    must import little. ``omits`` and ``packages`` are called of stages that run, and only by who asks why.
    """

    name: str
    title: str  # one line for the plan
    inputs: str  # (spec) -> plain values that the stage reads: exactly these are hashed
    solve: str  # (inputs, {upstream name: result}, settings) -> result
    dump: str  # (result) -> Record
    load: str  # (Record) -> result
    table: str = ""  # (result) -> Table | None; empty: the stage has no table
    wanted: str = ""  # (spec) -> None, or the reason why the scene leaves the stage out; empty: always wanted
    needs: tuple[str, ...] = ()  # the stages whose results it reads
    uses: tuple[str, ...] = ()  # the stages whose results it reads if the scene has them
    spares: str = ""  # (spec) -> those of ``uses`` that it does without in this scene; empty: none
    omits: str = ""  # (spec) -> sentences on what it leaves out within itself, because the scene has it not
    packages: str = ""  # (spec) -> heavy packages that it imports for this scene; empty: none
    settings: Mapping[str, Any] = field(default_factory=dict)  # options of the method and their defaults

    def upstream(self, done: Container[str]) -> list[str]:
        """The stages whose results it reads, of those that are done."""
        return [*self.needs, *(name for name in self.uses if name in done)]


def of_scene(stages: Mapping[str, Stage], spec: object) -> dict[str, Stage]:
    """The stages as this scene has them: with those of ``uses`` alone that each reads."""
    return {name: _of_scene(stage, spec) if stage.spares else stage for name, stage in stages.items()}


def _of_scene(stage: Stage, spec: object) -> Stage:
    spared = resolve(stage.spares)(spec)
    return replace(stage, uses=tuple(name for name in stage.uses if name not in spared))


def resolve(reference: str) -> Callable[..., Any]:
    """Return the function that ``"module:function"`` names, importing its module.

    >>> resolve("math:hypot")(3.0, 4.0)
    5.0
    """
    module, _, name = reference.partition(":")
    function: Callable[..., Any] = getattr(import_module(module), name)
    return function
