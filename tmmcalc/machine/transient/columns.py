"""The columns of the table of motions in time.

theta_1 omega_1 alpha_1   angle, speed and acceleration of the first mass, the motor's; a single mass has no number
M_1_2                     moment of the shaft between the masses 1 and 2, positive towards the crank
M_motor M_load            moments of the motor on its shaft, of the load on the crank; load_factor U
T V                       kinetic and elastic energy
step_error                estimated in each step, as Merson prints it; 0 of methods that estimate nothing
"""

from __future__ import annotations

from functools import partial

from tmmcalc.core.columns import Column
from tmmcalc.machine.transient.timed import TimedMotion


def timed_columns(motion: TimedMotion) -> list[Column]:
    """All columns of a motion in time in their usual order."""
    columns = [Column("t", "s", lambda: motion.t)]
    for k in range(len(motion.masses)):
        mark = f"_{k + 1}" if len(motion.masses) > 1 else ""
        columns += [
            Column(f"theta{mark}", "rad", partial(motion.theta.__getitem__, k)),
            Column(f"omega{mark}", "rad/s", partial(motion.omega.__getitem__, k)),
            Column(f"alpha{mark}", "rad/s^2", partial(motion.alpha.__getitem__, k)),
        ]
    for k in range(len(motion.masses) - 1):
        columns.append(Column(f"M_{k + 1}_{k + 2}", "N*m", partial(motion.shaft_moment.__getitem__, k)))
    columns += [
        Column("M_motor", "N*m", lambda: motion.motor_moment),
        Column("M_load", "N*m", lambda: motion.load_moment),
        Column("load_factor", "-", lambda: motion.load_factor),
        Column("T", "J", lambda: motion.kinetic),
        Column("V", "J", lambda: motion.elastic),
    ]
    errors = motion.step_error
    columns.append(Column("step_error", "-", lambda: errors if errors is not None else 0.0 * motion.t))
    return columns
