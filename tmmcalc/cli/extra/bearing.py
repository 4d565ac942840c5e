"""``tmmcalc extra bearing``."""

from tmmcalc.cli.makers import summary_command

command = summary_command(
    "bearing",
    """Rolling bearing: speeds, frequencies of cage, raceways and rolling bodies, crest factors.

    Example: tmmcalc extra bearing my.toml
    """,
    "rolling bearing",
)
