"""What a run gives back in Python: stages as attributes, numbers by name, frames, workbooks, notebooks."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from tmmcalc.api.stageresult import StageResult, value_of
from tmmcalc.core.printable import printable
from tmmcalc.naming.language import Name, parse
from tmmcalc.naming.scene import Scene
from tmmcalc.naming.told import Told, listed, one, told
from tmmcalc.pipeline.outcome import RunResult
from tmmcalc.report.document import Document


class Run(RunResult):
    """One run of the pipeline.

    A stage is an attribute: ``run.kinematics``, see `StageResult`. An index is a name of the language of results:
    ``run["forces.max(R_A)"]`` is a number, ``run["forces.R_A"]`` a column (n,), ``run["forces"]`` the stage.
    """

    def __getattr__(self, stage: str) -> StageResult:
        outcomes = self.__dict__.get("outcomes", {})  # none while a copy is made
        if stage in outcomes:
            return self._stage(stage)
        failure = self.__dict__.get("failures", {}).get(stage)
        if failure is not None:
            raise AttributeError(f"{stage} has no result: {failure}")
        raise AttributeError(f"this run has no stage {stage!r}; it has {', '.join(outcomes)}")

    def __getitem__(self, name: str) -> Any:
        """A stage, the value of a name, or the values (n,) of a column; raises `UsageError` for what names nothing."""
        return self._stage(name) if name in self.outcomes else value_of(parse(name), self._scene)

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self.outcomes]

    def _stage(self, name: str) -> StageResult:
        return StageResult(name, self.spec, self.results)

    @property
    def _scene(self) -> Scene:
        return Scene(self.spec, self.results)

    def tell(self, name: str) -> Told:
        """The one quantity of a name, with its unit, its meaning and how it was found.

        Raises `UsageError` with the nearest names for one that names nothing.
        """
        return one(parse(name), self.results, self._scene)

    def value(self, name: str) -> float:
        """The number of a name, such as ``kinematics.vS_D[phi=45 deg]``; raises as `tell`."""
        return self.tell(name).value

    def names(self, *patterns: str) -> list[str]:
        """Names of facts and columns, with their units: all, or those under patterns such as ``motion.*``."""
        asked = [parse(pattern) for pattern in patterns]
        found: dict[str, None] = {}
        for stage in self.outcomes:
            for each in listed(stage, self.results[stage]):
                name = Name(stage, "", each.quantity, unit=each.unit)
                if not asked or any(own.fits(name) for own in asked):
                    found[f"{name.text}[{each.unit}]" if each.unit else name.text] = None
        if asked:
            found |= dict.fromkeys(each.key for each in told(self.results, asked, self._scene))
        return list(found)

    def to_frame(self, library: str | None = None) -> Any:
        """Every fact as a row of a frame of ``pandas`` or ``polars``: stage, name, symbol, value, unit, meaning.

        Without a library it is of the first that is installed; raises `UsageError` where none is. Tables are frames of
        the stages: ``run.kinematics.to_frame()``.
        """
        from tmmcalc.report.frames import frame

        facts = [*told(self.results, ())]
        fields = {"stage": "stage", "name": "quantity", "symbol": "symbol", "value": "value", "unit": "unit"}
        fields["meaning"] = "meaning"
        return frame({header: [getattr(fact, field) for fact in facts] for header, field in fields.items()}, library)

    def to_xlsx(self, file: str | Path, *, csv: bool | None = None) -> None:
        """Write a workbook: what is given, what is told, and a sheet for the table of every stage.

        ``csv`` True takes tables of any length, None up to as many rows as a CSV has. Raises `UsageError` where
        XlsxWriter is not installed, for more than a workbook can hold, and for a file that cannot be written.
        """
        from tmmcalc.core.atomic import replace_file
        from tmmcalc.pipeline.workbook import run_sheets
        from tmmcalc.report.workbook import workbook

        replace_file(Path(file), workbook(run_sheets(self, csv), self._title))

    @property
    def _title(self) -> str:
        return printable(self.spec.project.title or "run")

    def _repr_html_(self) -> str:
        from tmmcalc.report.markup import html

        parts = tuple(each.stage.summary(self.results[name], name) for name, each in self.outcomes.items())
        failed = (f"{stage} failed: {error}" for stage, error in self.failures.items())
        return html(Document(self._title, notes=(*self.told, *failed), parts=parts))

    def _repr_svg_(self) -> str | None:
        """The picture of the stage that was asked for, else of the first that has one; None as of a stage."""
        drawn = [name for name, each in self.outcomes.items() if each.stage.picture is not None]
        asked = self.plan.target if self.plan.target in drawn else next(iter(drawn), None)
        return self._stage(asked)._repr_svg_() if asked is not None else None
