"""``--spec FILE``: the same spec with what a stage found in its place, checked and written in one step."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from tmmcalc.cli.messages import say
from tmmcalc.cli.output import check_place
from tmmcalc.core.errors import UsageError
from tmmcalc.core.records import record

if TYPE_CHECKING:
    from tmmcalc.project import Spec
    from tmmcalc.project.found import Settled

MARK = b"\xef\xbb\xbf"  # with which some editors begin a file

SpecOut = Annotated[
    Path | None,
    typer.Option("--spec", metavar="FILE", help="Write the spec with what was found in its place.", show_default=False),
]
Force = Annotated[bool, typer.Option("--force", help="Replace the file of --spec if it exists, also the spec itself.")]
Choose = Annotated[
    int | None,
    typer.Option("--choose", metavar="N", min=1, help="Row N, from 1, that --spec writes.", show_default=False),
]


@record
class Target:
    """The file of ``--spec``, if it is asked for, and which of several solutions it is to have."""

    source: Path  # the spec itself
    file: Path | None = None
    force: bool = False
    choose: int | None = None

    def check(self) -> None:
        """Refuse what would only come out after the computation: no place for a file, or one that is there."""
        if self.file is None:
            if self.force:
                raise UsageError("there is no file to replace", where="--force", remedy="add --spec FILE")
            if self.choose is not None:
                raise UsageError("there is no file to write it to", where="--choose", remedy="add --spec FILE")
            return
        check_place(self.file, "--spec")
        if self.file.exists() and not self.force:
            raise UsageError(f"{self.file} exists", where="--spec", remedy="choose another name, or use --force")

    def made(self, spec: Spec, stage: str, result: Any) -> Settled | None:
        """The new spec with what a stage found; None if none is asked for. Raises what is wrong with it."""
        if self.file is None:
            return None
        from tmmcalc.project.found import settled_text
        from tmmcalc.rooms import STAGES

        found = STAGES[stage].part("found")(spec, result, self.choose)
        return settled_text(spec, self.file, found)

    def write(self, settled: Settled | None, quiet: bool) -> None:
        """Write it, whole or not at all, and say what was put where."""
        if self.file is None or settled is None:
            return
        from tmmcalc.core.atomic import replace_file

        now = self.source.read_bytes()
        mark = MARK if now.startswith(MARK) else b""
        if self.file.resolve() == self.source.resolve() and now.removeprefix(MARK).decode() != settled.of:
            rule = f"{self.file} has changed since it was read"
            raise UsageError(rule, where="--spec", remedy="run the command again, or choose another name")
        replace_file(self.file, mark + settled.text.encode())
        if not quiet:
            lines = settled.told or ("nothing is changed: the spec has all of it",)
            say("\n".join([f"wrote {self.file}", *(f"  {line}" for line in lines)]), "dim")
