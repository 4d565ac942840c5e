"""What a stage is: a pure function of plain inputs and upstream results, named by strings.

The pipeline knows a stage by this declaration alone. Its functions are given as ``"module:function"`` and
resolved at use, so a stage that does not run is never imported.

    spec --inputs--> plain values --solve--> result --dump--> Record --load--> result
                                             result --table--> Table

``load(dump(result))`` must give back everything that a later stage or a renderer reads, because this is
the only form in which a result is handed on, whether it has just been computed or comes from a file.
"""

from __future__ import annotations

from collections.abc import Callable, Container, Mapping
from dataclasses import field, replace
from importlib import import_module
from typing import TYPE_CHECKING, Any

from tmmcalc.records import record

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


@record
class Table:
    """Columns for people: ``header`` such as ``phi[deg]`` and one array of shape (n,) for each."""

    header: list[str]
    columns: list[np.ndarray[Any, Any]]

    @property
    def rows(self) -> int:
        """Number of rows; 0 for a table without columns."""
        return len(self.columns[0]) if self.columns else 0


@record
class Stage:
    """One stage of the pipeline; every function is a ``"module:function"`` string.

    ``wanted`` and ``spares`` are called while planning, also for scenes that leave the stage out: their module
    must import little.
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
