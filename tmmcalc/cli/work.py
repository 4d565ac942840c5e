"""What every stage command does around its one call: spec in, pipeline, files, warnings, document out."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tmmcalc.cli.messages import say, show_event
from tmmcalc.cli.options import Format
from tmmcalc.errors import LimitError

if TYPE_CHECKING:
    from tmmcalc.pipeline.outcome import RunResult
    from tmmcalc.report.document import Document
    from tmmcalc.spec import Spec


@dataclass(frozen=True)
class Job:
    """The flags that all stage commands share."""

    file: Path
    out: Path | None = None
    store: bool = True
    fresh: bool = False
    from_stage: str | None = None
    csv: bool | None = None
    depfile: Path | None = None
    strict: bool = False
    quiet: bool = False
    overrides: Sequence[str] = ()
    settings: Mapping[str, Mapping[str, Any]] = field(default_factory=dict)

    def spec(self) -> Spec:
        """Read the spec with its overrides."""
        from tmmcalc.spec import load_spec

        return load_spec(self.file, self.overrides)

    @property
    def folder(self) -> Path | None:
        """Where the stage files go; None if nothing is stored."""
        if not self.store:
            return None
        return self.out or Path(f"{self.file.stem}.out")

    def run(self, spec: Spec, target: str | None) -> RunResult:
        """Run the pipeline with messages on standard error, and write the depfile."""
        from tmmcalc.pipeline.runner import run

        result = run(
            spec,
            target=target,
            out=self.folder,
            fresh=self.fresh,
            from_stage=self.from_stage,
            csv=self.csv,
            settings=self.settings,
            on_event=None if self.quiet else show_event,
        )
        if self.depfile is not None:
            from tmmcalc.pipeline.depfile import write

            write(self.depfile, result.files, [self.file])
        return result

    def check_limits(self, warnings: Sequence[str]) -> None:
        """Say the warnings; under ``strict`` they are the end of the run."""
        if warnings and self.strict:
            raise LimitError("\n  ".join(warnings), where="--strict", remedy="mend the causes, or leave --strict out")


def title(spec: Spec, file: Path, what: str) -> str:
    """Heading of a document."""
    return f"{spec.project.title or file.stem}: {what}"


def show(document: Document, form: Format) -> None:
    """Print a document to standard output."""
    from tmmcalc.report.render import render

    render(document, form.value)


def note_files(result: RunResult, quiet: bool) -> None:
    """Say where the files are."""
    if result.files and not quiet:
        say(f"files: {', '.join(str(file) for file in result.files)}", "dim")
