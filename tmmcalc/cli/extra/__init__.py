"""``tmmcalc extra``: the group of small calculators of neighbouring fields."""

from __future__ import annotations

from tmmcalc.cli.commands import EXTRA
from tmmcalc.cli.late import late_group

group = late_group(
    {"Commands": EXTRA},
    "tmmcalc extra contact my.toml",
    "Small calculators: elastic contact, reliability, tie-down of loads, a falling ball, rolling bearings.",
    add_completion=False,
)
