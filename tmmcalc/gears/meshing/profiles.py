"""The tooth profiles of a project; lengths in metres, angles in radians, the tooth along +Y from the wheel's centre."""

from __future__ import annotations

import numpy as np

from tmmcalc.core.quantity import derived, quantity
from tmmcalc.core.records import record
from tmmcalc.gears.model import Values

ROLLED = ("L", "D", "A", "F")  # limit point, root, tip, form radius


@record
class WheelProfile:
    """Half a tooth of one wheel, from the middle of the space at the root to the middle of the tip."""

    pair: str = quantity("pair", "name of the pair")  # empty: a single one, or of a train, whose wheels are in several
    wheel: str = quantity("wheel", "name of the wheel")
    kind: str = quantity("kind", "external, ring or rack")
    teeth: int = quantity("teeth", "number of teeth", header="z")  # 0 for a rack
    shift: float = quantity("shift", "profile shift", header="x")
    module: float = quantity("module[m]", "normal module")
    tip: float = quantity("r_a[m]", "tip radius")  # the radii of a rack are heights above its datum line
    root: float = quantity("r_f[m]", "root radius")
    base: float = quantity("r_b[m]", "base radius")  # 0 for a rack
    form: float = quantity("r_F[m]", "form radius")
    undercut: bool = quantity("undercut", "whether the wheel is undercut")
    # of points (n,)
    part: np.ndarray = quantity("part", "curve of the point: root, fillet, involute (of a rack: flank), tip")
    roll: Values = quantity("phi[rad]", "roll angle")  # 0 on root and tip, and where nothing is rolled
    x: Values = quantity("x[m]", "x of the left half of the tooth")
    y: Values = quantity("y[m]", "y of the left half of the tooth")
    radius: Values = quantity(
        "R[m]", "radius of curvature, positive where the outline bulges"
    )  # 0: straight, or a corner
    half_angle: float = quantity("psi[rad]", "half the angle of the tooth on the reference circle")  # 0 for a rack
    centre: tuple[float, float] = quantity(  # 0 unless external
        "{axis}_1S[m]", "{axis} of the centre of the circular rounding on its rack", source="(4.85)"
    )
    rolls: tuple[float, float, float, float] = quantity("phi_{point}[rad]", "roll angle at {point}")  # of ROLLED
    fillet_least_radius: float = quantity(
        "fillet_least_radius[m]", "least radius of curvature of the fillet", header="R_min[m]"
    )
    join: float = quantity("join[m]", "distance of fillet and involute where they meet: 0 but for rounding")
    error: float  # of the outline's place, over its largest radius (of a rack its largest coordinate)

    @derived("tip[m]", "height of the tip of a rack above its datum line")
    def tip_height(self) -> float:
        """The radius of the tip circle, of a rack."""
        return self.tip

    @derived("root[m]", "height of the root of a rack, below 0")
    def root_height(self) -> float:
        """The radius of the root circle, of a rack."""
        return self.root

    @derived("form[m]", "height of the end of the straight flank of a rack, below 0")
    def form_height(self) -> float:
        """The form radius, of a rack."""
        return self.form


@record
class Profiles:
    """All wheels of all pairs; a wheel in several meshes once."""

    wheels: tuple[WheelProfile, ...]
    remarks: tuple[str, ...]
