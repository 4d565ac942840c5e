"""``tmmcalc cam law``."""

from tmmcalc.cli.job import stage_command

command = stage_command(
    "cam_law",
    """Motion of the follower over the turn: displacement and derivatives, constants of the laws, extremes, shocks.

    The table is in mm; --format csv, json or toml prints metres. A row 6- is the limit before a jump at position 6.

    Example: tmmcalc cam law my.toml --columns "phi,S*"
    """,
    "law of motion",
)
