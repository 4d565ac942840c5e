"""``tmmcalc unsteady``."""

from __future__ import annotations

from tmmcalc.cli.makers import stage_command

command = stage_command(
    "unsteady",
    """Unsteady motion: the input goes from rest to rest by the time-optimal law; all links over the time.

    A row 4- is the limit before a jump of the acceleration at row 4.

    Example: tmmcalc unsteady my.toml --columns 't,x,v,a,omega_*,eps_*'
    """,
)
