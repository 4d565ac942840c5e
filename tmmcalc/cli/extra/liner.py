"""``tmmcalc extra liner``."""

from tmmcalc.cli.makers import stage_command

command = stage_command(
    "liner",
    """Cylinder liner as ring and shell: forces between them, deflection, moment and stresses along the bore.

    Example: tmmcalc extra liner my.toml --columns 'x,w,M,sigma_*'
    """,
    "cylinder liner",
)
