"""``tmmcalc extra reliability``."""

from tmmcalc.cli.makers import stage_command

command = stage_command(
    "reliability",
    """Reliability of a product whose strength falls while shock loads strike it: estimates, mean life, lives.

    Times and loads are in the units of the spec.

    Example: tmmcalc extra reliability my.toml --columns 't,R'
    """,
    "reliability",
)
