"""``tmmcalc extra bearing``."""

from tmmcalc.cli.stage import summary_command

command = summary_command(
    "bearing",
    "tmmcalc.extras.facts.extras:bearing_document",
    """Rolling bearing: speeds, frequencies of cage, raceways and rolling bodies, crest factors.

    Example: tmmcalc extra bearing my.toml
    """,
    "rolling bearing",
)
