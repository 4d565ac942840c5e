"""``tmmcalc extra tie-down``."""

from tmmcalc.cli.job import summary_command

command = summary_command(
    "tie_down",
    """Forces in the ties of a load that its inertia moves: R, the opposite ties, the best elevation.

    Example: tmmcalc extra tie-down my.toml --set tie_down.elevation="'25 deg'"
    """,
    "tie-down of a load",
)
