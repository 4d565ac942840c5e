"""``tmmcalc optimize``."""

from __future__ import annotations

from contextlib import ExitStack
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from tmmcalc.cli.found import Choose, Force, SpecOut, Target
from tmmcalc.cli.messages import note_written, warn
from tmmcalc.cli.options import Form, Format, Jobs, Language, Quiet, Scheduler, Set, SpecFile
from tmmcalc.cli.output import check_apart, check_picture, draw_in, name, show, title
from tmmcalc.cli.progress import seen, told_with
from tmmcalc.core.errors import UsageError

if TYPE_CHECKING:
    from tmmcalc.design.optimize.scene import Optimum
    from tmmcalc.project import Spec


def command(
    spec: SpecFile,
    spec_out: SpecOut = None,
    force: Force = False,
    choose: Choose = None,
    picture: Annotated[
        Path | None,
        typer.Option(
            "--picture",
            metavar="FILE",
            help="The front of designs, by suffix svg, png, pdf or dxf.",
            show_default=False,
        ),
    ] = None,
    jobs: Jobs = None,
    scheduler: Scheduler = None,
    fresh: Annotated[bool, typer.Option("--fresh", help="Solve all designs, whatever is stored.")] = False,
    form: Form = Format.table,
    quiet: Quiet = False,
    language: Language = None,
    overrides: Set = None,
) -> None:
    """The best design by [optimize] of the spec: variables, results that are to be least or greatest, constraints.

    All designs are solved where these are few; else evolution, then local search, and a second method beside it. What
    binds the best one is told with what it costs, and how flat it is. Several results give the front of designs of
    which none is better in all.

    --spec writes the spec with the design in the place of its numbers, of a front that of --choose; beside it stands
    what is solved, so that a search that was stopped goes on from there.

    Example: tmmcalc optimize my.toml --spec best.toml
    """
    target = Target(spec, spec_out, force, choose)
    target.check()
    if picture is not None:
        check_picture(picture, "--picture")
    check_apart(spec if not force else None, spec_out, picture)
    from tmmcalc.design.optimize.document import optimum_document
    from tmmcalc.design.optimize.scene import found_of, optimize
    from tmmcalc.project import load_spec
    from tmmcalc.project.found import settled_text
    from tmmcalc.report.rows import check_choice

    scene = load_spec(spec, overrides or ())
    _check(scene, choose, picture, fresh and spec_out is None)
    with ExitStack() as shown:
        told = shown.enter_context(seen(told_with("designs"), quiet))

        def use(result: Optimum) -> None:
            """Print it, write the spec, draw; before that the progress is taken away."""
            shown.close()
            check_choice(choose or 1, len(result.designs), "design")
            settled = settled_text(scene, spec_out, found_of(result, scene, choose)) if spec_out is not None else None
            show(optimum_document(result, title(scene, spec, "optimum"), form is Format.table), form)
            target.write(settled, quiet)
            if picture is not None:
                from tmmcalc.design.optimize.picture import front_drawing

                draw_in(language, scene, picture, lambda: front_drawing(result, name(scene, spec)))
                if not quiet:
                    note_written(picture)

        optimize(
            spec,
            overrides or (),
            out=spec_out,
            fresh=fresh,
            jobs=jobs,
            scheduler=scheduler,
            tell=warn,
            told=told,
            use=use,
        )


def _check(scene: Spec, choose: int | None, picture: Path | None, alone: bool) -> None:
    """Refuse what would come out after the search: a design or a picture that there cannot be, nothing to be fresh."""
    table = scene.optimize
    if alone:
        raise UsageError("nothing is stored without a file", where="--fresh", remedy="leave it out, or add --spec FILE")
    if table is None or len(table.least) + len(table.greatest) > 1:
        return
    if choose is not None and choose > 1:
        raise UsageError("one result is sought: there is one design", where="--choose", remedy="leave it out")
    if picture is not None:
        raise UsageError("one result is sought: there is no front to draw", where="--picture", remedy="leave it out")
