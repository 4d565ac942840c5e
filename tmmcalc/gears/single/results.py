"""A wheel without a mate, solved; lengths in metres unless a field says modules, angles in radians."""

from __future__ import annotations

from math import pi, tan

from tmmcalc.core.quantity import derived, quantity
from tmmcalc.core.records import record
from tmmcalc.gears.involute.quality.verdicts import Check, Verdict, worst
from tmmcalc.gears.meshing.profiles import WheelProfile
from tmmcalc.gears.meshing.results import Measures, ToothStrength
from tmmcalc.gears.single.task import WheelTask


@record
class SingleError:
    """Relative errors of what is told of the wheel, for its shift as it is."""

    thickness: float  # of the tooth on reference and tip circle
    span: float | None  # W of the chosen span
    balls: float | None  # M over or between balls or pins
    outline: float | None  # of the profile; None: it has none


@record
class SingleWheel:
    """One wheel with all that does not depend on a mate."""

    task: WheelTask
    angle_t: float = quantity("alpha_t[rad]", "transverse pressure angle", source="(4.52)")
    base_helix: float = quantity("beta_b[rad]", "helix angle at the base cylinder")
    reference: float = quantity("r[m]", "reference radius")
    tip: float = quantity("r_a[m]", "tip radius")
    root: float = quantity("r_f[m]", "root radius")
    base: float = quantity("r_b[m]", "base radius")
    form: float = quantity("r_F[m]", "form radius: the involute ends")
    thickness: float = quantity("s_n[m]", "tooth thickness, normal")  # arc on the reference circle
    tip_thickness: float = quantity("s_na[m]", "tip thickness, normal")  # arc on the tip circle
    arc: float = quantity("s_t[m]", "tooth thickness, transverse")
    tip_arc: float = quantity("s_ta[m]", "tip thickness, transverse")
    half_angle: float = quantity("psi[rad]", "half the angle of the tooth on the reference circle")
    # None of the next: ring
    least_shift: float | None = quantity("x_min", "least shift without undercut")
    least_teeth: float | None = quantity("z_min", "least number of teeth without undercut at this shift")
    limit: float | None = quantity("LN[m]", "radius of curvature at the limit point, signed")
    pointing: float | None = quantity("r_s[m]", "radius where the flanks meet")
    # None: there is no such shift up to 50 modules
    pointed_shift: float | None = quantity(
        "x_max", "largest shift of whole teeth: they are pointed, those of a ring end on its base circle"
    )
    thin_shift: float | None = quantity("x_wanted", "largest shift of whole teeth with the tip thickness wanted")
    strength: ToothStrength | None  # external
    checks: tuple[Check, ...]  # lengths in modules
    measures: Measures
    profile: WheelProfile | None  # None: the wheel cannot have one
    remarks: tuple[str, ...]  # on the profile
    error: SingleError | None = None  # None: not estimated

    @derived("lead[m]", "lead of the helix", symbol="p_z")
    def lead(self) -> float | None:
        """p_z = 2 pi r/tan(beta); None for a spur wheel."""
        return 2 * pi * self.reference / tan(abs(self.task.helix)) if self.task.helix else None

    @derived("verdict", "the worst verdict of all checks")
    def verdict(self) -> Verdict:
        """The worst of all checks."""
        return worst(self.checks)
