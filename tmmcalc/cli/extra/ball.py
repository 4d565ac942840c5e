"""``tmmcalc extra ball``."""

from tmmcalc.cli.makers import stage_command

command = stage_command(
    "falling_ball",
    """Fall of a ball whose radius decreases: speed and way over the time, its maximum, its stop.

    Example: tmmcalc extra ball my.toml --columns 't,v,S'
    """,
    "falling ball",
)
