"""``tmmcalc gears wheel``."""

from tmmcalc.cli.makers import summary_command

command = summary_command(
    "wheel",
    """A wheel without a mate: circles, limits of its shift, conditions, what is measured.

    gears measure has the limits of every span and the tooth on circles, gears profile the drawings and outlines.

    Example: tmmcalc gears wheel my.toml
    """,
    "a wheel without a mate",
    forms=True,
)
