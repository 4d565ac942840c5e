"""``tmmcalc cam synth``."""

from __future__ import annotations

from typing import Annotated

import typer

from tmmcalc.cli.job import of_stage
from tmmcalc.cli.options import Format
from tmmcalc.cli.output import Solved
from tmmcalc.report.document import Document


@of_stage("cam_pressure", "synthesis of the cam", found="cam_synthesis")
def command(
    solved: Solved,
    candidates: Annotated[
        bool,
        typer.Option("--candidates", help="Print what every constraint alone asks of the size, instead."),
    ] = False,
) -> Document:
    """Sizes of the cam by its pressure angle, textbook and exact optimum side by side; the roller; the angle over phi.

    --format csv prints the pressure angle at all positions, json and toml the admissible region of the axis as well.
    --spec writes the spec with the sizes that were found.

    Example: tmmcalc cam synth my.toml --spec sized.toml
    """
    found = solved.run.results["cam_synthesis"]
    if candidates:
        from tmmcalc.cams.facts.size_candidates import candidates_document
        from tmmcalc.cams.synthesis.candidates import size_candidates

        each = size_candidates(solved.spec, solved.run.results)
        return candidates_document(found, each, solved.title, everything=solved.everything)
    from tmmcalc.cams.facts.cam_pressure import document as pressure_document
    from tmmcalc.cams.facts.cam_synthesis import document as synthesis_document

    sizes = synthesis_document(found, "synthesis", everything=solved.everything)
    angles = pressure_document(solved.result, "pressure angle", everything=solved.everything)
    table = angles.table if solved.form is Format.csv else None
    return Document(solved.title, table=table, parts=(sizes, angles))
