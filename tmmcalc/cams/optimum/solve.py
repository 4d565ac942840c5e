"""The stage of the optimal design (sections 5.7 and 5.8.4 of the textbook)."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmmcalc.cams.follower import Follower
from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.optimum import flat
from tmmcalc.cams.optimum.checks import choice_of
from tmmcalc.cams.optimum.contour import Contour, contour
from tmmcalc.cams.optimum.game import options, variants
from tmmcalc.cams.optimum.least import least_height
from tmmcalc.cams.optimum.margins import SLACK, judge, margins
from tmmcalc.cams.optimum.refusal import refusal
from tmmcalc.cams.optimum.relax import relaxations
from tmmcalc.cams.optimum.results import CamOptimum, Choice, Section
from tmmcalc.cams.optimum.scene import WHERE, Phases, Scene, scene_of
from tmmcalc.cams.optimum.steps import Candidates, Found, search
from tmmcalc.cams.task import CamTask, Optimum
from tmmcalc.errors import UsageError

POINTS = 121  # of the section along r2


def solve_optimum(task: CamTask, follower: Follower, phases: Phases | None = None) -> CamOptimum:
    """The lowest mechanism, its blocking contours, what relaxing buys, and the options compared.

    ``follower`` gives its kind and offset; ``phases``, in place of the task's own, is what of the turn is examined:
    all of it, or, as in the textbook, the rise alone. Raises `UsageError` for a rocker, a groove, without loads, and
    for too many options; `NoSolutionError`, which names the constraints, where no sizes keep them all.
    """
    _check(task, follower)
    asked = Optimum() if task.optimum is None else task.optimum
    phases = asked.phases if phases is None else phases
    variants(task, asked)
    scene = scene_of(task, follower, phases)
    if follower.kind == "flat":
        return _flat(task, scene, asked, phases)
    found, known = search(scene, asked)
    if found is None:
        raise refusal(scene, asked)
    best = found.best
    order = np.argsort(-np.min(found.margin, axis=0), kind="stable")
    chosen = choice_of(scene, float(found.start[best]), float(found.roller[best]), found.height)
    lowest = least_height(scene, chosen.start, chosen.roller, chosen.height)
    least = choice_of(scene, lowest.start, lowest.roller, lowest.height)
    top = task.guide.top
    return CamOptimum(
        kind=follower.kind,
        phases=phases,
        step=asked.step,
        height_step=asked.height_step,
        stiffness=scene.spring.stiffness,
        preload=scene.spring.preload,
        safety=scene.spring.reached,
        chosen=chosen,
        start=found.start[order],
        roller=found.roller[order],
        margin=np.min(found.margin, axis=0)[order],
        examined=known.examined,
        excluded=known.examined - len(known.start),
        passed=tuple(known.passed.items()),
        least=least,
        asked=top,
        contours=tuple(_contours(scene, found, known, least, top)),
        relaxations=tuple(relaxations(scene, least)),
        options=tuple(options(task, scene, chosen, least, asked, phases)),
        section=_section(scene, chosen),
        flat=None,
        notes=tuple(_notes(scene, task, least, top)),
    )


def _flat(task: CamTask, scene: Scene, asked: Optimum, phases: Phases) -> CamOptimum:
    """The same of a flat-faced follower, whose only size is S0."""
    top, start, examined = flat.steps(scene, asked.step, asked.height_step)
    designs = [flat.choice_of(scene, each, top) for each in start.tolist()]
    designs.sort(key=lambda each: -each.worst.margin)
    least = flat.choice_of(scene, *flat.lowest(scene))
    return CamOptimum(
        kind="flat",
        phases=phases,
        step=asked.step,
        height_step=asked.height_step,
        stiffness=scene.spring.stiffness,
        preload=scene.spring.preload,
        safety=scene.spring.reached,
        chosen=designs[0],
        start=np.array([each.start for each in designs]),
        roller=np.zeros(len(designs)),
        margin=np.array([each.worst.margin for each in designs]),
        examined=examined,
        excluded=examined - len(designs),
        passed=(),
        least=least,
        asked=task.guide.top,
        contours=(),
        relaxations=tuple(flat.relaxations(scene, least)),
        options=tuple(options(task, scene, designs[0], least, asked, phases)),
        section=None,
        flat=flat.chart(scene),
        notes=tuple(_notes(scene, task, least, task.guide.top)),
    )


def _check(task: CamTask, follower: Follower) -> None:
    if follower.kind == "oscillating":
        raise UsageError(
            "there is no optimal design of a rocker: the method is that of a follower in a guide",
            where=WHERE,
            remedy="follower = 'translating' or 'flat'; or leave [cam.optimum] out",
        )
    if task.asked.closure == "groove":
        raise UsageError(
            "the optimal design is that of force closure: in a groove the roller slips wherever R changes its sign",
            where=WHERE,
            remedy="closure = 'force'; or leave [cam.optimum] out",
        )


def _contours(scene: Scene, found: Found, known: Candidates, least: Choice, top: float | None) -> Iterator[Contour]:
    """At the height of the spec, if it is high enough, and at the least one in steps."""
    if top is not None:
        start, roller = _feasible(scene, known, least, top)
        if len(start):
            yield contour(scene, top, (start, roller))
    if top is None or abs(top - found.height) > SLACK:
        yield contour(scene, found.height, (found.start, found.roller))


def _feasible(scene: Scene, known: Candidates, least: Choice, top: float) -> tuple[Values, Values]:
    """All candidates that are feasible at this height, and the sizes of the lowest mechanism if they are."""
    rows = np.flatnonzero((known.least <= top) & (known.most >= top))
    start, roller = np.append(known.start[rows], least.start), np.append(known.roller[rows], least.roller)
    good = np.all(margins(scene, start, roller, np.full(len(start), top)) >= -SLACK, axis=0)
    return start[good], roller[good]


def _section(scene: Scene, chosen: Choice) -> Section:
    """N1 and sigma_H along r2, up to where there is no guide left or the profile has a cusp (fig. 5.30)."""
    room = chosen.height - chosen.start - scene.stroke - scene.guide.gap
    roller = room * np.arange(1, POINTS + 1) / (POINTS + 1)
    found = judge(scene, np.full(POINTS, chosen.start), roller, np.full(POINTS, chosen.height))
    sound = np.all(found.margin > -10.0, axis=0)
    need, guide = scene.requirements, scene.guide
    edge = None
    if need.guide_pressure is not None and guide.land is not None and guide.stem is not None:
        edge = 2 * guide.land * guide.stem * need.guide_pressure
    return Section(
        chosen.start, chosen.height, roller[sound], found.edge[sound], found.stress[sound], edge, need.contact
    )


def _notes(scene: Scene, task: CamTask, least: Choice, top: float | None) -> Iterator[str]:
    missing = [f"{each.number} {each.name}" for each in least.checks if not each.judged and each.number > 1]
    if missing:
        yield f"note: not judged, for want of data in [cam.requirements] or [cam.guide]: {', '.join(missing)}"
    closed = least.checks[0]
    if closed.judged and closed.margin < 0:
        yield f"note: the spring reaches {closed.value:.5g} of the safety {closed.limit:.5g} that it was sized for"
    if top is not None and top < least.height:
        yield (
            f"warning: the height of [cam.guide] top, {1e3 * top:.5g} mm, is below the least possible "
            f"{1e3 * least.height:.6g} mm: no sizes keep all constraints at it"
        )
    if task.guide.gap == 0 and least.roller:
        yield "note: the guide begins where the roller ends at its highest: [cam.guide] gap is 0"
