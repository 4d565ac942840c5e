"""Why there are no sizes: which constraints exclude each other, and the sizes that come nearest."""

from __future__ import annotations

from itertools import combinations

import numpy as np

from tmmcalc.cams.optimum.checks import checks
from tmmcalc.cams.optimum.firstfeasible import FirstFeasible
from tmmcalc.cams.optimum.guidelength import SINGLE, TALL, Range, ranges
from tmmcalc.cams.optimum.margins import judge
from tmmcalc.cams.optimum.results import NAMES, Check
from tmmcalc.cams.optimum.scene import WHERE, Scene
from tmmcalc.cams.optimum.wholesteps import farthest
from tmmcalc.cams.task import Optimum
from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.notes import Phrase, listed

_HIGHEST = "{what} no S0 and r2 with H2 up to {high:g} mm"
NODES = 48  # of each side of the plane
UNITS = {"m": ("mm", 1e3), "Pa": ("MPa", 1e-6)}
REMEDIES = {
    2: "roller_friction, roller_inertia",
    3: "convex_radius",
    4: "concave_radius, allow_concave",
    5: "pin_pressure, roller_ratio",
    6: "bending, deflection, span",
    7: "bending, the stem's radius",
    8: "guide_pressure, land, stem_radius",
    9: "contact, width",
}


def refusal(scene: Scene, asked: Optimum, found: FirstFeasible | None) -> NoSolutionError:
    """The error that tells what stands against each other; ``found`` keeps all constraints, but far out."""
    base = scene.stroke + scene.guide.gap
    high = farthest(scene, asked)
    side = high * np.arange(1, NODES + 1) / NODES
    start, roller = np.repeat(side, NODES), np.tile(side, NODES)
    inside = roller < np.hypot(start, scene.follower.offset)
    start, roller = start[inside], roller[inside]
    each = ranges(scene, start, roller)
    top = np.full(len(start), TALL if asked.heights is None else asked.heights[1])
    room = Range(np.zeros(len(start)), np.maximum(top - base - start - roller, 0.0))
    at = np.minimum(top, base + start + roller + 10 * scene.stroke)
    margin = judge(scene, start, roller, at)
    best = int(np.argmax(np.min(margin.margin, axis=0)))
    broken = [
        c for c in checks(scene, margin, best, float(start[best]), float(roller[best])) if c.judged and c.margin < 0
    ]
    keys = _conflict(each, room)
    names = listed([Phrase("{key} ({name})", key=key, name=NAMES[key]) for key in keys], " and ")
    values = {"what": "the constraints together leave", "high": 1e3 * (asked.heights[1] if asked.heights else high)}
    if keys:
        text = "constraint {names} leaves" if len(keys) == 1 else "constraints {names} leave"
        values["what"] = Phrase(text, names=names)
    text = "{what} no S0 and r2 with S0 up to {high:g} mm" if asked.heights is None else _HIGHEST
    said = Phrase(
        "{none}; nearest is S0 = {start:.4g}, r2 = {roller:.4g}, H2 = {height:.4g} mm, with {broken}",
        none=Phrase(text, **values),
        start=1e3 * start[best],
        roller=1e3 * roller[best],
        height=1e3 * at[best],
        broken=listed([_said(c) for c in broken], "; ") or "no step point",
    )
    step = ""
    if found is not None:
        said = Phrase(
            "{said}; all are kept far out, at S0 = {start:.5g}, r2 = {roller:.4g}, H2 = {height:.5g} mm",
            said=said,
            start=1e3 * found.start,
            roller=1e3 * found.roller,
            height=1e3 * found.height,
        )
        step = f"; [cam.optimum] step above {1e3 * asked.step:g} mm reaches so far"
    return NoSolutionError(
        said,
        where=WHERE,
        value=broken[0].value if broken else None,
        limit=broken[0].limit if broken else None,
        remedy="look at " + "; ".join(REMEDIES[key] for key in keys or [c.number for c in broken] or [8]) + step,
    )


def _conflict(each: dict[int, Range], room: Range) -> tuple[int, ...]:
    """The fewest constraints that leave no point together."""
    for count in (1, 2, 3):
        for keys in combinations(SINGLE, count):
            left = room
            for key in keys:
                left = left.meet(each[key])
            if not left.some.any():
                return keys
    return ()


def _said(check: Check) -> str:
    unit, factor = UNITS.get(check.unit, ("", 1.0))
    limit = "none" if check.limit is None else f"{check.limit * factor:.4g} {unit}".rstrip()
    text = "{number} {check}: {symbol} = {value:.4g} < {limit}"
    if check.relation == "<=":
        text = "{number} {check}: {symbol} = {value:.4g} > {limit}"
    value = (check.value or 0.0) * factor
    return Phrase(text, number=check.number, check=check.name, symbol=check.symbol, value=value, limit=limit)
