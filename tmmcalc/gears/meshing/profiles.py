"""The tooth profiles of a project; lengths in metres, angles in radians, the tooth along +Y from the wheel's centre."""

from __future__ import annotations

import numpy as np

from tmmcalc.core.records import record
from tmmcalc.gears.model import Values


@record
class WheelProfile:
    """Half a tooth of one wheel, from the middle of the space at the root to the middle of the tip."""

    pair: str  # name of the pair; empty for a single one, and in a train, where a wheel may be in several
    wheel: str  # name of the wheel
    kind: str  # external, ring or rack
    teeth: int  # 0 for a rack
    shift: float
    module: float
    tip: float  # r_a; of a rack the height of its tip above the datum line
    root: float  # r_f; of a rack the height of its root, below 0; so is its form
    base: float  # r_b; 0 for a rack
    form: float  # r_F
    undercut: bool
    part: np.ndarray  # (n,) root, fillet, involute (of a rack: flank), tip: the curve of each point
    roll: Values  # (n,) phi [rad]; 0 on root and tip, and where nothing is rolled
    x: Values  # (n,) the left half of the tooth
    y: Values  # (n,)
    radius: Values  # (n,) of curvature, positive where the outline bulges; 0: straight or a sharp corner
    half_angle: float  # psi [rad], half the tooth on the reference circle; 0 for a rack
    centre: tuple[float, float]  # x_1S, y_1S of the circular rounding on its rack (4.85); 0 unless external
    rolls: tuple[float, float, float, float]  # phi_L, phi_D, phi_A, phi_F: limit point, root, tip, form
    fillet_least_radius: float  # least radius of curvature of the fillet
    join: float  # distance of fillet and involute where they meet: 0 but for rounding
    error: float  # of the outline's place, over its largest radius (of a rack its largest coordinate)


@record
class Profiles:
    """All wheels of all pairs; a wheel in several meshes once."""

    wheels: tuple[WheelProfile, ...]
    remarks: tuple[str, ...]
