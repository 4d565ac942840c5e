"""The ladders by name; each is a function of the scene, in a module that is imported only when it is climbed.

A ladder that the scene has not raises `UsageError` with the reason.
"""

from __future__ import annotations

LADDERS: dict[str, str] = {
    "dead-point": "tmmcalc.stress.linkage:dead_point",
    "cusp": "tmmcalc.stress.cams:cusp",
    "pressure": "tmmcalc.stress.cams:pressure",
    "singular": "tmmcalc.stress.manipulators:singular",
    "teeth": "tmmcalc.stress.gears:teeth",
    "shift": "tmmcalc.stress.gears:shift",
    "mesh-angle": "tmmcalc.stress.gears:mesh_angle",
    "torque": "tmmcalc.stress.gears:torque",
    "time-ratio": "tmmcalc.stress.synthesis:time_ratio",
    "range": "tmmcalc.stress.synthesis:narrow_range",
    "stiffness": "tmmcalc.stress.machine:stiffness",
    "lag": "tmmcalc.stress.machine:lag",
    "slip": "tmmcalc.stress.machine:slip",
    "inertia": "tmmcalc.stress.machine:inertia",
    "scale": "tmmcalc.stress.scales:scale",
    "positions": "tmmcalc.stress.numbering:positions",
    "start": "tmmcalc.stress.numbering:start_angle",
    "direction": "tmmcalc.stress.numbering:direction",
}
