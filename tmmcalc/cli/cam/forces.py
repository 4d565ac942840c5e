"""``tmmcalc cam forces``."""

from tmmcalc.cli.makers import stage_command

command = stage_command(
    "cam_forces",
    """Forces on the follower: spring, reactions with friction, jamming, loss of contact, torque and work of the cam.

    N1 and N2 are the edges of the guide, T is P_c S' on the camshaft, M_drive what it has to give with friction.
    By name alone: place of the follower and its derivatives (S,S1,S2; of a rocker psi,psi1,psi2).

    Example: tmmcalc cam forces my.toml --columns "phi,P_c,R,T"
    """,
    "forces on the follower",
)
