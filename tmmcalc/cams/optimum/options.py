"""The design game: other laws, springs, materials and rollers, each with its own lowest mechanism, in one table.

A change is one of these in place of what the task asks for. The game tries every change alone, or all combinations.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from functools import partial, reduce
from itertools import product
from math import prod
from typing import Any

import numpy as np

from tmmcalc.cams.follower import Follower
from tmmcalc.cams.forces.formulas import cam_torque
from tmmcalc.cams.laws.catalogue import law_of
from tmmcalc.cams.optimum import flatface
from tmmcalc.cams.optimum.leastheight import QUICK, REGION, least_heights
from tmmcalc.cams.optimum.margins import NUMBERS, judge
from tmmcalc.cams.optimum.peaks import largest
from tmmcalc.cams.optimum.results import ACTIVE, Choice, Option
from tmmcalc.cams.optimum.rocker import four, smallest
from tmmcalc.cams.optimum.rockersizes import RockerScene, Sizes, judge_rocker, rocker_choice, rocker_scene, turn_of
from tmmcalc.cams.optimum.scene import WHERE, Phases, Scene, guided_at, scene_of
from tmmcalc.cams.optimum.wholesteps import search
from tmmcalc.cams.program import Program
from tmmcalc.cams.task import CamTask, Optimum
from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.core.notes import Phrase
from tmmcalc.core.progress import tell
from tmmcalc.core.records import record

MOST = 60  # mechanisms in one game


@record
class Change:
    """One thing that differs from what is asked."""

    words: str
    made: Callable[[CamTask], CamTask]  # the task with it


def with_law(task: CamTask, name: str) -> CamTask:
    """The task with this law on rise and return; raises `UsageError` for a law that is not known."""
    law = law_of(name)
    phases = tuple(replace(phase, law=law) if phase.moves else phase for phase in task.program.phases)
    return replace(task, program=Program(phases))


def with_safety(task: CamTask, safety: float) -> CamTask:
    """The task with a spring that is sized by this safety K1 of the contact."""
    if task.loads is None:
        return task
    spring = replace(task.loads.spring, method="safety", safety=safety)
    return replace(task, loads=replace(task.loads, spring=spring))


def with_contact(task: CamTask, stress: float) -> CamTask:
    """The task with another allowed contact stress [Pa]."""
    return replace(task, requirements=replace(task.requirements, contact=stress))


def with_ratio(task: CamTask, ratio: float) -> CamTask:
    """The task with another least radius of the roller over that of its pin."""
    return replace(task, requirements=replace(task.requirements, roller_ratio=ratio))


def changes(task: CamTask, asked: Optimum) -> list[list[Change]]:
    """The changes of every kind that is asked for, without those that leave all as it is."""
    kept = _asked_values(task)
    found = [
        [
            Change(Phrase("law {name}", name=name), partial(with_law, name=name))
            for name in asked.laws
            if name != kept["law"]
        ],
        [
            Change(Phrase("safety {k:g}", k=k), partial(with_safety, safety=k))
            for k in asked.safeties
            if k != kept["safety"]
        ],
        [
            Change(_called("contact", name, f"{1e-6 * stress:g} MPa"), partial(with_contact, stress=stress))
            for name, stress in asked.contacts
            if stress != kept["allowed"]
        ],
        [
            Change(_called("roller", name, f"{ratio:g}"), partial(with_ratio, ratio=ratio))
            for name, ratio in asked.roller_ratios
            if ratio != kept["ratio"]
        ],
    ]
    return [kind for kind in found if kind]


def _called(kind: str, name: str, value: str) -> str:
    what = Phrase("{kind} {name}", kind=kind, name=name or value)
    return Phrase("{what} ({value})", what=what, value=value) if name else what


def variants(task: CamTask, asked: Optimum) -> list[tuple[Change, ...]]:
    """Sets of changes, without that of none.

    Raises `UsageError` for more than MOST of them.
    """
    kinds = changes(task, asked)
    count = prod(len(kind) + 1 for kind in kinds) if asked.combine else 1 + sum(len(kind) for kind in kinds)
    if count > MOST:
        raise UsageError(
            f"{count} mechanisms are too many for one design game",
            where=WHERE,
            value=count,
            limit=MOST,
            remedy="fewer options in [cam.optimum]" + (", or combine = false" if asked.combine else ""),
        )
    if not asked.combine:
        return [(change,) for kind in kinds for change in kind]
    every = product(*([None, *kind] for kind in kinds))
    return [found for one in every if (found := tuple(change for change in one if change is not None))]


def options(
    task: CamTask, scene: Scene, chosen: Choice, least: Choice, asked: Optimum, phases: Phases
) -> Iterator[Option]:
    """What is asked, then the lowest mechanism of every variant; nothing if no option is named."""
    found = variants(task, asked)
    if not found:
        return
    if scene.follower.kind == "oscillating":
        yield _rocker_option((), task, rocker_scene(task, scene.follower, phases), chosen, least)
    else:
        sizes = (chosen.start, chosen.roller, chosen.height)
        yield _option((), task, scene, sizes, least.height, least.active)
    yield from _others(task, scene.follower, asked, phases)


def options_without(task: CamTask, follower: Follower, why: str, asked: Optimum, phases: Phases) -> list[Option]:
    """The same where what is asked is refused, which is the first of them."""
    return [_refused((), task, None, why), *_others(task, follower, asked, phases)]


def changed(task: CamTask, what: Iterable[Change]) -> CamTask:
    """The task with changes."""
    return reduce(lambda made, change: change.made(made), what, task)


def _others(task: CamTask, follower: Follower, asked: Optimum, phases: Phases) -> Iterator[Option]:
    found = variants(task, asked)
    for k, what in enumerate(found):
        words = tuple(change.words for change in what)
        tell(k / len(found), f"design game, {k + 1} of {len(found)}: {', '.join(words)}")
        yield _variant(words, changed(task, what), follower, asked, phases)


def _variant(words: tuple[str, ...], task: CamTask, follower: Follower, asked: Optimum, phases: Phases) -> Option:
    """The lowest mechanism of a task; refused where there is none."""
    scene = None
    try:
        if follower.kind == "oscillating":
            of = rocker_scene(task, follower, phases)
            scene, both = of.scene, smallest(of, asked)
            mechanism, smaller = (rocker_choice(of, four(each)) for each in (both.steps.sizes[:, 0], both.least))
            return _rocker_option(words, task, of, mechanism, smaller)
        scene = scene_of(task, follower, phases)
        if follower.kind == "flat":
            top, starts, *_ = flatface.steps(scene, asked.step, asked.height_step)
            designs = [flatface.choice_of(scene, each, top) for each in starts.tolist()]
            best = max(designs, key=lambda each: each.worst.margin)
            least = flatface.choice_of(scene, *flatface.lowest(scene))
            return _option(words, task, scene, (best.start, 0.0, top), least.height, least.active)
        found, _ = search(scene, asked)
    except NoSolutionError as fault:
        return _refused(words, task, scene, fault.message)
    if found is None:
        return _refused(words, task, scene, "no sizes keep all constraints")
    start, roller = float(found.start[found.best]), float(found.roller[found.best])
    (lowest,) = least_heights([scene], (start, roller, found.height), REGION, QUICK)
    active = tuple(n for n, margin in zip(NUMBERS, lowest.margin.tolist(), strict=True) if margin < ACTIVE)
    return _option(words, task, scene, (start, roller, found.height), lowest.height, active)


def _option(
    words: tuple[str, ...],
    task: CamTask,
    scene: Scene,
    sizes: tuple[float, float, float],
    least: float,
    active: tuple[int, ...],
) -> Option:
    """What there is to say of a mechanism of S0, r2 and H2 in whole steps."""
    start, roller, height = sizes
    if scene.follower.kind == "flat":
        choice = flatface.choice_of(scene, start, height)
        stress = next((each.value or 0.0 for each in choice.checks if each.number == 9), 0.0)
        contact = flatface.largest_force(scene, choice)
    else:
        values = judge(scene, *(np.array([size]) for size in sizes))
        stress, contact = float(values.stress[0]), float(values.contact[0])
    torque, driving = torques(scene, start, roller, height)
    return Option(
        changes=words,
        **_asked_values(task),
        height=height,
        start=start,
        roller=roller,
        least=least,
        active=active,
        stress=stress,
        contact=contact,
        torque=torque,
        driving=driving,
        stiffness=scene.spring.stiffness,
        preload=scene.spring.preload,
        refused="",
    )


def _rocker_option(words: tuple[str, ...], task: CamTask, of: RockerScene, choice: Choice, least: Choice) -> Option:
    """What there is to say of a rocker in whole steps."""
    scene = of.scene
    one = Sizes(*(np.array([size]) for size in (choice.length, choice.start, choice.roller, choice.height)))
    values, turn = judge_rocker(of, one).shared, turn_of(of, one)
    contact = scene.rows.force / turn.useful[0]
    driving = cam_torque(contact, np.cos(turn.theta[0]), scene.motion, choice.length)
    plus, minus, given = largest(scene.by_panel(np.stack((scene.torque, -scene.torque, driving)))).tolist()
    return Option(
        changes=words,
        **_asked_values(task),
        height=choice.height,
        start=choice.start,
        roller=choice.roller,
        least=least.height,
        active=least.active,
        stress=float(values.stress[0]),
        contact=float(values.contact[0]),
        torque=max(plus, minus),
        driving=given,
        stiffness=scene.spring.stiffness,
        preload=scene.spring.preload,
        refused="",
        length=choice.length,
    )


def _refused(words: tuple[str, ...], task: CamTask, scene: Scene | None, why: str) -> Option:
    return Option(
        changes=words,
        **_asked_values(task),
        height=0.0,
        start=0.0,
        roller=0.0,
        least=0.0,
        active=(),
        stress=0.0,
        contact=0.0,
        torque=0.0,
        driving=0.0,
        stiffness=0.0 if scene is None else scene.spring.stiffness,
        preload=0.0 if scene is None else scene.spring.preload,
        refused=why,
    )


def _asked_values(task: CamTask) -> dict[str, Any]:
    """Law, safety, allowed stress and roller of a task, by the names of the fields."""
    need, spring = task.requirements, None if task.loads is None else task.loads.spring
    return {
        "law": " and ".join(dict.fromkeys(p.law.name for p in task.program.phases if p.law is not None)),
        "safety": spring.safety if spring is not None and spring.method == "safety" else None,
        "allowed": need.contact,
        "ratio": None if task.asked.kind == "flat" else need.roller_ratio,
    }


def torques(scene: Scene, start: float, roller: float, top: float) -> tuple[float, float]:
    """Largest |T| of P_c S' (5.75), and the largest driving torque, friction of the guide included [N*m]."""
    on = guided_at(scene, *np.array([[start], [roller], [top]]))
    driving = cam_torque(on.contact, on.cosine, scene.motion)[0]
    rows = np.stack((scene.torque, -scene.torque, driving))
    plus, minus, given = largest(scene.by_panel(rows)).tolist()
    return max(plus, minus), given
