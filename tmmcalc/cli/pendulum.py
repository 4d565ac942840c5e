"""``tmmcalc pendulum``."""

from __future__ import annotations

from tmmcalc.cli.job import of_stage
from tmmcalc.cli.options import Columns, patterns_of
from tmmcalc.cli.output import Solved
from tmmcalc.report.document import Document


@of_stage("pendulum", "pendulum-rotor")
def command(solved: Solved, columns: Columns = None) -> Document:
    """Pendulum-rotor: natural frequencies and whirl, critical speeds, torsion, Campbell diagram, motion in time.

    The table shows the modes and some rows of diagram and motion; --format csv, json or toml prints everything in SI.

    Example: tmmcalc pendulum my.toml --set pendulum.spin="'900 rpm'"
    """
    return solved.document(patterns=patterns_of(columns), everything=solved.everything)
