"""``tmmcalc gears``: the group of commands for gears."""

from __future__ import annotations

from tmmcalc.cli.commands import GEARS
from tmmcalc.cli.late import late_group

group = late_group(
    {"Commands": GEARS},
    "tmmcalc gears synth my.toml",
    "Gears: tooth numbers of trains within all constraints, strength, pairs, contours, tooth profiles, measures.",
    add_completion=False,
)
