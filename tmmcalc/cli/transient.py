"""``tmmcalc transient``."""

from tmmcalc.cli.stage import summary_command

command = summary_command(
    "transient",
    "tmmcalc.report.transient:transient_document",
    """Transient: start-up, braking, run-down and load changes in time, of one mass or of an elastic drive.

    Example: tmmcalc transient my.toml
    """,
)
