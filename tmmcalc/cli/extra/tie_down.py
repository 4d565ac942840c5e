"""``tmmcalc extra tie-down``."""

from tmmcalc.cli.makers import stage_command

command = stage_command(
    "tie_down",
    """Forces in the ties of a load that its inertia moves: R, the opposite ties, the best elevation;
    their stress, and from which inertia on the load slips, ties slacken or yield, the load tips.

    Example: tmmcalc extra tie-down my.toml --set tie_down.elevation="'25 deg'"
    """,
    "tie-down of a load",
)
