"""``tmmcalc extra transloader``."""

from tmmcalc.cli.makers import summary_command

command = summary_command(
    "transloader",
    """Grab transloader: speeds and accelerations with their limits, inertia and wind, loads by case, allowed stresses.

    Example: tmmcalc extra transloader my.toml --set transloader.factors="'product'"
    """,
    "grab transloader",
    forms=True,
)
