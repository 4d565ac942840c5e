"""``tmmcalc dyad``."""

from tmmcalc.cli.makers import summary_command

command = summary_command(
    "dyad",
    """A dyad with given states of its outer joints: angles, speeds and accelerations of both links, points.

    Example: tmmcalc dyad my.toml --set dyad.variant=1
    """,
)
