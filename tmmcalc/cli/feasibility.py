"""``tmmcalc feasibility``."""

from __future__ import annotations

from tmmcalc.cli.stage import summary_command

command = summary_command(
    "feasibility",
    "tmmcalc.report.feasibility:feasibility_document",
    """Constraints on results: which hold, by how much, and whether the rule of [feasibility] does.

    With --strict a constraint that fails ends with exit code 5.

    Example: tmmcalc feasibility my.toml --strict
    """,
)
