"""Which heavy packages the stages that run import for a scene, for ``plan --why``: a third of a second each time.

The ordinary scene needs none. matplotlib is imported by ``tmmcalc plot`` and ``--plot`` alone, joblib by ``sweep``.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tmmcalc.project import Spec

Packages = tuple[str, ...]

INTERPOLATE, OPTIMIZE, SPECIAL = "scipy.interpolate", "scipy.optimize", "scipy.special"
INTEGRATE = "scipy.integrate"
OWN = ("merson", "rk4", "collocation", "auto")  # methods of integration that are the program's own


def forces(spec: Spec) -> Packages:
    """Monotone cubics through the points of a load."""
    curves = (load.table for load in spec.loads)
    return (INTERPOLATE,) if any(c is not None and c.interpolation == "pchip" for c in curves) else ()


def reduction(spec: Spec) -> Packages:
    """As of the forces; and of the points of a torque diagram."""
    curve = spec.torque.table if spec.torque is not None else None
    return (INTERPOLATE,) if curve is not None and curve.interpolation == "pchip" else forces(spec)


def motion(spec: Spec) -> Packages:
    """Monotone cubics through the points of a motor."""
    curve = spec.motor.table if spec.motor is not None else None
    return (INTERPOLATE,) if curve is not None and curve.interpolation == "pchip" else ()


power = flywheel = motion  # the motor is the same


def transient(spec: Spec) -> Packages:
    """As of the steady motion; and the methods of integration that are asked for by name."""
    asked = any(each.method not in OWN for each in spec.transients)
    return (*motion(spec), INTEGRATE) if asked else motion(spec)


def synthesis(spec: Spec) -> Packages:
    """Searches over many parameters."""
    from tmmcalc.linkage.synthesis.dwell.task import DwellTask
    from tmmcalc.linkage.synthesis.task import FunctionTask
    from tmmcalc.linkage.tables.tasks.synthesis import to_synthesis

    asked = to_synthesis(spec).asked
    if isinstance(asked, FunctionTask):
        from tmmcalc.linkage.synthesis.function import is_exact

        return () if is_exact(asked) else (OPTIMIZE,)
    return (OPTIMIZE,) if isinstance(asked, DwellTask) and asked.optimum is not None else ()


def manipulator(spec: Spec) -> Packages:
    """A motion by a table is a cubic spline."""
    from tmmcalc.manipulators.tables.tasks.manipulator import to_manipulator
    from tmmcalc.manipulators.task import TableTask

    return (INTERPOLATE,) if isinstance(to_manipulator(spec).motion, TableTask) else ()


def cam_law(spec: Spec) -> Packages:
    """A law by points is a spline."""
    cam = spec.cam
    laws = () if cam is None else (cam.law, cam.rise_law, cam.return_law)
    return (INTERPOLATE,) if any(getattr(law, "points", None) is not None for law in laws) else ()


def vibrator(spec: Spec) -> Packages:
    """A start under a motor is integrated."""
    return (INTEGRATE,) if spec.vibrator is not None and spec.vibrator.drive is not None else ()


def contact(spec: Spec) -> Packages:
    """Hertz's ellipse has elliptic integrals; a table of the gap is a spline."""
    table = spec.contact
    if table is None:
        return ()
    return (OPTIMIZE, SPECIAL) if table.radii is not None else (INTERPOLATE,) if table.table is not None else ()


def reliability(spec: Spec) -> Packages:
    """Incomplete gamma functions, and roots."""
    return (OPTIMIZE, SPECIAL)


def falling_ball(spec: Spec) -> Packages:
    """Bessel functions, and roots."""
    return (OPTIMIZE, SPECIAL)
