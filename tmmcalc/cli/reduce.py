"""``tmmcalc reduce``."""

from tmmcalc.cli.job import stage_command

command = stage_command(
    "reduction",
    """Reduction: reduced moment of every load, weights, springs and friction, reduced inertia, work per cycle.

    Example: tmmcalc reduce my.toml --columns 'phi,M_red*,J_red'
    """,
)
