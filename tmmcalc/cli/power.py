"""``tmmcalc power``."""

from tmmcalc.cli.makers import summary_command

command = summary_command(
    "power",
    """Power: work per cycle by cause, efficiency, mean and peak power, and the motor, given or chosen.

    Example: tmmcalc power my.toml
    """,
)
