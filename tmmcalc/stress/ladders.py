"""The ladders by name; each is a function of the scene, in a module that is imported only when it is climbed.

A ladder that the scene has not raises `UsageError` with the reason.
"""

from __future__ import annotations

LADDERS: dict[str, str] = {
    "dead-point": "tmmcalc.stress.linkage:dead_point",
    "cusp": "tmmcalc.stress.cams:cusp",
    "stiffness": "tmmcalc.stress.machine:stiffness",
    "lag": "tmmcalc.stress.machine:lag",
    "slip": "tmmcalc.stress.machine:slip",
    "inertia": "tmmcalc.stress.machine:inertia",
    "scale": "tmmcalc.stress.scales:scale",
    "positions": "tmmcalc.stress.linkage:positions",
    "start": "tmmcalc.stress.linkage:start_angle",
    "direction": "tmmcalc.stress.linkage:direction",
}
