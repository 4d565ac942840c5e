"""The stage of the optimal design (sections 5.7 and 5.8.4 of the textbook)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from tmmcalc.cams.follower import Follower
from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.optimum import flatface
from tmmcalc.cams.optimum.checks import choice_of
from tmmcalc.cams.optimum.contour import contour
from tmmcalc.cams.optimum.errors import optimum_errors
from tmmcalc.cams.optimum.leastheight import least_height
from tmmcalc.cams.optimum.margins import SLACK, margins
from tmmcalc.cams.optimum.options import changed, options, options_without, variants
from tmmcalc.cams.optimum.plane import Plane
from tmmcalc.cams.optimum.refusal import refusal
from tmmcalc.cams.optimum.relaxation import relaxations
from tmmcalc.cams.optimum.results import CamOptimum, Choice, Contour
from tmmcalc.cams.optimum.rocker import follower_of, four, rocker_contour, rocker_relaxations, smallest
from tmmcalc.cams.optimum.rockererrors import rocker_errors
from tmmcalc.cams.optimum.rockersizes import rocker_choice, rocker_scene
from tmmcalc.cams.optimum.scene import WHERE, Phases, Scene, scene_of
from tmmcalc.cams.optimum.section import section_of
from tmmcalc.cams.optimum.verdicts import optimum_notes
from tmmcalc.cams.optimum.wholesteps import Candidates, Found, search
from tmmcalc.cams.pressure.angle import reached
from tmmcalc.cams.task import CamTask, Optimum
from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.core.notes import Phrase

if TYPE_CHECKING:
    from tmmcalc.machine.motion import Motion

FEW = 24  # candidates that are judged at a time


def solve_optimum(
    task: CamTask, follower: Follower, phases: Phases | None = None, *, motion: Motion | None = None
) -> CamOptimum:
    """The lowest mechanism, its blocking contours, what relaxing buys, and the options compared.

    ``follower`` gives its kind and offset; ``phases``, in place of the task's own, is what of the turn is examined:
    all of it, or, as in the textbook, the rise alone. The speed is that of the machine if it is known.
    Raises `UsageError` for a groove, without loads, and for too many options; `NoSolutionError`, which names
    the constraints, where no sizes keep them all, whatever the option. Where an option has a solution and what is asked
    has none, the result is that of the lowest option.
    """
    task = task.at_speed(motion)
    _check(task, follower)
    asked = Optimum() if task.optimum is None else task.optimum
    phases = asked.phases if phases is None else phases
    named = variants(task, asked)
    try:
        return _solved(task, follower, asked, phases)
    except NoSolutionError as fault:
        if not named:
            raise
        return _lowest_option(task, follower, asked, phases, fault)


def _lowest_option(
    task: CamTask, follower: Follower, asked: Optimum, phases: Phases, fault: NoSolutionError
) -> CamOptimum:
    """The result of the lowest option, with the table of all; raises ``fault`` if none has a solution."""
    given = options_without(task, follower, fault.message, asked, phases)
    solved = [k for k, each in enumerate(given) if not each.refused]
    if not solved:
        raise NoSolutionError(
            f"{fault.message}; no option has a solution either ({len(given) - 1} tried)",
            where=fault.where,
            value=fault.value,
            limit=fault.limit,
            remedy=fault.remedy,
        )
    best = min(solved, key=lambda k: given[k].least)
    alone = replace(asked, laws=(), safeties=(), contacts=(), roller_ratios=())
    other = replace(changed(task, variants(task, asked)[best - 1]), optimum=alone)
    found = _solved(other, follower, alone, phases)
    note = Phrase(
        "warning: as asked there is no mechanism: {message}; all else is of the option {name}",
        message=fault.message,
        name=given[best].name,
    )
    return replace(
        found,
        options=tuple(given),
        refused=fault.message,
        shown=given[best].changes,
        notes=(note, *found.notes),
    )


def _solved(task: CamTask, follower: Follower, asked: Optimum, phases: Phases) -> CamOptimum:
    """The result as asked, with its options; raises as `solve_optimum` does."""
    if follower.kind == "oscillating":
        return _rocker(task, follower, asked, phases)
    scene = scene_of(task, follower, phases)
    if follower.kind == "flat":
        return _flat(task, follower, scene, asked, phases)
    found, known = search(scene, asked)
    if found is None:
        raise refusal(scene, asked, known.far)
    best = found.best
    order = np.argsort(-np.min(found.margin, axis=0), kind="stable")
    chosen = choice_of(scene, float(found.start[best]), float(found.roller[best]), found.height)
    lowest = least_height(scene, chosen.start, chosen.roller, chosen.height)
    least = choice_of(scene, lowest.start, lowest.roller, lowest.height)
    top = task.guide.top
    theta = reached(task, replace(follower, start=chosen.start, roller=chosen.roller))
    return CamOptimum(
        kind=follower.kind,
        phases=phases,
        step=asked.step,
        height_step=asked.height_step,
        stiffness=scene.spring.stiffness,
        preload=scene.spring.preload,
        safety=scene.spring.reached,
        offset=follower.sense * follower.offset + 0.0,
        theta=(abs(theta[0].worst.value), abs(theta[1].worst.value)),
        chosen=chosen,
        start=found.start[order],
        roller=found.roller[order],
        margin=np.min(found.margin, axis=0)[order],
        examined=known.examined,
        excluded=known.examined - len(known.start),
        passed=tuple(known.passed.items()),
        course=found.course,
        least=least,
        asked=top,
        contours=tuple(_contours(scene, found, known, least, top)),
        relaxations=tuple(relaxations(scene, least)),
        options=tuple(options(task, scene, chosen, least, asked, phases)),
        section=section_of(scene, chosen),
        flat=None,
        notes=tuple(optimum_notes(task, scene, chosen, least, theta)),
        error=optimum_errors(task, follower, phases, scene, chosen, least),
    )


def _flat(task: CamTask, follower: Follower, scene: Scene, asked: Optimum, phases: Phases) -> CamOptimum:
    """The same of a flat-faced follower, whose only size is S0."""
    top, start, examined, course = flatface.steps(scene, asked.step, asked.height_step)
    designs = [flatface.choice_of(scene, each, top) for each in start.tolist()]
    designs.sort(key=lambda each: -each.worst.margin)
    least = flatface.choice_of(scene, *flatface.lowest(scene))
    return CamOptimum(
        kind="flat",
        phases=phases,
        step=asked.step,
        height_step=asked.height_step,
        stiffness=scene.spring.stiffness,
        preload=scene.spring.preload,
        safety=scene.spring.reached,
        offset=None,
        theta=None,
        chosen=designs[0],
        start=np.array([each.start for each in designs]),
        roller=np.zeros(len(designs)),
        margin=np.array([each.worst.margin for each in designs]),
        examined=examined,
        excluded=examined - len(designs),
        passed=(),
        course=course,
        least=least,
        asked=task.guide.top,
        contours=(),
        relaxations=tuple(flatface.relaxations(scene, least)),
        options=tuple(options(task, scene, designs[0], least, asked, phases)),
        section=None,
        flat=flatface.chart(scene),
        notes=tuple(optimum_notes(task, scene, designs[0], least, ())),
        error=optimum_errors(task, follower, phases, scene, designs[0], least),
    )


def _rocker(task: CamTask, follower: Follower, asked: Optimum, phases: Phases) -> CamOptimum:
    """The same of a rocker: in place of height, start distance and guide stand l0, R0 and l2."""
    of = rocker_scene(task, follower, phases)
    scene, found = of.scene, smallest(of, asked)
    steps = found.steps
    chosen, least = (rocker_choice(of, four(each)) for each in (steps.sizes[:, 0], found.least))
    theta = reached(task, follower_of(follower, chosen))
    return CamOptimum(
        kind=follower.kind,
        phases=phases,
        step=asked.step,
        height_step=asked.step,
        stiffness=scene.spring.stiffness,
        preload=scene.spring.preload,
        safety=scene.spring.reached,
        offset=None,
        theta=(abs(theta[0].worst.value), abs(theta[1].worst.value)),
        chosen=chosen,
        start=steps.sizes[1],
        roller=steps.sizes[2],
        margin=np.min(steps.margin, axis=0),
        examined=steps.examined,
        excluded=steps.excluded,
        passed=(),
        course=steps.course,
        least=least,
        asked=None,
        contours=(rocker_contour(of, found),),
        relaxations=tuple(rocker_relaxations(of, asked, found.least)),
        options=tuple(options(task, scene, chosen, least, asked, phases)),
        section=None,
        flat=None,
        notes=tuple(optimum_notes(task, scene, chosen, least, theta)),
        error=rocker_errors(task, follower, phases, of, chosen, least),
        length=steps.sizes[0],
    )


def _check(task: CamTask, follower: Follower) -> None:
    if task.asked.closure == "groove":
        raise UsageError(
            "the optimal design is that of force closure: in a groove the roller slips wherever R changes its sign",
            where=WHERE,
            remedy="closure = 'force'; or leave [cam.optimum] out",
        )


def _contours(scene: Scene, found: Found, known: Candidates, least: Choice, top: float | None) -> Iterator[Contour]:
    """At the height of the spec, if it is high enough, and at the least one in steps."""
    if top is not None:
        seeds = _feasible(scene, known, least, top)
        if seeds[0].size:
            yield contour(Plane(scene, top), seeds)
    if top is None or abs(top - found.height) > SLACK:
        yield contour(Plane(scene, found.height), (found.start, found.roller))


def _feasible(scene: Scene, known: Candidates, least: Choice, top: float) -> tuple[Values, Values]:
    """The outermost of what is feasible at this height: candidates, and the sizes of the lowest mechanism.

    They span the box of all of it. From every side the first that holds is looked for, a few at a time.
    """
    rows = np.flatnonzero((known.least <= top) & (known.most >= top))
    start, roller = np.append(known.start[rows], least.start), np.append(known.roller[rows], least.roller)
    holds, judged = np.zeros(len(start), bool), np.zeros(len(start), bool)
    for inwards in (start, -start, roller, -roller):
        order = np.argsort(inwards, kind="stable")
        for first in range(0, len(order), FEW):
            part = order[first : first + FEW]
            new = part[~judged[part]]
            if new.size:
                judged[new] = True
                holds[new] = np.all(margins(scene, start[new], roller[new], np.full(len(new), top)) >= -SLACK, axis=0)
            if holds[part].any():
                break
    return start[holds], roller[holds]
