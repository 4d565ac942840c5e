"""``tmmcalc forces``."""

from tmmcalc.cli.stage import stage_command

command = stage_command(
    "forces",
    "tmmcalc.report.forces:forces_document",
    """Forces: reactions in all pairs, with friction where the pairs have it, and what the drive must apply.

    Example: tmmcalc forces my.toml --columns 'phi,M_drive,R_*' --positions 0:12:2
    """,
)
