"""``tmmcalc flywheel``."""

from tmmcalc.cli.job import summary_command

command = summary_command(
    "flywheel",
    """Flywheel: the one that keeps the allowed unevenness, by all methods side by side, its shaft and its rim.

    --spec writes the spec with its inertia in the place of the unevenness.

    Example: tmmcalc flywheel my.toml
    """,
    found=True,
)
