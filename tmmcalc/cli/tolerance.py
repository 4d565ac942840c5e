"""``tmmcalc tolerance``."""

from __future__ import annotations

from enum import StrEnum
from pathlib import Path
from typing import Annotated

import typer

from tmmcalc.cli.messages import note_written, warn
from tmmcalc.cli.options import Form, Format, Jobs, Language, Quiet, Scheduler, Set, SpecFile, names_of
from tmmcalc.cli.output import check_apart, check_picture, check_place, draw_in, name, show, title
from tmmcalc.cli.progress import counted, seen


class Balance(StrEnum):
    """Rules of balanced tolerances, as `tmmcalc.design.tolerance.balance` has them, or none."""

    cost = "cost"
    share = "share"
    none = "none"


def command(
    spec: SpecFile,
    of: Annotated[
        list[str] | None,
        typer.Option(
            "--of",
            metavar="NAMES",
            help="Results by name, with wildcards: 'kinematics.stroke_*,forces.max(R_A)' (default: those of the "
            "constraints). May be repeated.",
            show_default=False,
        ),
    ] = None,
    band: Annotated[
        str | None,
        typer.Option(
            "--band",
            metavar="COLUMN",
            help="A column over the positions of a turn, for its band in the picture: 'kinematics.S_D'.",
            show_default=False,
        ),
    ] = None,
    samples: Annotated[
        int, typer.Option("--samples", metavar="N", min=32, max=1_000_000, help="At least so many; a power of two.")
    ] = 2**14,
    seed: Annotated[
        int, typer.Option("--seed", metavar="N", min=0, help="Of the samples: the same seed, the same.")
    ] = 1,
    picture: Annotated[
        Path | None,
        typer.Option(
            "--picture",
            metavar="FILE",
            help="Histograms and the band, by suffix svg, png, pdf or dxf.",
            show_default=False,
        ),
    ] = None,
    out: Annotated[
        Path | None,
        typer.Option(
            "-o",
            "--out",
            metavar="FILE",
            help="The samples, a CSV or FILE.parquet; what was stopped goes on from there.",
            show_default=False,
        ),
    ] = None,
    jobs: Jobs = None,
    scheduler: Scheduler = None,
    balance: Annotated[
        Balance,
        typer.Option(
            "--balance",
            help="All tolerances at once at the yield of before: at least cost, that of each as 1/tolerance, or of "
            "equal shares in the variance.",
        ),
    ] = Balance.cost,
    fresh: Annotated[bool, typer.Option("--fresh", help="Solve all samples, whatever is stored.")] = False,
    form: Form = Format.table,
    quiet: Quiet = False,
    language: Language = None,
    overrides: Set = None,
) -> None:
    """What the tolerances of the spec do to results: worst case, statistics, yield, shares of each dimension.

    The worst case is that by the signs of derivatives where these hold in the whole box, else it is searched, and told
    as such. Statistics are those of seeded quasi-random samples, with intervals of 95 %, beside the linear model; the
    yield is against [[constraints]].

    Example: tmmcalc tolerance my.toml --of kinematics.stroke_D --picture stroke.svg
    """
    if out is not None:
        from tmmcalc.batch.sheet import check_form

        check_place(out, "-o")
        check_form(out)
    if picture is not None:
        check_picture(picture, "--picture")
    check_apart(spec, out, picture)
    from tmmcalc.design.tolerance.document import tolerance_document
    from tmmcalc.design.tolerance.sampling import sizes
    from tmmcalc.design.tolerance.scene import Asked, tolerate
    from tmmcalc.project import load_spec

    asked = Asked(
        file=spec,
        overrides=tuple(overrides or ()),
        of=tuple(names_of(of, "--of")),
        band=band or "",
        samples=samples,
        seed=seed,
        jobs=jobs,
        scheduler=scheduler,
        out=out,
        fresh=fresh,
        balance={Balance.cost: "cost", Balance.share: "share", Balance.none: None}[balance],
    )
    scene = load_spec(spec, overrides or ())
    with seen(counted("samples", sizes(samples)), quiet) as told:
        result = tolerate(asked, lambda done: told(done, 0), warn)
    show(tolerance_document(result, title(scene, spec, "tolerances")), form)
    if picture is not None:
        from tmmcalc.design.tolerance.picture import tolerance_drawing

        draw_in(language, scene, picture, lambda: tolerance_drawing(result, name(scene, spec)))
    for file in (out, picture):
        if file is not None and not quiet:
            note_written(file)
