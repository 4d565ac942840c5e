"""``tmmcalc cam``: the group of commands for cams."""

from __future__ import annotations

from tmmcalc.cli.commands import CAM
from tmmcalc.cli.late import late_group

group = late_group(
    {"Commands": CAM},
    "tmmcalc cam synth my.toml",
    "Cams: laws of motion, sizes, profiles, forces, strength, the lowest mechanism.",
    add_completion=False,
)
