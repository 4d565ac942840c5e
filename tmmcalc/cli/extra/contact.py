"""``tmmcalc extra contact``."""

from tmmcalc.cli.makers import stage_command

command = stage_command(
    "contact",
    """Elastic contact by boundary integral equations: pressure, approach, area; Hertz's solution as a check.

    The table shows the nodes on the axis of x; --format csv, json or toml prints all in SI.

    Example: tmmcalc extra contact my.toml --set contact.cells=40
    """,
    "elastic contact",
)
