"""Grab transloader: speeds and accelerations with their limits, loads, and stresses of its parts by case of loads.

Speeds are those of a way that begins and ends at rest with one acceleration: v = sqrt(L j) is the peak where the
whole way is acceleration and braking. Allowed stress is sigma0/(K_m K_n); K_m is K1 + K2 as the source prints it, or
K1 K2, as cranes are designed.
"""

from __future__ import annotations

from typing import Any, Literal

import numpy as np

from tmmcalc.core.notes import Phrase, Said, held
from tmmcalc.core.numerics.extended import apart, widened
from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record
from tmmcalc.extras.loadcases import CASES, DUTIES, LOADS, MAKINGS, MECHANISMS, OF_WEIGHT, PARTS_OF_MASS, SERIES, acts

MINUTE = 60.0
TROLLEY_PART, HOIST_PART = 0.5, 0.3  # of the peak, in practice
TROLLEY, HOIST, BRIDGE = (50 / MINUTE, 360 / MINUTE), (30 / MINUTE, 100 / MINUTE), (15 / MINUTE, 35 / MINUTE)  # [m/s]
LOWERING = (1.0, 1.4)  # of the speed of hoisting
HOIST_ACCELERATION = (1.0, 1.2)  # [m/s^2]
SPAN, USUAL_SPAN, LIFT = (30.0, 115.0), (40.0, 80.0), (20.0, 30.0)  # [m]
DEFLECTION = 700.0  # span over it
SAME = 1e-9  # a limit that is met but for rounding is met


@record
class Way:
    """A way that is driven from rest to rest."""

    length: float  # L0 or H [m]
    acceleration: float  # j [m/s^2]
    speed: float | None = None  # [m/s]; None: the largest that is usual


@record
class Wind:
    """A wind on an area."""

    pressure: float  # q0 [Pa]
    area: float  # [m^2]
    height: float = 1.0  # n
    shape: float = 1.0  # c
    overload: float = 1.0  # gamma
    dynamic: float = 1.0  # beta


@record
class Start:
    """What is set into motion by a mechanism."""

    weights: tuple[float, ...]  # G [N]
    speed: float | None = None  # v [m/s]; None: of the trolley
    time: float | None = None  # t [s]; None: with the acceleration of the trolley


@record
class Part:
    """A part whose stress is looked at."""

    name: str
    area: float  # that carries its force [m^2]
    strength: float  # sigma0 against static stress [Pa]
    influence: tuple[tuple[str, float], ...]  # load, force in the part over the load
    endurance: float | None = None  # sigma0 against fatigue [Pa]
    mechanism: str = "hoist"
    duty: str | None = None  # None: of its mechanism
    making: str = "rolled"
    importance: tuple[float, ...] | None = None  # K1 in the cases A, B and V; None: of its mechanism


@record
class TransloaderTask:
    """A transloader, its speeds, its loads, its parts."""

    capacity: float  # [kg]
    mass: float | None = None  # of the whole [kg]
    gravity: float = 9.81
    span: float | None = None  # [m]
    deflection: float | None = None  # of the bridge [m]
    trolley: Way | None = None
    hoist: Way | None = None
    lowering: float | None = None  # [m/s]
    bridge_speed: float | None = None  # [m/s]
    inertia: Start | None = None
    winds: tuple[tuple[str, Wind], ...] = ()  # by the name of the load
    loads: tuple[tuple[str, float], ...] = ()  # by name [N]
    parts: tuple[Part, ...] = ()
    factors: Literal["sum", "product"] = "sum"
    blanks: Literal["without", "with"] = "without"  # loads that the source left blank


@record
class Limit:
    """What a speed, an acceleration or a size may be."""

    name: str = quantity("name", "name of what is limited")
    what: str = quantity("limit", "what is limited")
    unit: str
    value: float = quantity("value[{unit}]", "{what}")
    low: float | None = quantity("low[{unit}]", "lowest that is usual: {what}")
    high: float | None = quantity("high[{unit}]", "highest that is usual: {what}")
    holds: bool = quantity("holds", "whether it is between its limits: {what}")


@record
class Drive:
    """A way from rest to rest."""

    what: str = quantity("drive", "trolley or hoist")
    length: float = quantity("L[m]", "way")
    acceleration: float = quantity("j[m/s^2]", "acceleration, and deceleration")
    peak: float = quantity("v_peak[m/s]", "speed that the way allows, sqrt(L j)", symbol=r"v_\text{peak}")
    speed: float = quantity("v[m/s]", "speed")
    time: float = quantity("t[s]", "time of the way at this speed")
    shortest: float = quantity("t_peak[s]", "time of the way without a stretch at one speed, 2 sqrt(L/j)")


@record
class Acting:
    """A load, and in which cases it acts."""

    load: str = quantity("load", "name of the load")
    value: float = quantity("F[N]", "size of load {load}")
    cases: tuple[str, ...] = quantity("cases", "cases in which it acts")
    blank: tuple[str, ...] = quantity("blank", "cases that the source left blank")


@record
class Check:
    """The stress of a part in a case of loads, with what is allowed."""

    part: str = quantity("part", "name of the part")
    case: str = quantity("case", "case of loads")
    kind: str = quantity("kind", "what sigma0 is: endurance or strength")
    force: float = quantity("N[N]", "force in the part")
    stress: float = quantity("sigma[Pa]", "stress of the part")
    importance: float = quantity("K1", "factor of the importance of the mechanism", symbol="K_1")
    duty: float = quantity("K2", "factor of its duty", symbol="K_2")
    margin: float = quantity("K_m", "K1 + K2 or K1 K2", symbol="K_m")
    making: float = quantity("K_n", "factor of how the part is made", symbol="K_n")
    allowed: float = quantity("sigma_allowed[Pa]", "allowed stress sigma0/(K_m K_n)", symbol=r"[\sigma]")
    other: float = quantity("sigma_other[Pa]", "allowed stress by the other K_m")
    use: float = quantity("use", "stress over allowed stress")
    holds: bool = quantity("holds", "whether the stress is allowed")


@record
class Transloader:
    """Speeds, limits, loads by case, stresses of the parts."""

    capacity: float = quantity("Q[kg]", "rated capacity")
    masses: tuple[float, ...] = quantity("masses[kg]", "usual masses of structure, mechanisms, electrical equipment")
    drives: tuple[Drive, ...]
    limits: tuple[Limit, ...]
    inertia: float | None = quantity("P[N]", "force of inertia, sum G v/(g t)")
    loads: tuple[Acting, ...]
    factors: str = quantity("factors", "K_m is the sum K1 + K2 or the product K1 K2")
    blanks: str = quantity("blanks", "whether loads act that the source left blank: with or without them")
    checks: tuple[Check, ...]
    notes: tuple[Said, ...] = ()
    error: float = 0.0  # of speeds, loads and stresses, each relative to itself


def solve_transloader(task: TransloaderTask) -> Transloader:
    """Speeds with their limits, loads by case, stresses of the parts beside what is allowed."""
    drives = tuple(_drive(*each) for each in _ways(task))
    loads = _loads(task)
    checks = tuple(check for part in task.parts for check in _checks(task, part, loads))
    limits = tuple(_limits(task, drives))
    return Transloader(
        capacity=task.capacity,
        masses=() if task.mass is None else tuple(part * task.mass for part in PARTS_OF_MASS.values()),
        drives=drives,
        limits=limits,
        inertia=None if task.inertia is None else loads["inertia"],
        loads=tuple(_acting(task, name, value) for name, value in loads.items()),
        factors=task.factors,
        blanks=task.blanks,
        checks=checks,
        notes=tuple(_notes(task, limits, checks, loads)),
        error=_error(task, drives, loads, checks),
    )


def _ways(task: TransloaderTask) -> list[tuple[str, Way]]:
    given = ("trolley", task.trolley), ("hoist", task.hoist)
    return [(what, way) for what, way in given if way is not None]


def _drive(what: str, way: Way) -> Drive:
    """Speed and times of a way, in the numbers of the way."""
    length, j = way.length, way.acceleration
    peak, (_, most) = np.sqrt(length * j), TROLLEY if what == "trolley" else HOIST
    part = TROLLEY_PART if what == "trolley" else HOIST_PART
    speed = min(part * peak, most) if way.speed is None else way.speed
    reached = min(speed, peak)
    return Drive(what, length, j, peak, speed, length / reached + reached / j, 2 * np.sqrt(length / j))


def _loads(task: TransloaderTask) -> dict[str, Any]:
    """Sizes of the loads [N] in the order of the source, in the numbers of the task."""
    given = dict(task.loads)
    found: dict[str, Any] = {"rated_load": task.capacity * task.gravity}
    if task.mass is not None:
        found["dead_weight"] = task.mass * task.gravity
    if task.inertia is not None:
        found["inertia"] = _inertia(task, task.inertia)
    for name, wind in task.winds:
        found[name] = wind.pressure * wind.height * wind.shape * wind.overload * wind.dynamic * wind.area
    found |= given
    return {name: found[name] for name in LOADS if name in found}


def _inertia(task: TransloaderTask, start: Start) -> Any:
    """P = (sum G) v/(g t) [N]; by default v and t are those of the trolley."""
    weight = sum(start.weights)
    trolley = None if task.trolley is None else _drive("trolley", task.trolley)
    speed = start.speed if start.speed is not None else trolley.speed if trolley is not None else 0.0
    if start.time is not None:
        return weight * speed / (task.gravity * start.time)
    assert task.trolley is not None  # the checks of the spec ask for a time else
    return weight * task.trolley.acceleration / task.gravity


def _acting(task: TransloaderTask, name: str, value: float) -> Acting:
    blank = tuple(case for k, case in enumerate(CASES) if LOADS[name].acts[k] == "?")
    return Acting(name, value, tuple(case for case in CASES if acts(name, case, task.blanks == "with")), blank)


def _checks(task: TransloaderTask, part: Part, loads: dict[str, Any]) -> list[Check]:
    """The checks of a part, in the numbers of the task: in case A against fatigue too.

    Weights act as they are; the other loads have either sense, and are added to them at their worst.
    """
    mechanism = MECHANISMS[part.mechanism]
    k2 = DUTIES[part.duty or mechanism.duty]
    found = []
    for case in CASES:
        k1 = (part.importance or mechanism.importance)["ABV".index(case[0])]
        if k1 is None:
            continue
        forces = {
            name: ratio * loads[name] for name, ratio in part.influence if acts(name, case, task.blanks == "with")
        }
        weight = sum(force for name, force in forces.items() if name in OF_WEIGHT)
        force = abs(weight) + sum(abs(force) for name, force in forces.items() if name not in OF_WEIGHT)
        stress = force / part.area
        limits = {"endurance": part.endurance if case == "A" else None, "strength": part.strength}
        for kind, limit in limits.items():
            if limit is None:
                continue
            kn = MAKINGS[part.making] if kind == "endurance" else 1.0
            margins = {"sum": k1 + k2, "product": k1 * k2}
            margin = margins.pop(task.factors)
            (other,) = margins.values()
            allowed = limit / (margin * kn)
            use = stress / allowed
            each = (force, stress, k1, k2, margin, kn, allowed, limit / (other * kn), use)
            found.append(Check(part.name, case, kind, *each, bool(use <= 1 + SAME)))
    return found


def _limits(task: TransloaderTask, drives: tuple[Drive, ...]) -> list[Limit]:
    """Speeds, accelerations and sizes that are given or follow, with what is usual."""
    found = []
    speeds = {drive.what: drive for drive in drives}
    if "trolley" in speeds:
        v, most = speeds["trolley"].speed, TROLLEY_PART * speeds["trolley"].peak
        found.append(_limit("trolley_speed", "speed of the trolley", "m/s", v, *TROLLEY))
        found.append(_limit("trolley_speed_by_way", "speed of the trolley by its way", "m/s", v, None, most))
    if "hoist" in speeds:
        v, j, most = speeds["hoist"].speed, speeds["hoist"].acceleration, HOIST_PART * speeds["hoist"].peak
        found.append(_limit("hoist_speed", "speed of the hoist", "m/s", v, *HOIST))
        found.append(_limit("hoist_speed_by_height", "speed of the hoist by its height", "m/s", v, None, most))
        found.append(_limit("hoist_acceleration", "acceleration of the hoist", "m/s^2", j, *HOIST_ACCELERATION))
        found.append(_limit("lift", "height of the lift", "m", speeds["hoist"].length, *LIFT))
        if task.lowering is not None:
            low, high = (part * v for part in LOWERING)
            found.append(_limit("lowering_speed", "speed of lowering", "m/s", task.lowering, low, high))
    if task.bridge_speed is not None:
        found.append(_limit("bridge_speed", "speed of the bridge", "m/s", task.bridge_speed, *BRIDGE))
    if task.span is not None:
        found.append(_limit("span", "span", "m", task.span, *SPAN))
        if task.deflection is not None:
            most = task.span / DEFLECTION
            found.append(_limit("deflection", "deflection of the bridge", "m", task.deflection, None, most))
    return found


def _limit(name: str, what: str, unit: str, value: float, low: float | None, high: float | None) -> Limit:
    above = low is None or value >= low * (1 - SAME)
    return Limit(name, what, unit, value, low, high, bool(above and (high is None or value <= high * (1 + SAME))))


def _notes(
    task: TransloaderTask, limits: tuple[Limit, ...], checks: tuple[Check, ...], loads: dict[str, Any]
) -> list[Said]:
    found: list[Said] = []
    tonnes = task.capacity / 1000
    if min(abs(tonnes - each) for each in SERIES) > SAME * tonnes:
        nearest = min(SERIES, key=lambda each: abs(each - tonnes))
        found.append(
            Phrase(
                "note: {tonnes:g} t is not of the series of GOST 1575-61; the nearest is {nearest:g} t",
                tonnes=tonnes,
                nearest=nearest,
            )
        )
    if task.span is not None and SPAN[0] <= task.span <= SPAN[1] and not USUAL_SPAN[0] <= task.span <= USUAL_SPAN[1]:
        found.append(
            Phrase(
                "note: most spans are from {low:g} to {high:g} m",
                low=USUAL_SPAN[0],
                high=USUAL_SPAN[1],
            )
        )
    found += [_outside(each) for each in limits if not each.holds]
    found += [_overstressed(each) for each in checks if not each.holds]
    if checks:
        told = {"sum": "K_m = K1 + K2, as the source prints it", "product": "K_m = K1 K2, as cranes are designed"}
        other = {"sum": "product", "product": "sum"}[task.factors]
        found.append(
            Phrase(
                'note: {told}; the print may have lost a multiplication sign: factors = "{other}" takes the '
                "{other}, whose allowed stresses stand beside",
                told=told[task.factors],
                other=other,
            )
        )
    blank = [LOADS[name].meaning for name in loads if "?" in LOADS[name].acts]
    if blank:
        words = {"with": "acts there", "without": 'is left out there; blanks = "with" has it act'}[task.blanks]
        found.append(
            Phrase(
                "note: what the source leaves blank out of service ({blank}) {words}",
                blank=blank,
                words=words,
            )
        )
    unchecked = [
        part.name for part in task.parts if all(each.case[0] != "V" for each in checks if each.part == part.name)
    ]
    if unchecked:
        found.append(
            Phrase(
                "note: the source has no K1 out of service for {unchecked}: cases V1 and V2 are not checked; "
                "importance = [1.2, 1.1, 1.1], K1 in A, B and V, gives one",
                unchecked=unchecked,
            )
        )
    return found


def _outside(limit: Limit) -> Said:
    low = limit.low is not None and limit.value < limit.low
    end = limit.low if low else limit.high
    assert end is not None
    shown = "m/min" if limit.unit == "m/s" else ""
    text = "{what} is {value:.6g} {unit}, above {limit:.6g} {unit}"
    if low:
        text = "{what} is {value:.6g} {unit}, below {limit:.6g} {unit}"
    return held("warning", text, limit.value, end, limit.unit, shown=shown, name=limit.name, what=limit.what)


def _overstressed(check: Check) -> Said:
    text = "{part}, case {case}: {value:.6g} MPa is above the allowed {limit:.6g} MPa ({kind})"
    words = {"part": check.part, "case": check.case, "kind": check.kind}
    return held("warning", text, check.stress, check.allowed, "Pa", shown="MPa", name="sigma", **words)


def _error(task: TransloaderTask, drives: tuple[Drive, ...], loads: dict[str, Any], checks: tuple[Check, ...]) -> float:
    """The same formulas in extended precision."""
    wide = widened(task)
    wide_loads = _loads(wide)
    wide_drives = [_drive(*each) for each in _ways(wide)]
    wide_checks = [check for part in wide.parts for check in _checks(wide, part, wide_loads)]
    pairs = [*zip(loads.values(), wide_loads.values(), strict=True)]
    for one, drive in zip(drives, wide_drives, strict=True):
        pairs += [(one.peak, drive.peak), (one.time, drive.time)]
    for each, check in zip(checks, wide_checks, strict=True):
        pairs += [(each.stress, check.stress), (each.allowed, check.allowed)]
    return max(apart(*pair) for pair in pairs)
