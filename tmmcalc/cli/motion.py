"""``tmmcalc motion``."""

from tmmcalc.cli.job import stage_command

command = stage_command(
    "motion",
    """Motion: the steady motion of the machine under its motor, or under a constant driving moment.

    Example: tmmcalc motion my.toml --columns 'phi,omega*' --positions 0:24:4
    """,
)
