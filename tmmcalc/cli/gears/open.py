"""``tmmcalc gears open``."""

from tmmcalc.cli.makers import summary_command

command = summary_command(
    "open_pair",
    """The open pair between the reducer and the crank: ratio, efficiency, inertia, torques, forces, stresses.

    Its geometry and its checks are those of gears pair, under the name open pair.

    Example: tmmcalc gears open my.toml
    """,
    "open pair on the crank",
)
