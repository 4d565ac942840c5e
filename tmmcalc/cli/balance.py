"""``tmmcalc balance``."""

from tmmcalc.cli.makers import stage_command

command = stage_command(
    "balance",
    """Balance: shaking force and moment of the linkage, of an engine, of a rotor; counterweights and what they leave.

    Example: tmmcalc balance my.toml --columns 'phi,R,D_*'
    """,
)
