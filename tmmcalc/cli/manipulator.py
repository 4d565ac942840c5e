"""``tmmcalc manipulator``."""

from __future__ import annotations

from tmmcalc.cli.makers import stage_command

command = stage_command(
    "manipulator",
    """Manipulator: the joints that lead the gripper along its path, or the gripper that the joints lead.

    Singular places, passed limits and obstacles are told with their times. A row 4- is the limit before a jump there.

    Example: tmmcalc manipulator my.toml --columns 't,x,y,l_3,phi_2'
    """,
)
