"""Meshes that share wheels, as a single planet is in mesh with sun and ring: such a wheel has one shift and one tip.

At fixed centre distances the sums of shifts are fixed, so one shift u, that of the first wheel, gives all others:
each is c + u or c - u. Every mesh admits some u; of those that all admit the nearest to the choice of the first mesh is
taken. Its tip is the one that is given in one of its meshes, else the smallest that any asks for.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace

from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.core.notes import Phrase, listed
from tmmcalc.core.records import record
from tmmcalc.gears.involute.contour.frame import frame_of
from tmmcalc.gears.involute.contour.interval import interval
from tmmcalc.gears.involute.internal.line import Span, internal_line, intervals
from tmmcalc.gears.involute.internal.ring import angle_of_distance
from tmmcalc.gears.meshing.choice import contour_task, sum_asked
from tmmcalc.gears.meshing.geometry import RING_TIPS, ring_of, wheel_of
from tmmcalc.gears.meshing.refusal import millimetres
from tmmcalc.gears.meshing.results import MeshPair
from tmmcalc.gears.meshing.task import PairTask

WHERE = "pairs of the train"
EQUAL = 1e-12  # relative difference of radii that counts as none
TOLD = 1e-9  # that is told of
AGREE = 5e-4  # by which shifts that are given for one wheel may differ
NEAR = 1e-9  # by which a limited shift stays clear of the limit

Solve = Callable[[PairTask], MeshPair]


@record
class Sign:
    """A shift as a function of u, c + s u."""

    c: float
    s: float

    def at(self, u: float) -> float:
        """The shift."""
        return self.c + self.s * u

    def back(self, x: float) -> float:
        """The u of a shift."""
        return (x - self.c) / self.s


def solve_chain(tasks: Sequence[PairTask], solve: Solve) -> tuple[list[MeshPair], list[str], list[NoSolutionError]]:
    """Meshes of which each shares a wheel with the one before: the pairs, remarks, and what cannot be made.

    The first may have any strategy; the others are at a centre distance. Raises `UsageError` for demands on a shared
    wheel that contradict each other.
    """
    _check_alike(tasks)
    try:
        first = solve(tasks[0])
    except NoSolutionError as error:
        return [], [], [error, *_faults(tasks[1:], solve)]
    if len(tasks) == 1:
        return [first], [], []
    try:
        probes, remarks = _shifted(tasks, first, solve)
    except NoSolutionError as error:
        return [], [], [error]
    last, said = with_tips(tasks, probes)
    found, errors = [], []
    for task, probe, asked in zip(last, probes, tasks, strict=True):
        unchanged = task == replace(probe.task, refuse=task.refuse) and probe.verdict != "fail"
        try:
            found.append(replace(probe, task=task) if unchanged else solve(task))
        except NoSolutionError as error:
            errors.append(error if task == asked else _explained(error, remarks, tasks))
    return found, remarks + said, errors


def _faults(tasks: Sequence[PairTask], solve: Solve) -> list[NoSolutionError]:
    """What is wrong with meshes whatever the others ask of them."""
    found = []
    for task in tasks:
        try:
            solve(task)
        except NoSolutionError as error:
            found.append(error)
    return found


def _explained(error: NoSolutionError, remarks: list[str], tasks: Sequence[PairTask]) -> NoSolutionError:
    """The error of a mesh whose shifts and tips others have set."""
    text = "; ".join((error.message, *remarks))
    binding = " and ".join(task.name for task in tasks)
    remedy = f"another strategy, centre distance or other shifts: meshes {binding} share wheels, which have one shift"
    if any(tip is not None for task in tasks for tip in task.tips):
        remedy += "; or other tip diameters"
    return NoSolutionError(text, where=error.where, value=error.value, limit=error.limit, remedy=remedy)


def _check_alike(tasks: Sequence[PairTask]) -> None:
    first = tasks[0]
    for task in tasks[1:]:
        if abs(task.helix) != abs(first.helix) or task.rack != first.rack:
            raise UsageError(
                f"meshes {first.name} and {task.name} share a wheel, but not its rack and helix angle",
                where=WHERE,
                remedy="the same rack and helix angle for both meshes",
            )


def _shifted(tasks: Sequence[PairTask], first: MeshPair, solve: Solve) -> tuple[list[MeshPair], list[str]]:
    """The pairs with one shift for every wheel, also those that cannot work, and what was given up for it."""
    signs = _signs(tasks, first)
    u, remarks = _given(tasks, first, signs), list[str]()
    if u is None:
        u, remarks = _limited(tasks, first, signs)
    if u != first.shifts[0]:
        moved = tasks[0] if tasks[0].strategy == "equal_shift" else _at_distance(tasks[0], first.distance)
        first = solve(replace(moved, shifts=(u, None), refuse=False))
    found, shifts = [first], dict(zip(first.task.wheels, first.shifts, strict=True))
    for task in tasks[1:]:
        one, two = (shifts.get(wheel) for wheel in task.wheels)
        found.append(solve(replace(task, shifts=(one, two), refuse=False)))
        shifts |= dict(zip(task.wheels, found[-1].shifts, strict=True))
    return found, remarks


def _at_distance(task: PairTask, distance: float) -> PairTask:
    return replace(task, strategy="given_aw", distance=distance)


def _signs(tasks: Sequence[PairTask], first: MeshPair) -> dict[str, Sign]:
    """Every wheel's shift as a function of x1 of the first mesh; raises `NoSolutionError` if a sum does not exist."""
    found = {tasks[0].wheels[0]: Sign(0.0, 1.0), tasks[0].wheels[1]: Sign(first.shifts[0] + first.shifts[1], -1.0)}
    for task in tasks[1:]:
        one, two = task.wheels if task.wheels[0] in found else task.wheels[::-1]
        found[two] = Sign(_sum(task) - found[one].c, -found[one].s)
    return found


def _sum(task: PairTask) -> float:
    """x1 + x2 of a mesh whose centre distance is fixed."""
    if task.kind == "external" or task.strategy != "given_aw" or task.distance is None:
        return sum_asked(task) or 0.0
    return angle_of_distance(wheel_of(task, 1), ring_of(task), task.distance / task.module)[0]


def _given(tasks: Sequence[PairTask], first: MeshPair, signs: dict[str, Sign]) -> float | None:
    """u, if shifts are given anywhere; raises `UsageError` if those of several wheels do not fit together."""
    asked = list(_demands(tasks))
    if not asked:
        return None
    values = [signs[wheel].back(x) for _, wheel, x in asked]
    for (name, wheel, x), u in zip(asked, values, strict=True):
        if abs(u - values[0]) > AGREE:
            raise UsageError(
                f"mesh {name} asks for x = {x:.6g} of wheel {wheel}, but mesh {asked[0][0]} leaves it "
                f"x = {signs[wheel].at(values[0]):.6g}",
                where=WHERE,
                value=x,
                limit=signs[wheel].at(values[0]),
                remedy=f"meshes {', '.join(task.name for task in tasks)} share wheels: give one wheel its shift",
            )
    explicit = asked[0][0] == tasks[0].name
    return first.shifts[0] if explicit else values[0]


def _demands(tasks: Sequence[PairTask]) -> Iterator[tuple[str, str, float]]:
    """Mesh, wheel and shift, wherever a shift is given."""
    for task in tasks:
        shifts = (0.0, 0.0) if task.strategy == "zero" else task.shifts
        yield from ((task.name, w, float(x)) for w, x in zip(task.wheels, shifts, strict=True) if x is not None)


def _limited(tasks: Sequence[PairTask], first: MeshPair, signs: dict[str, Sign]) -> tuple[float, list[str]]:
    """The admissible u nearest to the choice of the first mesh; that itself if no u suits all meshes."""
    wanted, shared = first.shifts[0], tasks[0].wheels[1]
    sign, others = signs[shared], listed([task.name for task in tasks[1:]], " and ")
    spans: list[Span] = []
    for strict in (True, False):
        if strict or all(task.limits.undercut for task in tasks):
            spans = _common([_spans(task, signs, first, strict) for task in tasks])
        if spans:
            break
    if not spans:
        each = listed([_told(task, signs, first, shared) for task in tasks], "; ")
        return wanted, [Phrase("no shift of wheel {shared} suits all of its meshes: {each}", shared=shared, each=each)]
    u = min((_inside(span, wanted) for span in spans), key=lambda u: abs(u - wanted))
    if abs(u - wanted) <= 2 * NEAR:
        return wanted, []
    text = (
        "mesh {name} alone would give wheel {wheel} the shift x = {wanted:.4f}; x = {nearest:.4f} is the nearest that "
        "{others} admits as well"
    )
    if len(tasks) > 2:
        text = (
            "mesh {name} alone would give wheel {wheel} the shift x = {wanted:.4f}; x = {nearest:.4f} is the nearest "
            "that {others} admit as well"
        )
    values = {"wanted": sign.at(wanted), "nearest": sign.at(u), "others": others}
    return u, [Phrase(text, name=tasks[0].name, wheel=shared, **values)]


def _inside(span: Span, wanted: float) -> float:
    """The point of a span nearest to the wanted one, a little clear of the ends."""
    low, high = span
    return (low + high) / 2 if high - low <= 2 * NEAR else min(max(wanted, low + NEAR), high - NEAR)


def _spans(task: PairTask, signs: dict[str, Sign], first: MeshPair, strict: bool) -> list[Span]:
    """All u that a mesh admits; of the first at least its choice, which may be the last point of its contour."""
    undercut = task.limits.undercut and not (strict and task.strict)
    sign = signs[task.wheels[0]]
    total = sign.c + signs[task.wheels[1]].c
    if task.kind == "internal":
        limits = replace(task.limits, undercut=undercut)
        # the first mesh, if it is external, shortens the tip of the pinion that both share
        cut = first.shortening if first.task.kind == "external" else 0.0
        line = internal_line(wheel_of(task, 1), ring_of(task), total, limits, task.fillet, RING_TIPS, cut)
        found: tuple[Span, ...] = intervals(line)
    else:
        try:
            ends = interval(frame_of(contour_task(task)), total, strict=not undercut)
            found = ((ends.low, ends.high),)
        except NoSolutionError:
            found = ()
    if task.name == first.task.name and not (found or first.broken):
        found = ((first.shifts[0], first.shifts[0]),)
    both = ((sign.back(low), sign.back(high)) for low, high in found)
    return [(min(pair), max(pair)) for pair in both]


def _common(each: Sequence[Sequence[Span]]) -> list[Span]:
    """What lies in one span of every mesh."""
    found = list(each[0])
    for spans in each[1:]:
        found = [(max(a, c), min(b, d)) for a, b in found for c, d in spans]
    return [(low, high) for low, high in found if low <= high]


def _told(task: PairTask, signs: dict[str, Sign], first: MeshPair, wheel: str) -> str:
    sign = signs[wheel]
    spans = [sorted((sign.at(low), sign.at(high))) for low, high in _spans(task, signs, first, strict=False)]
    told = [Phrase("{low:.4f} ... {high:.4f}", low=low, high=high) for low, high in spans]
    return Phrase("{name} admits {spans}", name=task.name, spans=listed(told, " or ") or "none")


def with_tips(tasks: Sequence[PairTask], probes: Sequence[MeshPair]) -> tuple[list[PairTask], list[str]]:
    """The tasks with the shifts of the probes and one tip for every shared wheel; they refuse as was asked."""
    wheels = [wheel for task in tasks for wheel in task.wheels]
    shared = [wheel for wheel in dict.fromkeys(wheels) if wheels.count(wheel) > 1]
    last = [replace(probe.task, refuse=task.refuse) for task, probe in zip(tasks, probes, strict=True)]
    remarks = []
    for wheel in shared:
        places = [(k, task.wheels.index(wheel)) for k, task in enumerate(tasks) if wheel in task.wheels]
        tip, said = _tip(wheel, [(tasks[k].name, tasks[k].tips[i], probes[k].sizes[i].tip) for k, i in places])
        remarks += said
        for k, i in places:
            if abs(probes[k].sizes[i].tip - tip) > EQUAL * tip:
                one, two = last[k].tips
                last[k] = replace(last[k], tips=(tip, two) if i == 0 else (one, tip))
    return last, remarks


def _tip(wheel: str, each: Sequence[tuple[str, float | None, float]]) -> tuple[float, list[str]]:
    """The radius of the tip circle: the one that is given, else the smallest of all meshes."""
    given = [radius for _, radius, _ in each if radius is not None]
    if any(abs(radius - given[0]) > EQUAL * given[0] for radius in given):
        raise UsageError(
            f"wheel {wheel} is given several tip diameters: {', '.join(millimetres(2 * r) for r in given)}",
            where=WHERE,
            remedy="give it in one of its meshes",
        )
    name, _, least = min(each, key=lambda one: one[2])
    tip = given[0] if given else least
    other = max(radius for *_, radius in each)
    if given or other - tip <= TOLD * tip:
        return tip, []
    return tip, [
        Phrase(
            "wheel {wheel} has the smaller of its tips, d_a = {tip} as mesh {name} asks, not {other}",
            wheel=wheel,
            tip=millimetres(2 * tip),
            name=name,
            other=millimetres(2 * other),
        )
    ]
