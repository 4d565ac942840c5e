"""``tmmcalc cam elastic``."""

from tmmcalc.cli.makers import summary_command

command = summary_command(
    "cam_elastic",
    """Vibration of the follower as one mass on an elastic train: residual after the phases, steady over the turn.

    The table compares laws by what they leave; --format csv prints the motion of the mass over the turn.

    Example: tmmcalc cam elastic my.toml
    """,
    "elastic follower",
    forms=True,
)
