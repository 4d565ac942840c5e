"""What a run found of one stage, as programs and notebooks take it: by name, as a frame, as a summary, as a picture."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.errors import UsageError
from tmmcalc.core.facts import named
from tmmcalc.core.stage import STAGES
from tmmcalc.naming.language import Name, parse
from tmmcalc.naming.scene import Scene
from tmmcalc.naming.told import one
from tmmcalc.report.document import Document
from tmmcalc.report.worksheets import values_of


class StageResult:
    """One stage of a run: ``result.kinematics``.

    An attribute is that of the record that the stage gives out, see `record`; else what the stage tells under this
    name: ``result.kinematics.stroke_D``, ``result.forces.R_A`` (n,). An index is any name of the language of results:
    ``result.forces["max(R_A)"]``.
    """

    def __init__(self, stage: str, spec: Any, results: Mapping[str, Any]) -> None:
        self._stage = stage
        self._scene = Scene(spec, results)

    @property
    def record(self) -> Any:
        """What the stage gives out, a frozen record of numpy arrays."""
        return self._scene.results[self._stage]

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):  # of those of a record none does; notebooks ask for what there may be
            raise AttributeError(name)
        if hasattr(self.record, name):
            return getattr(self.record, name)
        told = {key: value for fact in self._document.facts for key, value, _ in values_of(fact)}
        if name in told:
            return told[name]
        try:
            return self[name]
        except UsageError as error:
            raise AttributeError(str(error)) from None

    def __getitem__(self, name: str) -> float | NDArray[np.float64]:
        """The value of a name, with or without the stage before it; of a column alone its values (n,).

        Raises `UsageError` with the nearest names for one that names nothing.
        """
        return value_of(parse(name)._replace(stage=self._stage), self._scene)

    def __dir__(self) -> list[str]:
        fields = [name for name in dir(self.record) if not name.startswith("_")]
        return sorted({*super().__dir__(), *fields})

    def __repr__(self) -> str:
        return f"<{self._stage}: {STAGES[self._stage].title}>"

    def to_frame(self, library: str | None = None) -> Any:
        """The table of the stage as a frame of ``pandas`` or ``polars`` (None: of the first that is installed).

        Its columns have the headers of the CSV, ``phi[deg]``. Raises `UsageError` for a stage without a table, and
        where the library is not installed.
        """
        from tmmcalc.report.frames import frame

        table = STAGES[self._stage].table(self.record)
        if table is None:
            raise UsageError(
                f"{self._stage} has no table", where="to_frame", remedy="the frame of the run has all its values"
            )
        return frame(dict(zip(table.header, table.columns, strict=True)), library)

    @property
    def _document(self) -> Document:
        return STAGES[self._stage].summary(self.record, self._stage)

    def _repr_html_(self) -> str:
        from tmmcalc.report.markup import html

        return html(self._document)

    def _repr_svg_(self) -> str | None:
        from tmmcalc.pipeline.picturing import svg_of

        return svg_of(self._stage, self._scene.spec, self._scene.results)


def value_of(name: Name, scene: Scene) -> float | NDArray[np.float64]:
    """The value of a name; of a column that is asked for nothing its values (n,). Raises as `one`."""
    try:
        return one(name, scene.results, scene).value
    except UsageError:
        values = _column(name, scene) if name.fact and not name.wild else None
        if values is None:
            raise
        return values


def _column(name: Name, scene: Scene) -> NDArray[np.float64] | None:
    """The column of a name; None if none has it, or several."""
    found = []
    for stage in (name.stage,) if name.stage else scene.results:
        table = scene.table(stage) if stage in scene.results else None
        for header in table.headers if table is not None else ():
            column, unit = named(header)
            if table is not None and name._replace(stage="").fits(Name("", "", column, unit=unit)):
                found.append(np.asarray(table.column(header), float))
    return found[0] if len(found) == 1 else None
