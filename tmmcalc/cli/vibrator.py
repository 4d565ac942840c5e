"""``tmmcalc vibrator``."""

from __future__ import annotations

from tmmcalc.cli.job import of_stage
from tmmcalc.cli.options import Columns, patterns_of
from tmmcalc.cli.output import Solved
from tmmcalc.report.document import Document


@of_stage("vibrator", "vibratory device")
def command(solved: Solved, columns: Columns = None) -> Document:
    """Vibratory assembly device: stiffnesses, natural frequencies and modes, resonance curve, steady motion, starts.

    A start by the motor tells whether the rotor passes its resonances or stays at one. The table shows the modes and
    some rows of the starts; --format csv, json or toml prints everything in SI.

    Example: tmmcalc vibrator my.toml --columns 't,omega,x,tilt_*'
    """
    return solved.document(patterns=patterns_of(columns), everything=solved.everything)
