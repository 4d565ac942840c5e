"""``tmmcalc class``: a group of commands."""

from __future__ import annotations

from tmmcalc.cli.deferred import deferred_group_of

group = deferred_group_of("class")
