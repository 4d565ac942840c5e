"""``tmmcalc flywheel``."""

from tmmcalc.cli.job import summary_command

command = summary_command(
    "flywheel",
    """Flywheel: the one that keeps the allowed unevenness, by all methods side by side, its shaft and its rim.

    Example: tmmcalc flywheel my.toml
    """,
)
