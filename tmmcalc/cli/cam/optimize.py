"""``tmmcalc cam optimize``."""

from tmmcalc.cli.makers import summary_command

command = summary_command(
    "cam_optimum",
    """The lowest mechanism within all constraints: least height H2, start distance, roller, active constraints.

    Of a rocker it is the one with the least distance l0 of the centres: lengths of rocker and base circle, roller.

    Also the blocking contour with its corners, what relaxing a limit buys, and the laws, springs, materials and
    rollers compared that [cam.optimum] names. --format json and toml print all of it, with the borders of the contour.
    --spec writes the spec with the lowest mechanism in whole steps in the place of its search.

    Example: tmmcalc cam optimize my.toml --set cam.requirements.contact="450 MPa"
    """,
    "optimal design of the cam",
    forms=True,
    found=True,
)
