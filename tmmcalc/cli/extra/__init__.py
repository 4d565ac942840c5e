"""``tmmcalc extra``: a group of commands."""

from __future__ import annotations

from tmmcalc.cli.late import late_group_of

group = late_group_of("extra")
